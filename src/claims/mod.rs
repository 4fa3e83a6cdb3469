//! Published statements -> verdicts: the ledger of claims, judged by rows alone.
//!
//! A paper is a file in `configs/published/`. A claim names series of rows (experiment, filter, column, key),
//! formulas over them, and bounds; all of them must hold:
//!
//! ```text
//! rows ─> series (by key, with intervals) ─> formula ─> figure [low, high] ─> bound ─> verdict
//! ```
//! Every figure carries its interval through the formula, corrected for the number of a claim's parts
//! (Holm). A claim is judged under each condition that its rows have, for instance each order, and on
//! each machine, unless it is about the difference of machines.

mod bound;
mod claim;
mod conditions;
mod csv;
mod embedded;
mod estimate;
mod evaluate;
mod expression;
mod function;
mod holm;
mod judge;
mod lack;
mod ledger;
mod reductions;
mod select;
mod series;
mod straight;
#[cfg(test)]
mod tests;
mod words;

pub use self::csv::to_csv;
pub use claim::{Claim, Part, SeriesOf};
pub use judge::judge;
pub use ledger::{Ledger, LedgerError};
pub use words::headline;

use serde::Serialize;

/// What rows say of a published statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Every part holds, its whole interval on the right side of the bound.
    Reproduced,
    /// At least one part does not hold, its whole interval on the wrong side.
    NotReproduced,
    /// An interval straddles its bound, or the rows lack what would decide.
    Undecided,
    /// No experiment of this program can decide it; `details` says why.
    NotTestable,
}

impl Verdict {
    /// The word in the column `verdict`.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Reproduced => "reproduced",
            Verdict::NotReproduced => "not-reproduced",
            Verdict::Undecided => "undecided",
            Verdict::NotTestable => "not-testable",
        }
    }
}

/// A claim judged under one condition: a row of `claims.csv`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// Id of the claim, for instance `B-4.1a`.
    pub id: String,
    /// Where it is made, for instance `thesis B, table 4.1`.
    pub source: String,
    /// The statement, in our words.
    pub statement: String,
    /// The published figure of the part that `measured` is about, as text; empty if none is printed.
    pub published: String,
    /// The figure of the part that fails by the most, in units of its bound, or is closest to failing.
    /// Parts without an interval come last among those that hold.
    pub measured: Option<f64>,
    /// Lower end of its interval, corrected for the number of the claim's parts.
    pub low: Option<f64>,
    /// Upper end of it.
    pub high: Option<f64>,
    /// What the rows have in common that it was judged by: an order (`literal`), with several
    /// machines the machine as well (`literal, AMD EPYC`); empty where no clock is involved.
    pub condition: String,
    /// The verdict under this condition.
    pub verdict: Verdict,
    /// All parts with figures and intervals; the sentence that explains a reversal; what would decide
    /// an undecided one.
    pub details: String,
    /// Whether this condition is the one that the claim itself is about.
    #[serde(skip)]
    pub decides: bool,
}

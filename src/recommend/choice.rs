//! The choice with the rows that it rests on, for whoever shows it in a way of its own.

use super::RecommendError;
use super::arena::Ranked;
use super::because::sentences;
use super::evidence::{Leaks, error, leaks};
use super::found::{Cost, find};
use super::question::{KnownVariant, Question};
use crate::results::Results;
use crate::table::Row;

/// The variant to take.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice<'a> {
    /// Its time.
    pub row: &'a Row,
    /// The best form of another kernel in the same place; none where no other fits.
    pub other_kernel: Option<Behind<'a>>,
    /// Absolute error of a weight, 99th percentile over random hits; `None` where no row tells.
    pub error: Option<f64>,
    /// Rays that it loses at closed meshes, and of how many; `None` where no row counts them.
    pub leaks: Option<(u64, u64)>,
    /// Sentences with figures and rows, the weightiest first.
    pub because: Vec<String>,
}

/// What comes behind the choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Behind<'a> {
    /// Its time.
    pub row: &'a Row,
    /// How much longer it takes, as a share of the choice's time.
    pub share: f64,
    /// Lower and upper end of that.
    pub interval: (f64, f64),
    /// What copies of one kernel differ by there, as a share of their time.
    pub floor: f64,
    /// Whether rows can tell the two apart.
    pub is_slower: bool,
}

impl<'a> Behind<'a> {
    fn of(other: &Ranked<'a>, best: &Ranked<'a>) -> Self {
        let cost = Cost::of(other, best);
        Behind {
            row: other.candidate.row,
            share: cost.share,
            interval: (cost.low, cost.high),
            floor: cost.floor,
            is_slower: cost.is_measurable,
        }
    }
}

/// What [`recommend`](super::recommend) names, by the rows of one machine, or by all.
///
/// # Errors
/// Where there are no times, or nothing that was timed fits.
pub fn choose<'a>(
    results: &'a Results,
    machine: Option<&str>,
    question: &'a Question,
    known: &'a [KnownVariant],
) -> Result<Choice<'a>, RecommendError> {
    let found = find(results, machine, question, known)?;
    let best = found.best();
    Ok(Choice {
        row: best.candidate.row,
        other_kernel: found.other_kernel().map(|(_, other)| Behind::of(other, best)),
        error: error(&found.rows, best.candidate.row).map(|(error, _)| error),
        leaks: match leaks(&found.rows, best.candidate.row) {
            Leaks::Counted(lost, rays, _) => Some((lost, rays)),
            Leaks::NobodyLooked | Leaks::Unknown => None,
        },
        because: sentences(&found),
    })
}

//! For every claim that can be tested figures with which it holds, and a change that undoes it.

mod others;
mod thesis_b;

use super::made::Cells;
use crate::claims::Verdict;

/// Figures with a known answer.
pub struct Case {
    /// The claim.
    pub id: &'static str,
    /// Figures with which all its parts hold.
    pub holds: Cells,
    /// What is changed so that one does not.
    pub change: Cells,
    /// The verdict of the first.
    pub first: Verdict,
    /// The verdict with the change.
    pub changed: Verdict,
}

const fn case(id: &'static str, holds: Cells, change: Cells) -> Case {
    Case { id, holds, change, first: Verdict::Reproduced, changed: Verdict::NotReproduced }
}

/// All cases, in the order of the ledger.
pub fn cases() -> impl Iterator<Item = &'static Case> {
    thesis_b::CASES.iter().chain(others::CASES)
}

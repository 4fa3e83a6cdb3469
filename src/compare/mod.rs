//! Two results side by side: what got slower, what got less exact, and whether they can be
//! compared at all.
//!
//! ```text
//! two Sides ─> cells that both have ─> may they be compared? ─> time, exactness ─> Comparison
//! ```
//! Judged are the rows alone. Nanoseconds never are: they change with the clock of the processor.
//! Neither are the columns `latency_*` and `cold_*`: they have no halves of the rounds, and without
//! those nothing is confirmed. What stands in no row, such as an operation count, has tests.

mod cell;
mod comparable;
mod exactness;
mod finding;
mod group;
mod side;
#[cfg(test)]
mod tests;
mod threshold;
mod time;

pub use finding::{Finding, Place, Refusal, Verdict};
pub use side::{InputError, Side, Source};
pub use threshold::{Threshold, ThresholdError};

use cell::Matched;
use finding::Judged;
use group::References;
use serde::Serialize;

/// What came of a comparison; as JSON, one object.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// The worst of what was found.
    pub verdict: Verdict,
    /// Changes of time up to this are none, percent.
    pub threshold_percent: f64,
    /// Cells that both have.
    pub cells: usize,
    /// Cells among them whose time cannot be judged: not measured, or without cycles and ratio.
    pub not_judged: usize,
    /// Cells of the base that the new one lacks.
    #[serde(serialize_with = "count")]
    pub missing: Vec<Place>,
    /// Cells of the new one that the base lacks.
    #[serde(serialize_with = "count")]
    pub added: Vec<Place>,
    /// What got worse, the worst first.
    pub regressions: Vec<Finding>,
    /// What got better, the largest change first.
    pub improvements: Vec<Finding>,
    /// Times of which neither a change nor its absence can be told.
    pub unresolved: Vec<Finding>,
    /// Why the two cannot be compared. If there is any, nothing was judged.
    pub refused: Vec<Refusal>,
}

fn count<S: serde::Serializer>(places: &[Place], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_u64(places.len() as u64)
}

/// Compares `new` with `base`.
pub fn compare(base: &Side, new: &Side, threshold: Threshold) -> Comparison {
    let matched = Matched::of(base, new);
    let mut comparison = Comparison {
        verdict: Verdict::Same,
        threshold_percent: threshold.percent(),
        cells: matched.pairs.len(),
        not_judged: 0,
        missing: matched.missing.iter().map(|row| Place::of(row)).collect(),
        added: matched.added.iter().map(|row| Place::of(row)).collect(),
        regressions: Vec::new(),
        improvements: Vec::new(),
        unresolved: Vec::new(),
        refused: comparable::refusals(base, new, &matched),
    };
    if comparison.refused.is_empty() {
        judge(&mut comparison, base, new, &matched, threshold);
    }
    comparison.verdict = verdict(&comparison);
    comparison
}

fn judge(
    comparison: &mut Comparison,
    base: &Side,
    new: &Side,
    matched: &Matched<'_>,
    threshold: Threshold,
) {
    let references = References::of(base, new, &matched.pairs);
    for (old_row, new_row) in &matched.pairs {
        // The row of a price repeats the figures of its listing.
        if old_row.price.is_some() || new_row.price.is_some() {
            comparison.not_judged += 1;
            continue;
        }
        let time = time::judge(old_row, new_row, &references, threshold);
        comparison.not_judged += usize::from(time.is_none());
        let place = Place::of(new_row);
        for judged in exactness::judge(old_row, new_row).into_iter().chain(time) {
            match judged {
                Judged::Worse(change) => comparison.regressions.push(change.at(&place)),
                Judged::Better(change) => comparison.improvements.push(change.at(&place)),
                Judged::Unresolved(change) => comparison.unresolved.push(change.at(&place)),
                Judged::Same => {}
            }
        }
    }
    for findings in
        [&mut comparison.regressions, &mut comparison.improvements, &mut comparison.unresolved]
    {
        findings.sort_by(|a, b| b.size().total_cmp(&a.size()));
    }
}

fn verdict(comparison: &Comparison) -> Verdict {
    let any = [
        (comparison.refused.is_empty(), Verdict::Refused),
        (comparison.regressions.is_empty(), Verdict::Regressed),
        (comparison.unresolved.is_empty(), Verdict::Unresolved),
        (comparison.improvements.is_empty(), Verdict::Improved),
    ];
    any.into_iter().find(|(empty, _)| !empty).map_or(Verdict::Same, |(_, verdict)| verdict)
}

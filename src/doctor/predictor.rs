//! How large a replayed set the branch predictor remembers.

use super::ward::{DoctorError, Ward};
use crate::experiment::Bench;
use crate::job::{Block, Job};
use crate::measure::{Clock, Role};
use crate::stats::median;
use crate::workload::Pcg;

/// Smallest set: no predictor of this century forgets it.
const SMALLEST: usize = 256;

/// Largest set.
const LARGEST: usize = 1 << 17;

/// Passes over each set of which the median is taken, after one that teaches it.
const PASSES: usize = 7;

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Predictor {
    /// Sizes of the sets and ns of a test when they are replayed, ascending.
    pub replayed: Vec<(usize, f64)>,
    /// ns of a test over sets that were never seen in that order.
    pub unforeseen_ns: f64,
    /// Largest set that is remembered; `None` if prediction costs this kernel nothing here.
    pub tests: Option<usize>,
    /// Whether even the largest set was remembered, so that the true size may be larger.
    pub or_more: bool,
}

/// Replays ever larger sets of pairs with the reference kernel, leaving early.
///
/// # Errors
/// When the reference cannot be measured.
pub fn predictor(bench: &mut Bench<'_>) -> Result<Predictor, DoctorError> {
    let ward = Ward::with_pairs(LARGEST)?;
    let mut contestant = ward.reference(Role::Subject)?;
    let job = contestant.job.as_mut();
    let sizes = std::iter::successors(Some(SMALLEST), |size| Some(size * 2));
    let mut replayed = Vec::new();
    for size in sizes.take_while(|size| *size <= LARGEST) {
        replayed.push((size, replayed_ns(job, size, bench.clock)));
    }
    let unforeseen_ns = unforeseen_ns(job, bench.clock);
    Ok(judged(replayed, unforeseen_ns))
}

/// Median ns of a test over the first `size` pairs, which were just run twice.
fn replayed_ns(job: &mut dyn Job, size: usize, clock: &mut dyn Clock) -> f64 {
    // Small sets several times a pass, so that a pass is long against the clock's reading.
    let repeats = (4096 / size).max(1);
    let block = Block { first: 0, items: size, repeats, literal: false };
    let mut passes = Vec::with_capacity(PASSES);
    for pass in 0..PASSES + 2 {
        let start = clock.now_ns();
        std::hint::black_box(job.run(block));
        let ns = clock.now_ns().saturating_sub(start);
        if pass >= 2 {
            passes.push(ns as f64 / (size * repeats) as f64);
        }
    }
    median(&passes).unwrap_or(0.0)
}

/// Median ns of a test over 4096 pairs in orders of their own.
fn unforeseen_ns(job: &mut dyn Job, clock: &mut dyn Clock) -> f64 {
    let mut pcg = Pcg::new(20_261_122);
    let items = job.items() as u32;
    let block = Block { first: 0, items: 4096.min(job.items()), repeats: 1, literal: false };
    let mut passes = Vec::with_capacity(PASSES);
    for _ in 0..PASSES {
        job.permute(&pcg.permutation(items));
        let start = clock.now_ns();
        std::hint::black_box(job.run(block));
        let ns = clock.now_ns().saturating_sub(start);
        passes.push(ns as f64 / block.items as f64);
    }
    median(&passes).unwrap_or(0.0)
}

/// Half way between remembered and unforeseen, in terms of ratios, a set counts as forgotten.
fn judged(replayed: Vec<(usize, f64)>, unforeseen_ns: f64) -> Predictor {
    let remembered_ns = replayed.first().map_or(0.0, |(_, ns)| *ns);
    let half_way = (remembered_ns * unforeseen_ns).sqrt();
    // Prediction must cost more than a tenth to be told from noise.
    let matters = unforeseen_ns > 1.1 * remembered_ns && remembered_ns > 0.0;
    let known: Vec<usize> =
        replayed.iter().take_while(|(_, ns)| *ns <= half_way).map(|(size, _)| *size).collect();
    let or_more = matters && known.len() == replayed.len();
    let tests = if matters { known.last().copied() } else { None };
    Predictor { replayed, unforeseen_ns, tests, or_more }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cliff_is_where_time_leaves_the_floor() {
        let sweep = [(256, 4.0), (512, 4.1), (1024, 4.0), (2048, 9.5), (4096, 18.0), (8192, 20.0)];
        let found = judged(sweep.to_vec(), 20.0);
        assert_eq!((found.tests, found.or_more), (Some(1024), false));
        // A set that is fast by chance behind the cliff does not count.
        let sweep = [(256, 4.0), (512, 15.0), (1024, 4.0)];
        assert_eq!(judged(sweep.to_vec(), 20.0).tests, Some(256));
    }

    #[test]
    fn without_a_cliff_there_is_more_or_nothing() {
        let flat = [(256, 4.0), (512, 4.1), (1024, 4.0)];
        let found = judged(flat.to_vec(), 20.0);
        assert_eq!((found.tests, found.or_more), (Some(1024), true));
        let found = judged(flat.to_vec(), 4.2);
        assert_eq!((found.tests, found.or_more), (None, false));
    }
}

//! What windows differ by, taken out of the samples.
//!
//! The windows that a set is cut into hold other items, which take other times. Among samples of
//! all windows that would be noise, and which rounds were dropped would move the median. So each
//! sample is scaled from the median of its window to the time of a whole pass: what is left is what
//! blocks of the same work differ by. (Adding up the blocks of a pass would do as well, were it not
//! for outliers: a sum of five blocks is spoilt five times as often as a block.)

use super::runner::Runner;
use super::sample::Sample;
use crate::stats::median;

/// Visits of a window from which on its median is taken for what it takes. The intervals are those
/// of independent samples; with eight visits they are too narrow by a sixteenth at most (one of
/// eight degrees of freedom is spent), with the dozens that are usual by a hundredth.
pub(super) const LEAST_VISITS: usize = 8;

/// Levels the samples of one contestant, if each of its windows was visited often enough.
pub(super) fn level(runner: &mut Runner<'_>) {
    let windows = runner.plan.windows;
    if windows < 2 {
        return;
    }
    let ns_per_test = |window: usize| {
        let of = runner.samples.iter().filter(|sample| sample.window == window);
        let times: Vec<f64> = of.map(Sample::ns_per_test).collect();
        median(&times).filter(|_| times.len() >= LEAST_VISITS)
    };
    let Some(of_window) = (0..windows).map(ns_per_test).collect::<Option<Vec<f64>>>() else {
        return;
    };
    let tests = |window: usize| runner.tests(window) as f64;
    let pass_ns: f64 = (0..windows).map(|window| of_window[window] * tests(window)).sum();
    let pass = pass_ns / (0..windows).map(tests).sum::<f64>();
    for sample in &mut runner.samples {
        sample.share_of_pass = pass / of_window[sample.window];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::contestant::{Contestant, Role};
    use crate::measure::scripted::{Script, ScriptedJob};

    fn block(window: usize, ns: u64) -> Sample {
        Sample {
            ns,
            tests: 4,
            at_ns: 0,
            window,
            counts: None,
            ns_per_cycle: None,
            crowded: false,
            share_of_pass: 1.0,
        }
    }

    /// ns per test after blocks of these windows and times, of 8 items in 2 windows.
    fn levelled(blocks: &[(usize, u64)]) -> Vec<f64> {
        let script = Script::default();
        let job = Box::new(ScriptedJob::new(&script, 8, 1));
        let mut contestant = Contestant::new("one", Role::Reference, job);
        let mut runner = Runner::new(&mut contestant);
        runner.plan.windows = 2;
        runner.samples = blocks.iter().map(|&(window, ns)| block(window, ns)).collect();
        level(&mut runner);
        runner.samples.iter().map(Sample::ns_per_test).collect()
    }

    #[test]
    fn windows_of_other_work_are_samples_of_one_pass() {
        let mut blocks: Vec<(usize, u64)> = (0..16).map(|round| (round % 2, 40)).collect();
        blocks.iter_mut().filter(|block| block.0 == 1).for_each(|block| block.1 = 80);
        // A round that was dropped, and one that took half as long again.
        blocks.push((1, 80));
        blocks.push((1, 120));
        let times = levelled(&blocks);
        // A pass is 120 ns for 8 tests.
        assert!(times[..17].iter().all(|time| (time - 15.0).abs() < 1e-12), "{times:?}");
        assert!((times[17] - 22.5).abs() < 1e-12);
    }

    #[test]
    fn a_window_that_was_hardly_visited_leaves_all_as_it_was() {
        let blocks: Vec<(usize, u64)> = (0..15).map(|round| (round % 2, 40)).collect();
        assert_eq!(levelled(&blocks), [10.0; 15]);
    }
}

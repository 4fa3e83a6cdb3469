//! Complete passes over a set that is cut into windows.
//!
//! Windows hold other items, which take other times: by themselves their blocks would differ by
//! that, and which of them were dropped would move the median. A whole pass is always the same work.

use super::counters::Counts;
use super::runner::{Runner, Sample};

/// Joins the blocks of a complete pass, one of each window, to one sample, where all contestants
/// share the windows and at least `least` passes are complete; otherwise leaves the samples as they
/// are. Returns how many blocks a sample is now.
pub(super) fn join(runners: &mut [Runner<'_>], windows: usize, least: usize) -> usize {
    let guide = runners.iter().find(|r| r.plan.windows == windows && !r.samples.is_empty());
    let Some(guide) = guide.filter(|_| windows > 1) else { return 1 };
    let mut rounds_of = vec![Vec::new(); windows];
    for (round, sample) in guide.samples.iter().enumerate() {
        rounds_of[sample.window].push(round);
    }
    let passes = rounds_of.iter().map(Vec::len).min().unwrap_or(0);
    if passes < least {
        return 1;
    }
    for runner in runners.iter_mut().filter(|r| !r.samples.is_empty()) {
        let joined = |pass: usize| {
            let blocks: Vec<Sample> =
                rounds_of.iter().map(|rounds| runner.samples[rounds[pass]]).collect();
            sum(&blocks)
        };
        runner.samples = (0..passes).map(joined).collect();
    }
    windows
}

/// Several blocks as one. Cycles are added, and so the length of a cycle is their mean over them.
fn sum(blocks: &[Sample]) -> Sample {
    let ns: u64 = blocks.iter().map(|block| block.ns).sum();
    let cycles: Option<f64> =
        blocks.iter().map(|block| Some(block.ns as f64 / block.ns_per_cycle?)).sum();
    let counts: Option<Vec<Counts>> = blocks.iter().map(|block| block.counts).collect();
    let added = |of: fn(&Counts) -> u64| counts.as_ref().map(|c| c.iter().map(of).sum());
    Sample {
        ns,
        tests: blocks.iter().map(|block| block.tests).sum(),
        window: 0,
        counts: counts.as_ref().map(|_| Counts {
            cycles: added(|c| c.cycles).unwrap_or(0),
            instructions: added(|c| c.instructions).unwrap_or(0),
            branch_misses: added(|c| c.branch_misses).unwrap_or(0),
        }),
        ns_per_cycle: cycles.map(|cycles| ns as f64 / cycles),
        crowded: blocks.iter().any(|block| block.crowded),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::contestant::{Contestant, Role};
    use crate::measure::scripted::{Script, ScriptedJob};

    fn block(window: usize, ns: u64) -> Sample {
        let ns_per_cycle = Some(if window == 0 { 0.5 } else { 0.25 });
        Sample { ns, tests: 10, window, counts: None, ns_per_cycle, crowded: false }
    }

    /// Two contestants, the second without windows of its own, after blocks of these windows.
    fn joined(windows: &[usize], least: usize) -> (usize, Vec<Vec<u64>>) {
        let script = Script::default();
        let job = || Box::new(ScriptedJob::new(&script, 8, 1));
        let mut one = Contestant::new("one", Role::Reference, job());
        let mut chain = Contestant::new("chain", Role::Chain, job());
        let mut runners = [Runner::new(&mut one), Runner::new(&mut chain)];
        runners[0].plan.windows = 2;
        for (round, &window) in windows.iter().enumerate() {
            runners[0].samples.push(block(window, 100 + 50 * window as u64));
            runners[1].samples.push(block(0, round as u64));
        }
        let blocks = join(&mut runners, 2, least);
        let times = |r: &Runner<'_>| r.samples.iter().map(|s| s.ns).collect();
        (blocks, runners.iter().map(times).collect())
    }

    #[test]
    fn a_pass_has_a_block_of_each_window_and_all_have_the_same() {
        // A round was dropped: the windows no longer alternate.
        let (blocks, times) = joined(&[0, 1, 1, 0, 1], 2);
        assert_eq!((blocks, times), (2, vec![vec![250, 250], vec![1, 3 + 2]]));
    }

    #[test]
    fn too_few_passes_are_left_apart() {
        let (blocks, times) = joined(&[0, 1, 1, 1], 2);
        assert_eq!(blocks, 1);
        assert_eq!(times[0], [100, 150, 150, 150]);
    }

    #[test]
    fn cycles_are_added() {
        let both = sum(&[block(0, 100), block(1, 150)]);
        // 200 cycles and 600.
        assert_eq!((both.ns, both.tests, both.ns_per_cycle), (250, 20, Some(250.0 / 800.0)));
    }
}

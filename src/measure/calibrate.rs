//! How often a block is repeated so that it is as long as wanted.

use super::clock::Clock;
use crate::job::{Block, Job, Tally};
use std::hint::black_box;

/// Most items that a block runs: where time stands still (code that was optimised away, a clock
/// that is stuck) the search ends here.
pub(super) const MOST_ITEM_RUNS: usize = 1 << 26;

/// Runs `block` and times it; nothing but the run is between the two readings.
pub(super) fn timed(job: &mut dyn Job, block: Block, clock: &mut dyn Clock) -> (u64, Tally) {
    let (ns, tally, _) = timed_until(job, block, clock);
    (ns, tally)
}

/// The same, with what the clock said at its end.
pub(super) fn timed_until(
    job: &mut dyn Job,
    block: Block,
    clock: &mut dyn Clock,
) -> (u64, Tally, u64) {
    let start = clock.now_ns();
    let tally = black_box(job.run(black_box(block)));
    let stop = clock.now_ns();
    (stop.saturating_sub(start), tally, stop)
}

/// One untimed pass over the items of `block`.
pub(super) fn warm_up(job: &mut dyn Job, block: Block) {
    black_box(job.run(Block { repeats: 1, ..block }));
}

/// The shortest of three runs of `block`, ns: disturbances only ever lengthen. Each after a
/// warm-up pass when the set is replayed.
pub(super) fn shortest_ns(job: &mut dyn Job, block: Block, clock: &mut dyn Clock) -> u64 {
    let mut shortest = u64::MAX;
    for _ in 0..3 {
        if !block.literal {
            warm_up(job, block);
        }
        shortest = shortest.min(timed(job, block, clock).0);
    }
    shortest
}

/// Repeats, at least `least`, with which `block` takes about `block_ns`: doubled until the clock
/// sees an eighth of it, scaled, verified twice.
pub(super) fn repeats(
    job: &mut dyn Job,
    mut block: Block,
    least: usize,
    block_ns: u64,
    clock: &mut dyn Clock,
) -> usize {
    let least = least.max(1);
    let most = (MOST_ITEM_RUNS / block.items.max(1)).max(least);
    block.repeats = least;
    let mut ns = shortest_ns(job, block, clock);
    while ns < block_ns / 8 && block.repeats < most {
        block.repeats = (block.repeats * 2).min(most);
        ns = shortest_ns(job, block, clock);
    }
    block.repeats = scaled(block.repeats, ns, block_ns).clamp(least, most);
    for _verification in 0..2 {
        ns = shortest_ns(job, block, clock);
        if ns < block_ns / 4 * 3 || ns > block_ns / 3 * 4 {
            block.repeats = scaled(block.repeats, ns, block_ns).clamp(least, most);
        }
    }
    block.repeats
}

fn scaled(repeats: usize, ns: u64, block_ns: u64) -> usize {
    (repeats as f64 * block_ns as f64 / ns.max(1) as f64).round() as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::scripted::{Script, ScriptedJob};

    fn found(items: usize, cost_ns: u64, least: usize, literal: bool) -> usize {
        let script = Script::default();
        let mut job = ScriptedJob::new(&script, items, cost_ns);
        let block = Block { first: 0, items, repeats: 1, literal };
        repeats(&mut job, block, least, 60_000, &mut script.clock.clone())
    }

    #[test]
    fn blocks_become_as_long_as_wanted() {
        assert_eq!(found(1000, 4, 1, false), 15);
        assert_eq!(found(100, 5, 64, true), 120);
        assert_eq!(found(1, 1, 1, false), 60_000);
    }

    #[test]
    fn never_below_the_least() {
        assert_eq!(found(100_000, 9, 1, false), 1);
        assert_eq!(found(1000, 100, 64, true), 64);
    }

    #[test]
    fn ends_when_time_stands_still() {
        assert_eq!(found(1 << 20, 0, 1, false), 64);
    }

    #[test]
    fn one_disturbed_run_is_overlooked() {
        let script = Script::default();
        let mut job = ScriptedJob::new(&script, 1000, 4);
        script.hiccup.set(Some((2, 5_000_000)));
        let block = Block { first: 0, items: 1000, repeats: 1, literal: false };
        assert_eq!(repeats(&mut job, block, 1, 60_000, &mut script.clock.clone()), 15);
        assert_eq!(script.hiccup.get(), None);
    }
}

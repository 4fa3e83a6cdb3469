//! How the blocks of a contestant are cut. Frozen before the first round.

use super::calibrate::{repeats, shortest_ns, timed};
use super::clock::Clock;
use super::contestant::Contestant;
use super::protocol::{Order, Protocol};
use super::shuffle::permutation;
use crate::job::{Block, Job};
use rand_pcg::Pcg64Mcg;

/// Least repeats in a row of an item under [`Order::Literal`]: the mispredictions where one item
/// follows another (a few ns each) are spread over so many tests.
const LEAST_IN_A_ROW: usize = 64;

/// Repeats in a row where the rounds suffice to visit every item at that.
const WANTED_IN_A_ROW: usize = 256;

/// Least passes of a block under [`Order::Fixed`].
const LEAST_PASSES: u64 = 4;

/// Items that are looked at to guess what an item costs under [`Order::Literal`].
const PROBED_ITEMS: usize = 256;

/// The blocks of one contestant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Plan {
    /// The order that its items are done in.
    pub order: Order,
    /// The items are cut into so many windows of equal size (within one item); a block is one of
    /// them, the next round's block the next. Under [`Order::Reshuffled`] it is always 1.
    pub windows: usize,
    /// Repeats of a block, the same in all rounds.
    pub repeats: usize,
    /// Under [`Order::Reshuffled`]: the block is so many items from the start of the permutation.
    pub prefix: usize,
}

impl Plan {
    /// The block of window `window` (taken modulo the number of windows) of `items` items.
    pub fn block(&self, items: usize, window: usize) -> Block {
        let (literal, repeats) = (self.order == Order::Literal, self.repeats);
        if self.order == Order::Reshuffled {
            return Block { first: 0, items: self.prefix, repeats, literal };
        }
        let (first, end) = cut(items, self.windows, window % self.windows);
        Block { first, items: end - first, repeats, literal }
    }
}

/// Window `window` of `windows` as a range of items. All together they cover every item once,
/// and the same window of jobs with different numbers of items is the same share of them.
fn cut(items: usize, windows: usize, window: usize) -> (usize, usize) {
    let at = |w: usize| (items as u128 * w as u128 / windows as u128) as usize;
    (at(window), at(window + 1))
}

/// Number of windows that all contestants share, so that a round compares the same items.
pub(super) fn shared_windows(
    contestants: &mut [&mut Contestant],
    protocol: &Protocol,
    clock: &mut dyn Clock,
) -> usize {
    let mut windows = 1;
    let mut smallest = usize::MAX;
    let mut walks = 0;
    for contestant in contestants.iter_mut().filter(|c| !c.role.is_orderless()) {
        let lanes = contestant.lanes.max(1);
        let job = contestant.job.as_mut();
        smallest = smallest.min(job.items());
        walks += job.items() * job.tests_per_item() as usize / lanes;
        windows = windows.max(match protocol.order {
            Order::Fixed => fixed_windows(job, protocol, clock),
            Order::Literal => literal_windows(job, protocol, clock),
            Order::Reshuffled => 1,
        });
    }
    if protocol.order == Order::Fixed {
        windows = windows.max(walks.div_ceil(PREDICTED_TESTS));
    }
    windows.min(smallest)
}

/// Tests that a branch predictor remembers, of all the contestants that take turns: what cores of
/// the early 2020s did. Where a machine remembers less, the time alone shows it.
pub const PREDICTED_TESTS: usize = 16_000;

/// One, unless a pass takes so long that a block would have less than four: the first of them is
/// not yet foreseen as the others are.
fn fixed_windows(job: &mut dyn Job, protocol: &Protocol, clock: &mut dyn Clock) -> usize {
    let whole = Block::whole(job);
    let pass_ns = shortest_ns(job, whole, clock);
    pass_ns.saturating_mul(LEAST_PASSES).div_ceil(protocol.block_ns) as usize
}

/// As many as give [`WANTED_IN_A_ROW`] repeats, but not so many that some are never visited,
/// unless fewer leave less than [`LEAST_IN_A_ROW`].
fn literal_windows(job: &mut dyn Job, protocol: &Protocol, clock: &mut dyn Clock) -> usize {
    let items = job.items().min(PROBED_ITEMS);
    let probe = Block { first: 0, items, repeats: LEAST_IN_A_ROW, literal: true };
    let item_ns = shortest_ns(job, probe, clock) as f64 / (items * LEAST_IN_A_ROW) as f64;
    let windows = |in_a_row: usize| {
        let pass_ns = item_ns * job.items() as f64 * in_a_row as f64;
        (pass_ns / protocol.block_ns as f64).ceil() as usize
    };
    windows(WANTED_IN_A_ROW).min(protocol.rounds).max(windows(LEAST_IN_A_ROW)).max(1)
}

/// The plan of one contestant, calibrated by itself.
pub(super) fn plan(
    contestant: &mut Contestant,
    protocol: &Protocol,
    shared_windows: usize,
    clock: &mut dyn Clock,
    rng: &mut Pcg64Mcg,
) -> Plan {
    let job = contestant.job.as_mut();
    let prefix = job.items();
    let mut plan = Plan { order: protocol.order, windows: shared_windows, repeats: 1, prefix };
    if contestant.role.is_orderless() {
        plan.order = Order::Fixed;
        plan.windows = 1;
    }
    let least = match plan.order {
        Order::Reshuffled => {
            plan.prefix = reshuffled_prefix(job, protocol.block_ns, clock, rng);
            return plan;
        }
        Order::Literal => LEAST_IN_A_ROW,
        Order::Fixed => 1,
    };
    let block = plan.block(job.items(), 0);
    plan.repeats = repeats(job, block, least, protocol.block_ns, clock);
    plan
}

/// The plan of a cold contestant: one item a block, the next round's block the next item.
pub(super) fn cold_plan(items: usize) -> Plan {
    Plan { order: Order::Fixed, windows: items, repeats: 1, prefix: items }
}

/// All items, unless a pass takes more than 2.5 blocks: then as many as a block has time for.
/// Each trial pass has a permutation of its own, for a second pass over one is 2 to 4 times
/// faster than the first.
fn reshuffled_prefix(
    job: &mut dyn Job,
    block_ns: u64,
    clock: &mut dyn Clock,
    rng: &mut Pcg64Mcg,
) -> usize {
    let (items, whole) = (job.items(), Block::whole(job));
    let mut pass_ns = u64::MAX;
    for _ in 0..3 {
        job.permute(&permutation(rng, items));
        pass_ns = pass_ns.min(timed(job, whole, clock).0);
    }
    if pass_ns as f64 <= 2.5 * block_ns as f64 {
        return items;
    }
    ((items as f64 * block_ns as f64 / pass_ns as f64) as usize).max(1)
}

/// Gives the plan of a job of `items` items the reference's counts if they are within a factor of
/// 1.5 of its own: different counts bias a ratio by about a per cent (nanobench), a block of 40
/// or 90 us by less than shows. What is much slower or faster keeps its own.
pub(super) fn align(plan: &mut Plan, items: usize, reference: Plan) {
    let is_near = |own: usize, other: usize| own * 3 >= other * 2 && own * 2 <= other * 3;
    if plan.order != reference.order {
        return;
    }
    if is_near(plan.repeats, reference.repeats) {
        plan.repeats = reference.repeats;
    }
    if is_near(plan.prefix, reference.prefix) {
        plan.prefix = reference.prefix.min(items);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_cover_every_item_once() {
        for (items, windows) in [(1000, 17), (7, 7), (10, 3), (5, 1), (63, 64)] {
            let mut next = 0;
            for window in 0..windows {
                let (first, end) = cut(items, windows, window);
                assert_eq!(first, next);
                next = end;
            }
            assert_eq!(next, items, "{items} in {windows}");
        }
    }

    #[test]
    fn same_window_is_the_same_share_of_packets_and_rays() {
        for window in 0..6 {
            let (first, end) = cut(48, 6, window);
            assert_eq!(cut(48 / 8, 6, window), (first / 8, end / 8));
        }
    }
}

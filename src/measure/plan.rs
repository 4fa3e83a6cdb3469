//! How the blocks of a contestant are cut. Frozen before the first round.

use super::calibrate::{repeats, shortest_ns, timed};
use super::clock::Clock;
use super::contestant::Contestant;
use super::protocol::{Order, Pace, Protocol};
use super::shuffle::{lay_out, permutation, shuffle};
use crate::job::{Block, Job};
use rand_pcg::Pcg64Mcg;

/// Least repeats in a row of an item under [`Order::Literal`]: the mispredictions where one item
/// follows another (a few ns each) are spread over so many tests. Not more, so that a block has as
/// many items as it can and one block is like another.
const IN_A_ROW: usize = 64;

/// Items that are looked at to guess what an item costs under [`Order::Literal`] and on a walk.
const PROBED_ITEMS: usize = 256;

/// The blocks of one contestant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Plan {
    /// The order that its items are done in.
    pub order: Order,
    /// The items are cut into so many windows of equal size (within one item); a block is one of
    /// them, the next round's block the next.
    pub windows: usize,
    /// Repeats of a block, the same in all rounds.
    pub repeats: usize,
    /// Whether blocks are those of a walk that goes on: [`Pace::Walk`].
    pub walks: bool,
}

impl Plan {
    /// The items of window `window` (taken modulo the number of windows) of `items` items.
    pub fn range(&self, items: usize, window: usize) -> (usize, usize) {
        cut(items, self.windows, window % self.windows)
    }

    /// The items of a window in a new random order, in front of the others.
    pub fn new_order(&self, items: usize, window: usize, rng: &mut Pcg64Mcg) -> Vec<u32> {
        let (first, end) = self.range(items, window);
        let mut order: Vec<u32> = (first as u32..end as u32).collect();
        shuffle(rng, &mut order);
        order.extend((0..first as u32).chain(end as u32..items as u32));
        order
    }

    /// A window to try things out on before anything is measured: of a walk, one that the first rounds
    /// do not come to, for what was looked at is near for a while.
    pub fn trial_window(&self) -> usize {
        if self.walks { self.windows / 2 } else { 0 }
    }

    /// The block of a window. Under [`Order::Reshuffled`] its items were laid out in front.
    pub fn block(&self, items: usize, window: usize) -> Block {
        let (first, end) = self.range(items, window);
        let (literal, repeats) = (self.order == Order::Literal, self.repeats);
        let in_front = self.order == Order::Reshuffled;
        Block { first: if in_front { 0 } else { first }, items: end - first, repeats, literal }
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
        if protocol.pace == Pace::Walk {
            windows = windows.max(walk_windows(job, protocol, clock));
            continue;
        }
        windows = windows.max(match protocol.order {
            Order::Fixed => fixed_windows(job, protocol, clock),
            Order::Literal => literal_windows(job, protocol, clock),
            Order::Reshuffled => 1,
        });
    }
    if protocol.order == Order::Fixed && protocol.pace != Pace::Walk {
        windows = windows.max(walks.div_ceil(PREDICTED_TESTS));
    }
    windows.min(smallest)
}

/// Tests that a branch predictor is sure to remember, of all the contestants that take turns. One
/// kernel alone is remembered over eight times as many (32 000 on a Zen 4), ten kernels of 1000
/// tests were there, and fourteen were not; a Zen 3 remembers less, and what it forgets depends on
/// the addresses that a process gets. Where a machine remembers less still, the time alone shows it.
pub const PREDICTED_TESTS: usize = 4_000;

/// One, unless a pass takes more than [`MOST_BLOCKS`]: the rounds of a set that is not cut are
/// alike.
fn fixed_windows(job: &mut dyn Job, protocol: &Protocol, clock: &mut dyn Clock) -> usize {
    let whole = Block::whole(job);
    in_blocks(shortest_ns(job, whole, clock), protocol.block_ns)
}

/// The same, told by a part of a pass that begins in the middle of it.
fn walk_windows(job: &mut dyn Job, protocol: &Protocol, clock: &mut dyn Clock) -> usize {
    let items = job.items().min(PROBED_ITEMS);
    let probe = Block { first: (job.items() - items) / 2, items, repeats: 1, literal: false };
    let mut probe_ns = u64::MAX;
    for _ in 0..3 {
        job.approach(probe);
        probe_ns = probe_ns.min(timed(job, probe, clock).0);
    }
    let pass_ns = probe_ns as f64 / items as f64 * job.items() as f64;
    in_blocks(pass_ns as u64, protocol.block_ns)
}

/// Blocks that a pass is cut into.
fn in_blocks(pass_ns: u64, block_ns: u64) -> usize {
    if pass_ns as f64 <= MOST_BLOCKS * block_ns as f64 {
        return 1;
    }
    pass_ns.div_ceil(block_ns) as usize
}

/// A pass of up to so many blocks is left whole.
const MOST_BLOCKS: f64 = 2.5;

/// As many as give [`IN_A_ROW`] repeats.
fn literal_windows(job: &mut dyn Job, protocol: &Protocol, clock: &mut dyn Clock) -> usize {
    let items = job.items().min(PROBED_ITEMS);
    let probe = Block { first: 0, items, repeats: IN_A_ROW, literal: true };
    let item_ns = shortest_ns(job, probe, clock) as f64 / items as f64;
    let pass_ns = item_ns * job.items() as f64;
    // Not so many that some are never visited.
    ((pass_ns / protocol.block_ns as f64).ceil() as usize).clamp(1, protocol.rounds)
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
    let walks = protocol.pace == Pace::Walk;
    let mut plan = Plan { order: protocol.order, windows: shared_windows, repeats: 1, walks };
    if contestant.role.is_orderless() {
        plan.order = Order::Fixed;
        plan.windows = 1;
        plan.walks = false;
    }
    if plan.walks && plan.windows > 1 {
        // A second time the window would be near.
        return plan;
    }
    let least = match plan.order {
        Order::Reshuffled => {
            plan.windows = reshuffled_windows(job, protocol.block_ns, clock, rng);
            return plan;
        }
        Order::Literal => IN_A_ROW,
        Order::Fixed => 1,
    };
    let block = plan.block(job.items(), 0);
    plan.repeats = repeats(job, block, least, protocol.block_ns, clock);
    plan
}

/// The plan of a cold contestant: one item a block, the next round's block the next item.
pub(super) fn cold_plan(items: usize) -> Plan {
    Plan { order: Order::Fixed, windows: items, repeats: 1, walks: false }
}

/// Each trial pass has a permutation of its own, for a second pass over one is 2 to 4 times faster
/// than the first.
fn reshuffled_windows(
    job: &mut dyn Job,
    block_ns: u64,
    clock: &mut dyn Clock,
    rng: &mut Pcg64Mcg,
) -> usize {
    let (items, whole) = (job.items(), Block::whole(job));
    let mut pass_ns = u64::MAX;
    for _ in 0..3 {
        let order = permutation(rng, items);
        lay_out(rng, job, &order);
        pass_ns = pass_ns.min(timed(job, whole, clock).0);
    }
    in_blocks(pass_ns, block_ns).min(items)
}

/// Gives a plan the reference's counts if they are near its own: different counts bias a ratio by
/// about a per cent (nanobench), a block of 40 or 90 us by less than shows. Other windows would
/// also be other items, so there a block may be 24 to 150 us. What is much slower or faster keeps
/// its own.
pub(super) fn align(plan: &mut Plan, items: usize, reference: Plan) {
    let within = |own: usize, other: usize, times: f64| {
        let quotient = own as f64 / other as f64;
        quotient <= times && 1.0 / quotient <= times
    };
    if plan.order != reference.order || plan.walks {
        return;
    }
    if within(plan.repeats, reference.repeats, 1.5) {
        plan.repeats = reference.repeats;
    }
    let reshuffled = plan.order == Order::Reshuffled;
    if reshuffled && reference.windows <= items && within(plan.windows, reference.windows, 2.5) {
        plan.windows = reference.windows;
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

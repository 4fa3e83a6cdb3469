//! How the blocks of a contestant are cut. Frozen before the first round.

use super::calibrate::{MOST_ITEM_RUNS, repeats, shortest_ns, timed, warm_up};
use super::clock::Clock;
use super::contestant::Contestant;
use super::protocol::{Order, Pace, Protocol};
use super::shared::Shared;
use super::shuffle::{lay_out, permutation, shuffle};
use crate::job::{Block, Job};
use rand_pcg::Pcg64Mcg;

/// Least repeats in a row of an item under [`Order::Literal`]: the mispredictions where one item
/// follows another (a few ns each) are spread over so many tests. With 64, one cell of 33 took half a
/// cycle, 1.6 %, more in one process than in the next, all the time: the predictor knew one step the
/// less. Not more, so that a block has as many items as it can and one block is like another.
pub(super) const IN_A_ROW: usize = 128;

/// Passes over a replayed set, timed or not, until it is known.
const WARM_PASSES: usize = 4;

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
    fn new_order(&self, items: usize, window: usize, rng: &mut Pcg64Mcg) -> Vec<u32> {
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

    /// Brings the items into the order of the block of a window, and what it finds at its beginning
    /// into the state that every block finds it in; the new order, if it is new.
    pub fn lay_out(
        &self,
        job: &mut dyn Job,
        window: usize,
        rng: &mut Pcg64Mcg,
    ) -> Option<Vec<u32>> {
        let block = self.block(job.items(), window);
        if !self.walks {
            // Of 144 figures of groups of eight, 15 were 1 to 8 % off for as long as the data stayed where
            // they were, others each time (Zen 4); moved among eight places, none of them was.
            job.relocate();
        }
        match self.order {
            Order::Literal => {
                // Other groups have run since. What is learned of the first item is forgotten at the
                // second.
                job.touch(block);
                warm_up(job, Block { items: 1, ..block });
                None
            }
            Order::Fixed if self.walks => {
                job.approach(block);
                None
            }
            Order::Fixed => {
                // What the others made the predictor forget is learned again over tens of
                // microseconds; after a pass or two, blocks of a whole group were 1 to 2 % longer in
                // one process than in the next.
                let half = block.repeats.div_ceil(2);
                let passes = WARM_PASSES.saturating_sub(block.repeats).max(half);
                (0..passes).for_each(|_| warm_up(job, block));
                None
            }
            Order::Reshuffled => {
                // In the order of the last time, which tells nothing of the new one: code that is far,
                // and branches that were never seen, are no part of a loop over many rays.
                warm_up(job, Block { items: block.items.div_ceil(4), ..block });
                let order = self.new_order(job.items(), window, rng);
                lay_out(rng, job, &order);
                Some(order)
            }
        }
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

/// Blocks that a pass is cut into.
pub(super) fn in_blocks(pass_ns: u64, block_ns: u64) -> usize {
    if pass_ns as f64 <= MOST_BLOCKS * block_ns as f64 {
        return 1;
    }
    pass_ns.div_ceil(block_ns) as usize
}

/// A pass of up to so many blocks is left whole.
const MOST_BLOCKS: f64 = 2.5;

/// The plan of one contestant, calibrated by itself.
pub(super) fn plan(
    contestant: &mut Contestant,
    protocol: &Protocol,
    shared: Shared,
    clock: &mut dyn Clock,
    rng: &mut Pcg64Mcg,
) -> Plan {
    let times = shared.shorter(contestant);
    let job = contestant.job.as_mut();
    let walks = protocol.pace == Pace::Walk;
    let mut plan = Plan { order: protocol.order, windows: shared.windows, repeats: 1, walks };
    if contestant.role.is_orderless() {
        plan.order = Order::Fixed;
        plan.windows = 1;
        plan.walks = false;
    }
    if plan.walks && plan.windows > 1 {
        // A second time the window would be near.
        return plan;
    }
    let block = plan.block(job.items(), 0);
    match plan.order {
        Order::Reshuffled => {
            plan.windows = reshuffled_windows(job, protocol.block_ns, clock, rng);
        }
        Order::Literal => {
            plan.repeats = literal_repeats(job, block, times, protocol.block_ns, clock);
        }
        Order::Fixed => plan.repeats = repeats(job, block, 1, protocol.block_ns, clock),
    }
    plan
}

/// [`IN_A_ROW`], so many times. What it costs to go from item to item (a misprediction, data of the
/// second-level cache) is a part of the time of a test; a number that is chosen by the clock is another
/// one in the next run, and then so is the time: by up to 1.4 %, while the halves of a run were alike
/// to 0.1 %. So the clock is asked only whether the block is far too long or too short.
fn literal_repeats(
    job: &mut dyn Job,
    block: Block,
    times: usize,
    block_ns: u64,
    clock: &mut dyn Clock,
) -> usize {
    let most = (MOST_ITEM_RUNS / block.items.max(1)).max(IN_A_ROW);
    let mut block = Block { repeats: (IN_A_ROW * times).min(most), ..block };
    let mut ns = shortest_ns(job, block, clock);
    while ns < block_ns / 4 && block.repeats <= most / 2 {
        block.repeats *= 2;
        ns = shortest_ns(job, block, clock);
    }
    while ns > 4 * block_ns && block.repeats >= 2 * IN_A_ROW {
        block.repeats /= 2;
        ns = shortest_ns(job, block, clock);
    }
    block.repeats
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

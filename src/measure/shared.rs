//! What the plans of a group share, found before any of them.

use super::calibrate::{shortest_ns, timed};
use super::clock::Clock;
use super::contestant::Contestant;
use super::plan::{IN_A_ROW, in_blocks};
use super::protocol::{Order, Pace, Protocol};
use super::windows::LEAST_VISITS;
use crate::job::{Block, Job};

/// Items that are looked at to guess what an item costs under [`Order::Literal`] and on a walk.
const PROBED_ITEMS: usize = 256;

/// What the plans of all contestants share.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shared {
    /// Windows, so that a round compares the same items.
    pub windows: usize,
    /// The most cycles that a test of any of them takes at least; 0 where nobody knows.
    most_least_cycles: f64,
}

impl Shared {
    /// How many times shorter a test is than the longest of the group, as far as that is known without a
    /// clock: the power of two that is nearest.
    pub fn shorter(self, contestant: &Contestant) -> usize {
        let times = self.most_least_cycles / contestant.least_cycles;
        if times.is_finite() && times > 1.0 { 1 << (times.log2().round() as u32).min(8) } else { 1 }
    }
}

/// Looks at all contestants.
pub(super) fn shared(
    contestants: &mut [&mut Contestant],
    protocol: &Protocol,
    clock: &mut dyn Clock,
) -> Shared {
    let least = contestants.iter().map(|contestant| contestant.least_cycles);
    let most_least_cycles = least.fold(0.0, f64::max);
    Shared { windows: shared_windows(contestants, protocol, clock), most_least_cycles }
}

fn shared_windows(
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

/// About as many as give [`IN_A_ROW`] repeats, a power of two: a number that the clock chooses is another
/// one in the next run, and cuts the order of the items, a part of which a predictor learns, in other
/// places; a power of two is another one only for sets near the edge between two of them.
fn literal_windows(job: &mut dyn Job, protocol: &Protocol, clock: &mut dyn Clock) -> usize {
    let items = job.items().min(PROBED_ITEMS);
    let probe = Block { first: 0, items, repeats: IN_A_ROW, literal: true };
    let item_ns = shortest_ns(job, probe, clock) as f64 / items as f64;
    let pass_ns = item_ns * job.items() as f64;
    let blocks = pass_ns / protocol.block_ns as f64;
    let power = |number: f64| 1 << (number.max(1.0).log2().round() as u32).min(usize::BITS - 2);
    // No more than can be levelled, unless blocks would be four times as long as they should be.
    let levelled = power_below(protocol.rounds / LEAST_VISITS).max(power(blocks / 4.0));
    // Not so many that some are never visited.
    power(blocks).min(levelled).min(power_below(protocol.rounds))
}

/// The largest power of two that is not larger; 1 for 0.
fn power_below(number: usize) -> usize {
    1 << number.max(1).ilog2()
}

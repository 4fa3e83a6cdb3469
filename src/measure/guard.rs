//! Guards against measuring nothing: a test that was optimised away, or folded into fewer, takes
//! less time than it can.

use super::calibrate::timed;
use super::clock::Clock;
use super::plan::Plan;
use super::protocol::Order;
use crate::job::{Block, Job};
use crate::stats::{log_ratios, median, sign_interval};
use rand_pcg::Pcg64Mcg;

/// Operations that no core finishes more of in a cycle, per lane: four pipes (the widest cores
/// have four for numbers), each with one fused multiplication and addition, which counts as two.
pub const MOST_OPERATIONS_PER_CYCLE: f64 = 8.0;

/// Between "takes the same" (1) and "takes twice as long" (2), as far from either in terms of the
/// noise, which is relative.
const HALF_WAY: f64 = std::f64::consts::SQRT_2;

/// Occasions on which the two are timed; a neighbour who comes or goes in between spoils a few.
const OCCASIONS: usize = 9;

/// How many times longer the block is than its half, each begun as blocks are, in the median, if that
/// is nearer to once than to twice. `None` where it is not, and for blocks of a single item that have no
/// half. Those of a reshuffled order are replayed.
pub(super) fn doubling(
    job: &mut dyn Job,
    plan: &Plan,
    clock: &mut dyn Clock,
    rng: &mut Pcg64Mcg,
) -> Option<f64> {
    let whole = plan.block(job.items(), plan.trial_window());
    let (half, share) = half_of(whole)?;
    // Never seen before, the first of a few rays takes longest: the others meet what it has taught.
    // Whether work was left out is no matter of the order.
    let order = if plan.order == Order::Reshuffled { Order::Fixed } else { plan.order };
    let plan = Plan { order, ..*plan };
    let mut ns = |block| {
        plan.lay_out(job, plan.trial_window(), rng);
        timed(job, block, clock).0
    };
    let mut times = Vec::with_capacity(OCCASIONS);
    for _ in 0..OCCASIONS {
        let (half_ns, whole_ns) = (ns(half), ns(whole));
        // Time that stands still is another fault, and found by the first block.
        if half_ns == 0 {
            return None;
        }
        // In terms of a true half, where an odd number has none.
        times.push(whole_ns as f64 / half_ns as f64 * share * 2.0);
        // Most do double at once.
        if times.len() == 3 && times.iter().all(|times| *times >= HALF_WAY) {
            return None;
        }
    }
    median(&times).filter(|times| *times < HALF_WAY)
}

/// Half of the repeats, else half of the items, and which share of the block it is.
fn half_of(whole: Block) -> Option<(Block, f64)> {
    if whole.repeats > 1 {
        let repeats = whole.repeats / 2;
        return Some((Block { repeats, ..whole }, repeats as f64 / whole.repeats as f64));
    }
    let items = whole.items / 2;
    (items > 0).then(|| (Block { items, ..whole }, items as f64 / whole.items as f64))
}

/// Whether it cannot be told from an empty loop: the interval of its time over the loop's, both for
/// one walk through the inner loop (`lanes` tests), does not lie above 1 by more than the noise.
pub(super) fn is_like_nothing(own: &[f64], lanes: usize, empty: &[f64], noise_floor: f64) -> bool {
    let walks: Vec<f64> = own.iter().map(|ns_per_test| ns_per_test * lanes as f64).collect();
    let interval = log_ratios(&walks, empty).and_then(|logs| sign_interval(&logs));
    interval.is_some_and(|interval| interval.low <= noise_floor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::scripted::{Call, Script, ScriptedJob};
    use rand::SeedableRng;
    use std::rc::Rc;

    fn found(cost_ns: u64, once_ns: u64, plan: Plan) -> Option<f64> {
        let script = Script::default();
        let mut job = ScriptedJob::new(&script, 100, cost_ns);
        job.once_ns = once_ns;
        let rng = &mut Pcg64Mcg::seed_from_u64(1);
        doubling(&mut job, &plan, &mut script.clock.clone(), rng)
    }

    #[test]
    fn work_that_is_done_doubles() {
        for order in [Order::Literal, Order::Fixed, Order::Reshuffled] {
            let repeats = if order == Order::Reshuffled { 1 } else { 65 };
            let plan = Plan { order, windows: 1, repeats, walks: false };
            assert_eq!(found(10, 0, plan), None, "{order}");
        }
    }

    #[test]
    fn work_that_was_folded_away_does_not() {
        for (repeats, order) in [(65, Order::Fixed), (64, Order::Literal), (1, Order::Reshuffled)] {
            let plan = Plan { order, windows: 1, repeats, walks: false };
            let times = found(0, 5000, plan).expect("takes the same for half of it");
            assert!((0.9..1.1).contains(&times), "{times}");
        }
    }

    /// Known less, sets of few passes and of few rays had taken 1.3 times the time for twice the work.
    #[test]
    fn a_half_is_known_by_heart() {
        let script = Script::default();
        let mut job = ScriptedJob::new(&script, 100, 10);
        let calls = Rc::clone(&job.calls);
        let rng = &mut Pcg64Mcg::seed_from_u64(1);
        let orders = [(Order::Fixed, 3, vec![100, 100]), (Order::Reshuffled, 1, vec![100; 3])];
        for (order, repeats, warming) in orders {
            let plan = Plan { order, windows: 1, repeats, walks: false };
            calls.borrow_mut().clear();
            doubling(&mut job, &plan, &mut script.clock.clone(), rng);
            let calls = calls.borrow();
            let runs = calls.iter().filter_map(|call| match call {
                Call::Run { block, timed } => Some((block.items, *timed)),
                _ => None,
            });
            let runs: Vec<(usize, bool)> = runs.collect();
            let parts: Vec<_> = runs.split_inclusive(|(_, timed)| *timed).collect();
            assert_eq!(parts.len(), 6);
            for part in parts {
                let untimed = &part[..part.len() - 1];
                assert!(
                    untimed.iter().map(|(items, _)| items).eq(&warming),
                    "{order}: {untimed:?}"
                );
            }
        }
    }

    #[test]
    fn a_single_item_has_no_half() {
        let plan = Plan { order: Order::Reshuffled, windows: 100, repeats: 1, walks: false };
        assert_eq!(found(0, 5000, plan), None);
    }

    #[test]
    fn nothing_is_what_takes_no_more_than_the_loop() {
        let empty = [1.0; 8];
        assert!(is_like_nothing(&[1.0; 8], 1, &empty, 0.002));
        assert!(is_like_nothing(&[0.25; 8], 4, &empty, 0.002));
        assert!(!is_like_nothing(&[1.1; 8], 1, &empty, 0.002));
        assert!(!is_like_nothing(&[0.5; 8], 4, &empty, 0.002));
        assert!(is_like_nothing(&[1.1; 8], 1, &empty, 0.2));
        // Without an empty loop nothing is said.
        assert!(!is_like_nothing(&[1.0; 8], 1, &[], 0.002));
    }
}

//! A ruler for cycles on machines without counters.

use super::calibrate::timed;
use super::clock::Clock;
use crate::job::{Answer, Block, Job, Tally};
use std::hint::black_box;

/// Cycles that one step of [`Chain`] takes: an exclusive or, then a rotation, each waiting for
/// the one before, each one cycle on every processor that we know (fused they are two, too).
pub const CYCLES_PER_STEP: f64 = 2.0;

/// A chain of dependent operations: items are steps, [`CYCLES_PER_STEP`] each. The loop's own
/// counting runs beside the chain and costs nothing.
#[derive(Clone, Debug)]
pub struct Chain {
    steps: usize,
}

impl Chain {
    /// A chain of `steps` steps a pass.
    pub fn new(steps: usize) -> Self {
        Chain { steps }
    }
}

impl Default for Chain {
    /// 1024 steps a pass: with calibrated repeats any block length is met closely.
    fn default() -> Self {
        Chain::new(1024)
    }
}

impl Job for Chain {
    fn items(&self) -> usize {
        self.steps
    }

    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        let steps = block.items as u64 * block.repeats as u64;
        black_box(advance(black_box(1), black_box(0x9e37_79b9), steps));
        Tally { hits: steps, ..Tally::default() }
    }

    fn permute(&mut self, _permutation: &[u32]) {}

    fn answers(&mut self) -> Vec<Answer> {
        Vec::new()
    }
}

/// `steps` steps from `x`, in 32 bits so that builds for 32-bit processors have the same chain.
/// (A chain of additions would be folded into one multiplication.)
#[inline(always)]
fn advance(mut x: u32, k: u32, steps: u64) -> u32 {
    for _ in 0..steps {
        x = (x ^ k).rotate_left(7);
    }
    x
}

/// Steps of a pass of [`cycles_per_ns`]: two million cycles, 0.7 ms at 3 GHz, so that a clock a thousand
/// times too slow still sees hundreds of nanoseconds.
const STEPS: usize = 1 << 20;
/// Passes: the fastest counts, since what disturbs one only makes it longer.
const PASSES: usize = 5;

/// Cycles in a nanosecond of a clock, at least and at most, as far as a clock with steps of so many
/// nanoseconds can tell: what passed is within a step of what it says.
pub fn cycles_per_ns(clock: &mut dyn Clock, resolution_ns: u64) -> (f64, f64) {
    let mut chain = Chain::new(STEPS);
    let block = Block::whole(&chain);
    let passes = (0..PASSES).map(|_| timed(&mut chain, block, clock).0);
    let (ns, step) = (passes.min().unwrap_or(0) as f64, resolution_ns as f64);
    let cycles = STEPS as f64 * CYCLES_PER_STEP;
    (cycles / (ns + step), cycles / (ns - step).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::ScriptedClock;

    #[test]
    fn the_pace_of_a_clock_is_known_to_within_its_steps() {
        // Each reading moves the clock on by so much, and so is a pass as long.
        let cycles = 2.0 * (1u64 << 20) as f64;
        let pace = |ns: u64, resolution| cycles_per_ns(&mut ScriptedClock::new(ns), resolution);
        assert_eq!(pace(1000, 24), (cycles / 1024.0, cycles / 976.0));
        // It says that no time has passed, but for a step: there may have been any number of cycles.
        assert_eq!(pace(0, 1 << 20), (2.0, f64::INFINITY));
    }

    #[test]
    fn thirty_two_steps_flip_all_or_nothing() {
        // 7 and 32 share no factor, so every bit of x meets every bit of k once.
        assert_eq!(advance(0x0123_4567, 0b110, 32), 0x0123_4567);
        assert_eq!(advance(0x0123_4567, 0b111, 32), !0x0123_4567);
        assert_eq!(advance(1, 0, 1), 128);
    }

    #[test]
    fn tally_counts_the_steps() {
        let mut chain = Chain::default();
        let block = Block { first: 3, items: 10, repeats: 7, literal: false };
        assert_eq!(chain.run(block).hits, 70);
        let whole = Block::whole(&chain);
        assert_eq!(chain.run(whole).hits, 1024);
    }
}

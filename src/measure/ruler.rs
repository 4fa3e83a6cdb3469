//! What the processor does next to a block: how long its cycles are, and whether it is shared.
//!
//! Two threads of one core share its arithmetic units. A neighbour on the other thread, which may
//! belong to another virtual machine and count as nobody's switch or steal, makes code that is
//! limited by those units take up to twice its time, and leaves a chain of dependent operations as
//! it is. So both are timed for a few microseconds before and after each block: the chain tells
//! the cycles, and their quotient tells the neighbour.

use super::affinity::run_on;
use super::chain::{CYCLES_PER_STEP, Chain};
use super::clock::Clock;
use crate::job::{Block, Job};
use crate::stats::median;
use std::hint::black_box;

/// What was read at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Length of a cycle, ns.
    pub ns_per_cycle: f64,
    /// Whether somebody else uses the core's units.
    pub crowded: bool,
}

/// Reads the processor's state.
pub trait Ruler {
    /// The state now; `None` where nobody can tell.
    fn read(&mut self, clock: &mut dyn Clock) -> Option<Reading>;
    /// Looks for a processor without a neighbour, for some ms at most, and stays there; before a
    /// group, never within one.
    fn settle(&mut self, _clock: &mut dyn Clock) {}
}

/// Never tells.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoRuler;

impl Ruler for NoRuler {
    fn read(&mut self, _clock: &mut dyn Clock) -> Option<Reading> {
        None
    }
}

/// Steps of the chain in a reading: 16 000 cycles, 3 to 6 us, 200 times a clock's resolution.
const STEPS: usize = 8000;

/// Items of the other half: about as long where [`crate::batch::ArithmeticJob`] is that half.
const ITEMS: usize = 2500;

/// Readings that are looked at together: more than half of them would have to be wrong to be
/// believed.
const TOGETHER: usize = 9;

/// How much more than alone is a neighbour. Alone, readings lie within 1 % of each other; with one
/// they are 1.2 to 2 times as much, by how much of the reading he was there.
const CROWDED: f64 = 1.1;

/// Readings of a look at a processor: a millisecond.
const LOOKS: u32 = 100;

/// A processor with a neighbour in at most this share of the readings is taken.
const QUIET: f64 = 0.1;

/// Looks before a group: with two processors fifteen each, 30 ms in all. Visits last 5 ms or, when
/// a neighbour has much to do, seconds, and those are not waited for.
const TURNS: usize = 30;

/// A chain, and a job that keeps the arithmetic units busy.
pub struct NeighbourRuler {
    chain: Chain,
    units: Box<dyn Job>,
    /// Processors to choose from; with less than two there is no choice.
    cpus: Vec<usize>,
    recent: Vec<f64>,
    /// Least quotient of the two that lasted: what it is without a neighbour.
    alone: f64,
}

impl NeighbourRuler {
    /// Over a job that is limited by the processor's units: its items repeated in a row take the
    /// units' time and wait for nothing. Reads for about 50 ms, to see the processor without a
    /// neighbour for a moment. `cpus` are the numbers of those that the thread may move between,
    /// the present one among them; none to stay.
    pub fn new(units: Box<dyn Job>, cpus: Vec<usize>, clock: &mut dyn Clock) -> Self {
        let mut ruler = NeighbourRuler {
            chain: Chain::new(STEPS),
            units,
            cpus,
            recent: Vec::new(),
            alone: f64::INFINITY,
        };
        for _ in 0..5000 {
            ruler.read(clock);
        }
        ruler
    }

    /// Share of some readings, about a millisecond, that a neighbour is in.
    pub fn crowded_share(&mut self, clock: &mut dyn Clock) -> f64 {
        let crowded = |_: &u32| self.read(clock).is_some_and(|reading| reading.crowded);
        f64::from((0..LOOKS).filter(crowded).count() as u32) / f64::from(LOOKS)
    }

    /// Learns from a quotient what it is alone, and tells whether this one is more.
    fn is_crowded(&mut self, quotient: f64) -> bool {
        self.recent.push(quotient);
        if self.recent.len() == TOGETHER {
            self.alone = median(&self.recent).map_or(self.alone, |m| m.min(self.alone));
            self.recent.clear();
        }
        quotient > CROWDED * self.alone
    }
}

fn timed_ns(job: &mut dyn Job, repeats: usize, clock: &mut dyn Clock) -> f64 {
    let block = Block { repeats, ..Block::whole(job) };
    let start = clock.now_ns();
    black_box(job.run(black_box(block)));
    clock.now_ns().saturating_sub(start) as f64
}

impl Ruler for NeighbourRuler {
    fn read(&mut self, clock: &mut dyn Clock) -> Option<Reading> {
        let chain_ns = timed_ns(&mut self.chain, 1, clock);
        let repeats = (ITEMS / self.units.items().max(1)).max(1);
        let units_ns = timed_ns(self.units.as_mut(), repeats, clock);
        if !(chain_ns > 0.0 && units_ns > 0.0) {
            return None;
        }
        let ns_per_cycle = chain_ns / (STEPS as f64 * CYCLES_PER_STEP);
        Some(Reading { ns_per_cycle, crowded: self.is_crowded(units_ns / chain_ns) })
    }

    fn settle(&mut self, clock: &mut dyn Clock) {
        for _turn in 0..TURNS {
            if self.crowded_share(clock) <= QUIET {
                return;
            }
            // The next one, in a circle; where the system refuses, this one it is.
            if let Some(cpu) = self.cpus.first().copied() {
                self.cpus.rotate_left(1);
                run_on(&[cpu]).ok();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::ScriptedClock;

    fn ruler() -> NeighbourRuler {
        let chain = || Chain::new(STEPS);
        let (units, recent) = (Box::new(chain()), Vec::new());
        NeighbourRuler { chain: chain(), units, cpus: vec![], recent, alone: f64::INFINITY }
    }

    #[test]
    fn a_neighbour_is_seen_once_the_processor_was_seen_without() {
        let mut ruler = ruler();
        assert!((0..9).all(|_| !ruler.is_crowded(2.25)));
        let crowded = [2.24, 2.3, 4.4, 2.25, 2.6, 4.0].map(|quotient| ruler.is_crowded(quotient));
        assert_eq!(crowded, [false, false, true, false, true, true]);
    }

    #[test]
    fn begun_beside_a_neighbour_it_learns_better() {
        let mut ruler = ruler();
        assert!((0..30).all(|_| !ruler.is_crowded(4.4)));
        (0..20).for_each(|_| {
            ruler.is_crowded(2.25);
        });
        assert!(ruler.is_crowded(4.4) && !ruler.is_crowded(2.25));
    }

    #[test]
    fn a_disturbed_chain_teaches_nothing() {
        let mut ruler = ruler();
        (0..9).for_each(|_| {
            ruler.is_crowded(2.25);
        });
        // The chain was interrupted, so the quotient is tiny.
        for quotient in [0.04, 2.25, 0.04, 2.25, 2.25, 2.25, 2.25, 0.04, 0.04, 2.25, 2.3] {
            assert!(!ruler.is_crowded(quotient), "{quotient}");
        }
    }

    #[test]
    fn cycles_are_those_of_the_chain() {
        // Each reading of the clock is 8000 ns after the one before.
        let reading = ruler().read(&mut ScriptedClock::new(8000)).expect("time passes");
        assert_eq!(reading, Reading { ns_per_cycle: 0.5, crowded: false });
        assert_eq!(ruler().read(&mut ScriptedClock::new(0)), None);
    }
}

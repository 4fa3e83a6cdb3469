//! A ruler that sees a neighbour on the core.
//!
//! Two threads of one core share it. A neighbour on the other thread, which may belong to another
//! virtual machine and count as nobody's switch or steal, makes code that does several things in a
//! cycle, such as a kernel, take a quarter to a half more time, and leaves a chain of dependent
//! operations as it is. So both are timed for some microseconds between any two blocks: the
//! chain tells the cycles, and their quotient tells the neighbour. (Additions and multiplications
//! alone are no such code: they left enough of the core to him that he could not be seen.)

use super::affinity::run_on;
use super::chain::{CYCLES_PER_STEP, Chain};
use super::clock::{Clock, timer_figures};
use super::ruler::{Reading, Ruler};
use crate::job::{Block, Job};
use std::collections::BTreeMap;
use std::hint::black_box;

/// Steps of the chain before and after the kernel: 8000 cycles, 2 us, 100 times the resolution of
/// a good clock.
const STEPS: usize = 4000;

/// Tests of the kernel in a reading: 4 us at 40 cycles each.
const TESTS: usize = 400;

/// How far apart the two chains of a reading may be, in terms of the first: what a resolution of
/// 30 ns makes of either. Beyond that the reading itself was disturbed.
const AGREEING: f64 = 0.03;

/// Share of all quotients that may lie below what counts as alone. Less than one in a thousand is
/// too small, where the chain was held up and the kernel was not; and a core that is alone for one
/// reading in fifty is known.
const BELOW: f64 = 0.02;

/// Width of the classes that quotients are counted in, as a relative difference.
const CLASS: f64 = 0.0025;

/// How much more than alone is a neighbour. Alone, nine of ten readings lie within 1 % of each
/// other; with one they are 1.04 times as much, where he does little, to 1.5 times.
const CROWDED: f64 = 1.025;

/// Turns of the first look at the processors.
const FIRST_TURNS: usize = 8;

/// Readings of each: 50 ms.
const FIRST_READINGS: usize = 5000;

/// Readings of a look at a processor: a millisecond.
const LOOKS: u32 = 100;

/// A processor with a neighbour in at most this share of the readings is taken.
const QUIET: f64 = 0.1;

/// Looks before a group: with two processors fifteen each, 30 ms in all. Visits last 5 ms or, when
/// a neighbour has much to do, seconds, and those are not waited for.
const TURNS: usize = 30;

/// Quotients that were read, on whichever processor: one that is hardly ever alone would not be
/// known by its own.
#[derive(Clone, Debug, Default)]
struct Quotients {
    /// How often each was read, by its class.
    times: BTreeMap<i32, u64>,
    readings: u64,
}

impl Quotients {
    /// Learns from a quotient what it is alone, and tells whether this one is more.
    fn is_crowded(&mut self, quotient: f64) -> bool {
        let class = (quotient.ln() / CLASS).floor() as i32;
        *self.times.entry(class).or_default() += 1;
        self.readings += 1;
        let mut below = (BELOW * self.readings as f64) as u64;
        for (&alone, &times) in &self.times {
            if below < times {
                return f64::from(class - alone) * CLASS > CROWDED.ln();
            }
            below -= times;
        }
        false
    }
}

/// A chain, and a kernel that keeps the core busy.
pub struct NeighbourRuler {
    chain: Chain,
    kernel: Box<dyn Job>,
    /// Processors to choose from, the present one first; with none there is no choice.
    cpus: Vec<usize>,
    quotients: Quotients,
    /// What a reading of the clock adds to what is timed, ns.
    clock_ns: f64,
    /// As [`AGREEING`], or more where the clock is coarse.
    agreeing: f64,
}

impl NeighbourRuler {
    /// Over a kernel that computes everything of a few tests, so that nothing is predicted and no
    /// data are far. `cpus` are the numbers of those that the thread may move between, all of one
    /// kind; none to stay. Reads for about 0.4 s, on each of them in turn, to see one without a neighbour for a
    /// moment.
    pub fn new(kernel: Box<dyn Job>, cpus: Vec<usize>, clock: &mut dyn Clock) -> Self {
        let timer = timer_figures(clock);
        let resolution_ns = timer.resolution_ns.unwrap_or(0) as f64;
        let mut ruler = NeighbourRuler {
            chain: Chain::new(STEPS),
            kernel,
            cpus,
            quotients: Quotients::default(),
            clock_ns: timer.cost_ns,
            // Two steps of the clock, where 8000 cycles are 2 us.
            agreeing: AGREEING.max(2.0 * resolution_ns / 2000.0),
        };
        for _ in 0..FIRST_TURNS {
            ruler.move_on();
            for _ in 0..FIRST_READINGS {
                ruler.read(clock);
            }
        }
        ruler
    }

    /// Goes to the next processor, in a circle; where the system refuses, this one it is.
    fn move_on(&mut self) {
        if !self.cpus.is_empty() {
            self.cpus.rotate_left(1);
            self.stay_on_first();
        }
    }

    fn stay_on_first(&self) {
        if let Some(cpu) = self.cpus.first() {
            run_on(&[*cpu]).ok();
        }
    }

    /// Share of some readings, about a millisecond, that a neighbour is in.
    fn crowded_share(&mut self, clock: &mut dyn Clock) -> f64 {
        let crowded = |_: &u32| self.read(clock).is_some_and(|reading| reading.crowded);
        (0..LOOKS).filter(crowded).count() as f64 / f64::from(LOOKS)
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
        let before_ns = timed_ns(&mut self.chain, 1, clock) - self.clock_ns;
        let repeats = (TESTS / self.kernel.items().max(1)).max(1);
        let kernel_ns = timed_ns(self.kernel.as_mut(), repeats, clock) - self.clock_ns;
        let after_ns = timed_ns(&mut self.chain, 1, clock) - self.clock_ns;
        if !(before_ns > 0.0 && kernel_ns > 0.0 && after_ns > 0.0) {
            return None;
        }
        let chain_ns = (before_ns + after_ns) / 2.0;
        let ns_per_cycle = chain_ns / (STEPS as f64 * CYCLES_PER_STEP);
        let disturbed = (after_ns / before_ns - 1.0).abs() > self.agreeing;
        let crowded = disturbed || self.quotients.is_crowded(kernel_ns / chain_ns);
        Some(Reading { ns_per_cycle, crowded })
    }

    fn settle(&mut self, clock: &mut dyn Clock) {
        let mut best = (f64::INFINITY, None);
        for _turn in 0..TURNS {
            let share = self.crowded_share(clock);
            if share <= QUIET {
                return;
            }
            if share < best.0 {
                best = (share, self.cpus.first().copied());
            }
            self.move_on();
        }
        if let Some(place) = self.cpus.iter().position(|cpu| Some(*cpu) == best.1) {
            self.cpus.rotate_left(place);
            self.stay_on_first();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::ScriptedClock;

    fn ruler() -> NeighbourRuler {
        NeighbourRuler {
            chain: Chain::new(STEPS),
            kernel: Box::new(Chain::new(STEPS)),
            cpus: vec![],
            quotients: Quotients::default(),
            clock_ns: 0.0,
            agreeing: AGREEING,
        }
    }

    /// Whether each is crowded, after `times` readings of `usual`.
    fn crowded(usual: f64, times: usize, then: &[f64]) -> Vec<bool> {
        let mut quotients = Quotients::default();
        (0..times).for_each(|_| {
            quotients.is_crowded(usual);
        });
        then.iter().map(|quotient| quotients.is_crowded(*quotient)).collect()
    }

    #[test]
    fn a_neighbour_is_seen_once_the_processor_was_seen_without() {
        let found = crowded(1.74, 100, &[1.73, 1.75, 2.2, 1.77, 1.81, 2.6]);
        assert_eq!(found, [false, false, true, false, true, true]);
    }

    #[test]
    fn begun_beside_a_neighbour_it_learns_better() {
        let then: Vec<f64> = [vec![1.74; 4], vec![2.2]].concat();
        assert_eq!(crowded(2.2, 100, &then).last(), Some(&true));
    }

    #[test]
    fn a_held_up_chain_teaches_nothing() {
        let then: Vec<f64> = vec![0.9, 1.74];
        assert_eq!(crowded(1.74, 100, &then).last(), Some(&false));
    }

    #[test]
    fn cycles_are_those_of_the_chain_without_the_clock() {
        // Each reading of the clock is 4000 ns after the one before.
        let reading = ruler().read(&mut ScriptedClock::new(4000)).expect("time passes");
        assert_eq!(reading, Reading { ns_per_cycle: 0.5, crowded: false });
        let mut costly = NeighbourRuler { clock_ns: 400.0, ..ruler() };
        let reading = costly.read(&mut ScriptedClock::new(4000)).expect("time passes");
        assert!((reading.ns_per_cycle - 0.45).abs() < 1e-12);
        assert_eq!(ruler().read(&mut ScriptedClock::new(0)), None);
    }
}

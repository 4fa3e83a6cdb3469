//! One contestant on its way through the rounds.

use super::calibrate::timed_until;
use super::clock::Clock;
use super::contestant::{Contestant, Expected};
use super::counters::{Counters, Counts};
use super::course::Course;
use super::disturbance::Disturbance;
use super::expectation::Expectation;
use super::figures::Invalid;
use super::forget::Forget;
use super::guard;
use super::plan::Plan;
use super::protocol::Order;
use super::ruler::{Reading, Ruler};
use super::sample::Sample;
use super::shuffle;
use crate::stats::median;

/// Blocks that tell the time alone.
const SOLO_BLOCKS: usize = 5;

/// Attempts at a block beside a neighbour: his visits last 15 us to 5 ms where we looked.
const MOST_ATTEMPTS: usize = 8;

/// What a block needs of the outside world.
pub(super) struct Instruments<'a> {
    pub clock: &'a mut dyn Clock,
    pub counters: &'a mut dyn Counters,
    pub forget: &'a mut dyn Forget,
    pub ruler: &'a mut dyn Ruler,
    pub disturbance: &'a mut dyn Disturbance,
    /// What goes on from block to block.
    pub course: &'a mut Course,
}

impl Instruments<'_> {
    /// The first reading without a neighbour, or the last of some.
    fn quiet_reading(&mut self) -> Option<Reading> {
        let mut reading = None;
        for _attempt in 0..MOST_ATTEMPTS {
            reading = self.ruler.read(self.clock);
            if reading.is_none_or(|reading| !reading.crowded) || !self.course.take_spare() {
                break;
            }
        }
        reading
    }
}

/// A contestant with its plan and what it has taken so far.
pub(super) struct Runner<'a> {
    pub contestant: &'a mut Contestant,
    expectation: Expectation,
    /// Blocks of a walk so far.
    walked: usize,
    /// Whether something else ran in place of the last block itself.
    pub disturbed: bool,
    pub plan: Plan,
    /// One a clean round.
    pub samples: Vec<Sample>,
    /// The sample of the present round, not yet known to be clean.
    pub pending: Option<Sample>,
    /// Median block when nobody else ran in between, ns; order `fixed` only.
    pub solo_ns: Option<f64>,
    pub invalid: Option<Invalid>,
}

impl<'a> Runner<'a> {
    /// Runs every item once by itself, for what blocks must find. The plan is one to be replaced.
    pub fn new(contestant: &'a mut Contestant) -> Self {
        let expectation = Expectation::of(contestant.job.as_mut());
        let found = expectation.hits();
        let invalid = match contestant.expected {
            Expected::Hits(expected) if expected != found => {
                Some(Invalid::Hits { expected, found })
            }
            _ => None,
        };
        Runner {
            contestant,
            expectation,
            walked: 0,
            disturbed: false,
            plan: Plan { order: Order::Fixed, windows: 1, repeats: 1, walks: false },
            samples: Vec::new(),
            pending: None,
            solo_ns: None,
            invalid,
        }
    }

    /// Lays out, times and checks one block; again while a neighbour is seen, which is no matter of
    /// the block's own time. A contestant that has failed only stands in line.
    pub fn block(&mut self, window: usize, instruments: &mut Instruments<'_>) {
        for attempt in 1..=MOST_ATTEMPTS {
            if self.invalid.is_some() {
                return;
            }
            let window = self.next_window(window);
            let job = self.contestant.job.as_mut();
            let order = self.plan.lay_out(job, window, &mut instruments.course.rng);
            self.time(window, order.as_deref(), instruments);
            // The way to the block of a walk is long; only what is timed must be undisturbed.
            let undisturbed = !(self.plan.walks && self.disturbed);
            let quiet = undisturbed && self.pending.is_some_and(|sample| !sample.crowded);
            if quiet || attempt == MOST_ATTEMPTS || !instruments.course.take_spare() {
                return;
            }
        }
    }

    /// The window of the round; of a walk, the one after the last, whatever became of that: it is
    /// near now.
    fn next_window(&mut self, window: usize) -> usize {
        if !self.plan.walks {
            return window;
        }
        self.walked += 1;
        self.walked - 1
    }

    fn time(&mut self, window: usize, order: Option<&[u32]>, instruments: &mut Instruments<'_>) {
        let tests = self.tests(window);
        let job = self.contestant.job.as_mut();
        let block = self.plan.block(job.items(), window);
        let switches = self.plan.walks.then(|| instruments.disturbance.count());
        let before = instruments.course.before(instruments.ruler, instruments.clock);
        instruments.clock.announce(&self.contestant.id, tests);
        instruments.counters.start();
        let (ns, tally, at_ns) = timed_until(job, block, instruments.clock);
        let counts = instruments.counters.stop();
        let after = instruments.course.look(instruments.ruler, instruments.clock);
        self.disturbed = switches.is_some_and(|before| before != instruments.disturbance.count());
        if tally == self.expectation.block(block, order) {
            self.take((ns, at_ns), window, counts, [before, after]);
        } else {
            self.fail(Invalid::Tally { round: self.samples.len() });
        }
    }

    /// Times and checks one item whose code and branches were forgotten; its data are near.
    pub fn cold_block(&mut self, window: usize, instruments: &mut Instruments<'_>) {
        if self.invalid.is_some() {
            return;
        }
        let job = self.contestant.job.as_mut();
        let block = self.plan.block(job.items(), window);
        let before = instruments.quiet_reading();
        instruments.forget.forget(&self.contestant.id);
        job.touch(block);
        // So that the clock's own code is not cold as well.
        instruments.clock.now_ns();
        instruments.clock.now_ns();
        let (ns, tally, at_ns) = timed_until(job, block, instruments.clock);
        if tally == self.expectation.block(block, None) {
            self.take((ns, at_ns), window, None, [before, before]);
        } else {
            self.fail(Invalid::Tally { round: self.samples.len() });
        }
    }

    fn take(
        &mut self,
        (ns, at_ns): (u64, u64),
        window: usize,
        counts: Option<Counts>,
        readings: [Option<Reading>; 2],
    ) {
        if ns == 0 {
            self.fail(Invalid::NoTime);
            return;
        }
        let cycle = |reading: Option<Reading>| reading.map(|reading| reading.ns_per_cycle);
        let [before, after] = readings.map(cycle);
        self.pending = Some(Sample {
            ns,
            tests: self.tests(window),
            at_ns,
            window: window % self.plan.windows,
            counts,
            ns_per_cycle: before.zip(after).map(|(before, after)| (before + after) / 2.0),
            crowded: readings.iter().flatten().any(|reading| reading.crowded),
            share_of_pass: 1.0,
        });
    }

    /// Whether twice the work takes about twice the time; if not, it fails.
    pub fn check_doubling(&mut self, instruments: &mut Instruments<'_>) {
        let job = self.contestant.job.as_mut();
        if let Some(times) =
            guard::doubling(job, &self.plan, instruments.clock, &mut instruments.course.rng)
        {
            self.fail(Invalid::NoMoreForMore { times });
        }
    }

    /// Takes the median of a few blocks in a row, with nobody in between.
    pub fn run_solo(&mut self, instruments: &mut Instruments<'_>) {
        let mut solo = Vec::with_capacity(SOLO_BLOCKS);
        for _ in 0..SOLO_BLOCKS {
            self.block(0, instruments);
            solo.extend(self.pending.take().map(|sample| sample.ns as f64));
        }
        self.solo_ns = median(&solo).filter(|ns| *ns > 0.0);
    }

    /// Keeps the sample of the present round, or drops it. A neighbour of one block is one of the
    /// whole round.
    pub fn end_round(&mut self, clean: bool, crowded: bool) {
        let sample = self.pending.take();
        if clean {
            self.samples.extend(sample.map(|sample| Sample { crowded, ..sample }));
        }
    }

    /// Tests of the block of `window`.
    pub fn tests(&self, window: usize) -> u64 {
        let block = self.plan.block(self.contestant.job.items(), window);
        block.items as u64 * block.repeats as u64 * self.contestant.job.tests_per_item()
    }

    /// Leaves the job in its original order.
    pub fn restore(&mut self) {
        if self.plan.order == Order::Reshuffled {
            shuffle::put_back(self.contestant.job.as_mut());
        }
    }

    /// What was measured of a contestant that turned out wrong is withheld.
    pub fn fail(&mut self, reason: Invalid) {
        self.invalid = Some(reason);
        self.samples.clear();
        self.pending = None;
    }
}

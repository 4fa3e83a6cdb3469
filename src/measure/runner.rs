//! One contestant on its way through the rounds.

use super::calibrate::{timed, warm_up};
use super::clock::Clock;
use super::contestant::{Contestant, Expected};
use super::expectation::Expectation;
use super::figures::Invalid;
use super::plan::Plan;
use super::protocol::Order;
use super::shuffle::permutation;
use rand_pcg::Pcg64Mcg;

/// A contestant with its plan and what it has taken so far.
pub(super) struct Runner<'a> {
    pub contestant: &'a mut Contestant,
    expectation: Expectation,
    pub plan: Plan,
    /// ns per test, one a clean round.
    pub samples: Vec<f64>,
    /// The sample of the present round, not yet known to be clean.
    pending: Option<f64>,
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
        let plan = Plan { order: Order::Fixed, windows: 1, repeats: 1, prefix: 0 };
        Runner { contestant, expectation, plan, samples: Vec::new(), pending: None, invalid }
    }

    /// Lays out, times and checks one block. A contestant that has failed only stands in line.
    pub fn block(&mut self, window: usize, clock: &mut dyn Clock, rng: &mut Pcg64Mcg) {
        if self.invalid.is_some() {
            return;
        }
        let job = self.contestant.job.as_mut();
        let block = self.plan.block(job.items(), window);
        let mut order = None;
        match self.plan.order {
            Order::Literal => {}
            Order::Fixed => warm_up(job, block),
            Order::Reshuffled => {
                let new_order = permutation(rng, job.items());
                job.permute(&new_order);
                order = Some(new_order);
            }
        }
        let (ns, tally) = timed(job, block, clock);
        if tally != self.expectation.block(block, order.as_deref()) {
            self.fail(Invalid::Tally { round: self.samples.len() });
        } else if ns == 0 {
            self.fail(Invalid::NoTime);
        } else {
            self.pending = Some(ns as f64 / self.tests(window) as f64);
        }
    }

    /// Keeps the sample of the present round, or drops it.
    pub fn end_round(&mut self, clean: bool) {
        let sample = self.pending.take();
        if clean {
            self.samples.extend(sample);
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
            let items = self.contestant.job.items() as u32;
            self.contestant.job.permute(&(0..items).collect::<Vec<u32>>());
        }
    }

    /// What was measured of a contestant that turned out wrong is withheld.
    fn fail(&mut self, reason: Invalid) {
        self.invalid = Some(reason);
        self.samples.clear();
        self.pending = None;
    }
}

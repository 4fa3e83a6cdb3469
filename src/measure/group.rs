//! Groups: who is measured in the same rounds, and groups that take turns with their rounds.
//!
//! What cannot be seen lasts longer than a group: where a core has two threads, the other one leaves
//! something of itself behind when it comes to rest (registers that it still holds, by all that we
//! know), and loops that need many registers took 3 to 7 % more time until it worked again, 0.1 to 1 s
//! later, while chain, predictor and caches were as ever. In a group that lasts as long, all rounds
//! are of one such state. So groups take turns, a round or a few of each, and each sees as many states
//! as all of them together.

use super::clock::Clock;
use super::contestant::{self, Contestant};
use super::counters::Counters;
use super::course::Course;
use super::disturbance::Disturbance;
use super::figures::GroupReport;
use super::forget::Forget;
use super::measuring::Measuring;
use super::protocol::{Protocol, ProtocolError};
use super::ruler::Ruler;
use super::runner::Instruments;
use std::sync::atomic::{AtomicBool, Ordering as Atomic};

/// How far a group is, or all that take turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Blocks run so far, those of dropped rounds included.
    pub done_blocks: usize,
    /// Blocks in all; grows when a round has to be run again.
    pub total_blocks: usize,
}

/// What the measuring needs of the outside world.
pub struct Surroundings<'a> {
    /// Tells the time.
    pub clock: &'a mut dyn Clock,
    /// Tells whether a round was disturbed.
    pub disturbance: &'a mut dyn Disturbance,
    /// Counts cycles, instructions and mispredictions where the system lets it.
    pub counters: &'a mut dyn Counters,
    /// Makes the processor forget; run before cold blocks only.
    pub forget: &'a mut dyn Forget,
    /// Tells the length of a cycle, and whether the core is shared.
    pub ruler: &'a mut dyn Ruler,
    /// Called between blocks, never inside a timed window.
    pub progress: &'a mut dyn FnMut(Progress),
    /// Once true, the present block is the last, and the round that it is of is dropped.
    pub cancel: &'a AtomicBool,
}

impl Surroundings<'_> {
    pub(super) fn cancelled(&self) -> bool {
        self.cancel.load(Atomic::Relaxed)
    }

    pub(super) fn instruments<'b>(&'b mut self, course: &'b mut Course) -> Instruments<'b> {
        Instruments {
            clock: &mut *self.clock,
            counters: &mut *self.counters,
            forget: &mut *self.forget,
            ruler: &mut *self.ruler,
            disturbance: &mut *self.disturbance,
            course,
        }
    }
}

/// A group that is to be measured.
pub struct Group<'a> {
    /// Who takes part.
    pub contestants: &'a mut [Contestant],
    /// How it is measured.
    pub protocol: &'a Protocol,
}

/// How often a processor without a neighbour is looked for while groups take turns.
const SETTLES: usize = 8;

/// Measures a group: calibrates each contestant once, then runs rounds of one timed block each.
/// A contestant whose blocks do not find what its items find one by one, or that a guard finds to
/// take less time than its work can, is reported as invalid, without figures; that is no error.
/// Jobs are left in their original order.
///
/// # Errors
/// A protocol or a group that cannot be measured; nothing was run then.
pub fn measure_group(
    contestants: &mut [Contestant],
    protocol: &Protocol,
    surroundings: &mut Surroundings<'_>,
) -> Result<GroupReport, ProtocolError> {
    let reports = measure_groups(vec![Group { contestants, protocol }], surroundings)?;
    reports.into_iter().next().ok_or(ProtocolError::Nobody)
}

/// Measures groups that take turns, each as [`measure_group`] would. Whichever has more rounds runs
/// more of them a turn, so that the rounds of all are spread over the whole time.
///
/// # Errors
/// A protocol or a group that cannot be measured; nothing was run then.
pub fn measure_groups(
    groups: Vec<Group<'_>>,
    surroundings: &mut Surroundings<'_>,
) -> Result<Vec<GroupReport>, ProtocolError> {
    for group in &groups {
        group.protocol.validate()?;
        contestant::validate(group.contestants)?;
    }
    let mut groups: Vec<Measuring<'_>> = groups.into_iter().map(Measuring::new).collect();
    for group in &mut groups {
        surroundings.ruler.settle(surroundings.clock);
        group.prepare(surroundings);
    }
    let total_blocks = groups.iter().map(Measuring::planned_blocks).sum();
    let mut progress = Progress { done_blocks: 0, total_blocks };
    let turns = groups.iter().map(|group| group.planned_rounds).min().unwrap_or(0);
    let others = groups.len() > 1;
    for turn in 0..turns {
        if others && turn % turns.div_ceil(SETTLES) == 0 {
            surroundings.ruler.settle(surroundings.clock);
        }
        for group in &mut groups {
            if others {
                group.course.look_again();
            }
            let until = group.planned_rounds * (turn + 1) / turns;
            group.go_on(until, surroundings, &mut progress);
        }
    }
    Ok(groups.into_iter().map(Measuring::report).collect())
}

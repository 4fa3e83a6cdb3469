//! Rounds: every contestant once in each, in positions that favour nobody.

use super::clock::Clock;
use super::contestant::{self, Contestant, Role};
use super::counters::Counters;
use super::course::Course;
use super::disturbance::Disturbance;
use super::figures::GroupReport;
use super::forget::Forget;
use super::latin::LatinOrder;
use super::plan::{align, cold_plan, plan, shared_windows};
use super::protocol::{Order, Pace, Protocol, ProtocolError};
use super::report::report;
use super::ruler::Ruler;
use super::runner::{Instruments, Runner};
use super::steadiness::Steadiness;
use super::trace::{RoundState, RoundTrace};
use std::sync::atomic::{AtomicBool, Ordering as Atomic};

/// How far a group is.
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
    fn cancelled(&self) -> bool {
        self.cancel.load(Atomic::Relaxed)
    }

    fn instruments<'b>(&'b mut self, course: &'b mut Course) -> Instruments<'b> {
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
    protocol.validate()?;
    contestant::validate(contestants)?;
    let mut course = Course::new(protocol.seed);
    let mut runners: Vec<Runner<'_>> = contestants.iter_mut().map(Runner::new).collect();
    surroundings.ruler.settle(surroundings.clock);
    prepare(&mut runners, protocol, surroundings, &mut course);
    let mut trace = Vec::new();
    let rounds = run_rounds(&mut runners, protocol, surroundings, &mut course, &mut trace);
    let rounds = Rounds { repeated_blocks: course.repeated_blocks, ..rounds };
    runners.iter_mut().for_each(Runner::restore);
    Ok(report(&mut runners, protocol, rounds, trace))
}

/// Cuts the items into blocks, once and for all, and looks whether twice the work takes twice the
/// time.
fn prepare(
    runners: &mut [Runner<'_>],
    protocol: &Protocol,
    surroundings: &mut Surroundings<'_>,
    course: &mut Course,
) {
    if protocol.pace == Pace::Cold {
        runners.iter_mut().for_each(|r| r.plan = cold_plan(r.contestant.job.items()));
        return;
    }
    let clock = &mut *surroundings.clock;
    let valid = runners.iter_mut().filter(|r| r.invalid.is_none());
    let mut contestants: Vec<&mut Contestant> = valid.map(|r| &mut *r.contestant).collect();
    let windows = shared_windows(&mut contestants, protocol, clock);
    for runner in runners.iter_mut().filter(|r| r.invalid.is_none()) {
        // Without a plan no round is run: the flag is looked at again before the first one.
        if surroundings.cancel.load(Atomic::Relaxed) {
            return;
        }
        runner.plan = plan(runner.contestant, protocol, windows, clock, &mut course.rng);
    }
    align_with_reference(runners);
    for runner in runners.iter_mut().filter(|r| r.invalid.is_none()) {
        if surroundings.cancel.load(Atomic::Relaxed) {
            return;
        }
        if protocol.guards {
            runner.check_doubling(&mut surroundings.instruments(course));
        }
        let alone = protocol.order == Order::Fixed && protocol.pace != Pace::Walk;
        if alone && runner.invalid.is_none() {
            course.spare_blocks = protocol.spare_blocks(1);
            runner.run_solo(&mut surroundings.instruments(course));
        }
    }
}

fn align_with_reference(runners: &mut [Runner<'_>]) {
    let is_reference = |r: &&Runner<'_>| r.contestant.role == Role::Reference;
    let Some(reference) = runners.iter().find(is_reference).map(|r| r.plan) else {
        return;
    };
    for runner in runners.iter_mut().filter(|r| !r.contestant.role.is_orderless()) {
        let items = runner.contestant.job.items();
        align(&mut runner.plan, items, reference);
    }
}

/// How many rounds there were.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rounds {
    pub clean: usize,
    pub dirty: usize,
    /// Single blocks that were run again.
    pub repeated_blocks: usize,
    pub cancelled: bool,
}

/// How a round ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ended {
    Clean,
    Dirty,
    Cancelled,
}

impl Ended {
    /// What is taken down of it; nothing where it did not come to its end.
    fn state(self, crowded: bool) -> Option<RoundState> {
        match self {
            Ended::Clean if crowded => Some(RoundState::Crowded),
            Ended::Clean => Some(RoundState::Clean),
            Ended::Dirty => Some(RoundState::Dirty),
            Ended::Cancelled => None,
        }
    }
}

/// Runs the planned rounds; dirty ones again, same positions and windows, while spares last, and
/// on a busy machine beyond that until there are enough for an interval, or it is given up.
fn run_rounds(
    runners: &mut [Runner<'_>],
    protocol: &Protocol,
    surroundings: &mut Surroundings<'_>,
    course: &mut Course,
    trace: &mut Vec<RoundTrace>,
) -> Rounds {
    let number = runners.len();
    let planned = protocol.planned_rounds(number);
    let mut spare = protocol.spare_rounds(number);
    // A stream of its own: how many permutations were drawn does not change the positions.
    let mut latin = LatinOrder::new(number, !protocol.seed);
    let mut rounds = Rounds::default();
    let mut progress = Progress { done_blocks: 0, total_blocks: planned * number };
    course.spare_blocks = protocol.spare_blocks(number);
    let mut steadiness = Steadiness::default();
    for window in 0..planned {
        let positions = latin.next_round();
        loop {
            let at = Round { positions: &positions, window, pace: protocol.pace };
            let mut ended = run_round(runners, at, surroundings, &mut progress, course);
            // A cold chain is one step: no measure of anything.
            let is_cold = protocol.pace == Pace::Cold;
            let crowded = runners.iter().filter_map(|r| r.pending).any(|sample| sample.crowded);
            if ended == Ended::Clean && !is_cold && !steadiness.keeps_step(runners) {
                ended = Ended::Dirty;
            }
            let state = ended.state(crowded);
            trace.extend(state.and_then(|state| RoundTrace::of(runners, state)));
            runners.iter_mut().for_each(|r| r.end_round(ended == Ended::Clean, crowded));
            match ended {
                Ended::Cancelled => return Rounds { cancelled: true, ..rounds },
                Ended::Clean => {
                    rounds.clean += 1;
                    break;
                }
                Ended::Dirty => rounds.dirty += 1,
            }
            if rounds.dirty == protocol.most_dirty_rounds(number) {
                return rounds;
            }
            if spare == 0 && rounds.clean >= Protocol::LEAST_ROUNDS {
                break;
            }
            spare = spare.saturating_sub(1);
            progress.total_blocks += number;
        }
    }
    rounds
}

/// What is to be done in a round.
#[derive(Clone, Copy)]
struct Round<'a> {
    positions: &'a [usize],
    window: usize,
    pace: Pace,
}

/// One round. A disturbance spoils it for everybody, so that none gains.
fn run_round(
    runners: &mut [Runner<'_>],
    round: Round<'_>,
    surroundings: &mut Surroundings<'_>,
    progress: &mut Progress,
    course: &mut Course,
) -> Ended {
    let before = surroundings.disturbance.count();
    for &position in round.positions {
        if surroundings.cancelled() {
            return Ended::Cancelled;
        }
        let instruments = &mut surroundings.instruments(course);
        if round.pace == Pace::Cold {
            runners[position].cold_block(round.window, instruments);
        } else {
            runners[position].block(round.window, instruments);
        }
        progress.done_blocks += 1;
        (surroundings.progress)(*progress);
    }
    let undisturbed = match round.pace {
        Pace::Walk => !runners.iter().any(|runner| runner.disturbed),
        _ => surroundings.disturbance.count() == before,
    };
    if undisturbed { Ended::Clean } else { Ended::Dirty }
}

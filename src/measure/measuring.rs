//! One group on its way: prepared, then a few rounds at a time, then reported.

use super::contestant::{Contestant, Role};
use super::course::Course;
use super::figures::GroupReport;
use super::group::{Group, Progress, Surroundings};
use super::latin::LatinOrder;
use super::plan::{align, cold_plan, plan};
use super::protocol::{Order, Pace, Protocol};
use super::report::report;
use super::runner::Runner;
use super::shared::shared;
use super::steadiness::Steadiness;
use super::trace::{RoundState, RoundTrace};
use std::sync::atomic::Ordering as Atomic;

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

/// A group with what it has taken so far.
pub(super) struct Measuring<'a> {
    pub course: Course,
    pub planned_rounds: usize,
    protocol: &'a Protocol,
    runners: Vec<Runner<'a>>,
    latin: LatinOrder,
    steadiness: Steadiness,
    trace: Vec<RoundTrace>,
    rounds: Rounds,
    /// Rounds that may still be run again because something disturbed them.
    spare: usize,
    /// Planned rounds that were run.
    done: usize,
    /// Cancelled, or given up.
    is_over: bool,
}

impl<'a> Measuring<'a> {
    /// Runs every item of every contestant once by itself, for what blocks must find.
    pub fn new(group: Group<'a>) -> Self {
        let protocol = group.protocol;
        let runners: Vec<Runner<'a>> = group.contestants.iter_mut().map(Runner::new).collect();
        let number = runners.len();
        Measuring {
            course: Course::new(protocol.seed),
            planned_rounds: protocol.planned_rounds(number),
            protocol,
            runners,
            // A stream of its own: how many permutations were drawn does not change the positions.
            latin: LatinOrder::new(number, !protocol.seed),
            steadiness: Steadiness::default(),
            trace: Vec::new(),
            rounds: Rounds::default(),
            spare: protocol.spare_rounds(number),
            done: 0,
            is_over: false,
        }
    }

    pub fn planned_blocks(&self) -> usize {
        self.planned_rounds * self.runners.len()
    }

    /// Calibrates everybody.
    pub fn prepare(&mut self, surroundings: &mut Surroundings<'_>) {
        prepare(&mut self.runners, self.protocol, surroundings, &mut self.course);
        self.course.spare_blocks = self.protocol.spare_blocks(self.runners.len());
    }

    /// Runs planned rounds until so many were run in all; dirty ones again, same positions and
    /// windows, while spares last, and on a busy machine beyond that until there are enough for an
    /// interval, or it is given up.
    pub fn go_on(
        &mut self,
        until: usize,
        surroundings: &mut Surroundings<'_>,
        progress: &mut Progress,
    ) {
        while self.done < until && !self.is_over {
            let positions = self.latin.next_round();
            while !self.round(&positions, surroundings, progress) {}
            self.done += 1;
        }
    }

    /// One planned round; whether there is nothing more to be done about it.
    fn round(
        &mut self,
        positions: &[usize],
        surroundings: &mut Surroundings<'_>,
        progress: &mut Progress,
    ) -> bool {
        let ended = self.attempt(positions, surroundings, progress);
        match ended {
            Ended::Cancelled => {
                self.rounds.cancelled = true;
                self.is_over = true;
            }
            Ended::Clean => self.rounds.clean += 1,
            Ended::Dirty => self.rounds.dirty += 1,
        }
        if ended != Ended::Dirty {
            return true;
        }
        self.is_over = self.rounds.dirty == self.protocol.most_dirty_rounds(self.runners.len());
        let enough = self.spare == 0 && self.rounds.clean >= Protocol::LEAST_ROUNDS;
        if self.is_over || enough {
            return true;
        }
        self.spare = self.spare.saturating_sub(1);
        progress.total_blocks += self.runners.len();
        false
    }

    /// Runs a round once, and takes down what became of it.
    fn attempt(
        &mut self,
        positions: &[usize],
        surroundings: &mut Surroundings<'_>,
        progress: &mut Progress,
    ) -> Ended {
        let runners = &mut self.runners;
        let at = Round { positions, window: self.done, pace: self.protocol.pace };
        let mut ended = run_round(runners, at, surroundings, progress, &mut self.course);
        let crowded = runners.iter().filter_map(|r| r.pending).any(|sample| sample.crowded);
        // A cold chain is one step: no measure of anything.
        let is_cold = self.protocol.pace == Pace::Cold;
        if ended == Ended::Clean && !is_cold && !self.steadiness.keeps_step(runners) {
            ended = Ended::Dirty;
        }
        let state = ended.state(crowded);
        self.trace.extend(state.and_then(|state| RoundTrace::of(runners, state)));
        runners.iter_mut().for_each(|r| r.end_round(ended == Ended::Clean, crowded));
        ended
    }

    /// What came of it; jobs are left in their original order.
    pub fn report(mut self) -> GroupReport {
        let rounds = Rounds { repeated_blocks: self.course.repeated_blocks, ..self.rounds };
        self.runners.iter_mut().for_each(Runner::restore);
        report(&mut self.runners, self.protocol, rounds, self.trace)
    }
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
    let shared = shared(&mut contestants, protocol, clock);
    for runner in runners.iter_mut().filter(|r| r.invalid.is_none()) {
        // Without a plan no round is run: the flag is looked at again before the first one.
        if surroundings.cancel.load(Atomic::Relaxed) {
            return;
        }
        runner.plan = plan(runner.contestant, protocol, shared, clock, &mut course.rng);
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

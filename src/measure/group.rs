//! Rounds: every contestant once in each, in positions that favour nobody.

use super::clock::Clock;
use super::contestant::{self, Contestant, Role};
use super::disturbance::Disturbance;
use super::figures::{GroupReport, Invalid, figures, placebo_floor, withhold};
use super::latin::LatinOrder;
use super::plan::{align, plan, shared_windows};
use super::protocol::{Protocol, ProtocolError};
use super::runner::Runner;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use std::sync::atomic::{AtomicBool, Ordering};

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
    /// Called between blocks, never inside a timed window.
    pub progress: &'a mut dyn FnMut(Progress),
    /// Once true, the present block is the last, and the round that it is of is dropped.
    pub cancel: &'a AtomicBool,
}

impl Surroundings<'_> {
    fn cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }
}

/// Measures a group: calibrates each contestant once, then runs rounds of one timed block each.
/// A contestant whose blocks do not find what its items find one by one is reported as invalid,
/// without figures; that is no error. Jobs are left in their original order.
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
    let mut rng = Pcg64Mcg::seed_from_u64(protocol.seed);
    let number = contestants.len();
    let mut runners: Vec<Runner<'_>> = contestants.iter_mut().map(Runner::new).collect();
    prepare(&mut runners, protocol, surroundings, &mut rng);
    let rounds = run_rounds(&mut runners, protocol, surroundings, &mut rng);
    runners.iter_mut().for_each(Runner::restore);
    let mut figures = figures(&runners, rounds.clean, rounds.dirty);
    if rounds.cancelled && rounds.clean < Protocol::LEAST_ROUNDS {
        withhold(&mut figures, Invalid::Interrupted { rounds: rounds.clean });
    }
    Ok(GroupReport {
        placebo_floor: placebo_floor(&figures),
        figures,
        planned_rounds: protocol.planned_rounds(number),
        rounds: rounds.clean,
        dirty_rounds: rounds.dirty,
        planned_ns: protocol.planned_ns(number),
        cancelled: rounds.cancelled,
    })
}

/// Cuts the items into blocks, once and for all.
fn prepare(
    runners: &mut [Runner<'_>],
    protocol: &Protocol,
    surroundings: &mut Surroundings<'_>,
    rng: &mut Pcg64Mcg,
) {
    let clock = &mut *surroundings.clock;
    let valid = runners.iter_mut().filter(|r| r.invalid.is_none());
    let mut contestants: Vec<&mut Contestant> = valid.map(|r| &mut *r.contestant).collect();
    let windows = shared_windows(&mut contestants, protocol, clock);
    for runner in runners.iter_mut().filter(|r| r.invalid.is_none()) {
        // Without a plan no round is run: the flag is looked at again before the first one.
        if surroundings.cancel.load(Ordering::Relaxed) {
            return;
        }
        runner.plan = plan(runner.contestant, protocol, windows, clock, rng);
    }
    align_with_reference(runners);
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
struct Rounds {
    clean: usize,
    dirty: usize,
    cancelled: bool,
}

/// Runs the planned rounds; dirty ones again, same positions and windows, while spares last, and
/// on a busy machine beyond that until there are enough for an interval, or it is given up.
fn run_rounds(
    runners: &mut [Runner<'_>],
    protocol: &Protocol,
    surroundings: &mut Surroundings<'_>,
    rng: &mut Pcg64Mcg,
) -> Rounds {
    let number = runners.len();
    let planned = protocol.planned_rounds(number);
    let mut spare = protocol.spare_rounds(number);
    // A stream of its own: how many permutations were drawn does not change the positions.
    let mut latin = LatinOrder::new(number, !protocol.seed);
    let mut rounds = Rounds { clean: 0, dirty: 0, cancelled: false };
    let mut progress = Progress { done_blocks: 0, total_blocks: planned * number };
    for window in 0..planned {
        let positions = latin.next_round();
        loop {
            let round = run_round(runners, &positions, window, surroundings, &mut progress, rng);
            runners.iter_mut().for_each(|r| r.end_round(round == Round::Clean));
            if round == Round::Cancelled {
                rounds.cancelled = true;
                return rounds;
            }
            if round == Round::Clean {
                rounds.clean += 1;
                break;
            }
            rounds.dirty += 1;
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

/// How a round ended.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Round {
    Clean,
    Dirty,
    Cancelled,
}

/// One round. A disturbance spoils it for everybody, so that none gains.
fn run_round(
    runners: &mut [Runner<'_>],
    positions: &[usize],
    window: usize,
    surroundings: &mut Surroundings<'_>,
    progress: &mut Progress,
    rng: &mut Pcg64Mcg,
) -> Round {
    let before = surroundings.disturbance.count();
    for &position in positions {
        if surroundings.cancelled() {
            return Round::Cancelled;
        }
        runners[position].block(window, surroundings.clock, rng);
        progress.done_blocks += 1;
        (surroundings.progress)(*progress);
    }
    if surroundings.disturbance.count() == before { Round::Clean } else { Round::Dirty }
}

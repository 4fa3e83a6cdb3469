//! What a group of contestants took.

use super::chain::CYCLES_PER_STEP;
use super::contestant::Role;
use super::runner::Runner;
use crate::stats::{Ratio, median, paired_ratio, sign_interval};

/// Why a contestant has no figures.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Invalid {
    /// Its items, one by one, do not find what the checked answers say.
    #[error("its items found {found} hits, the checked answers have {expected}")]
    Hits {
        /// Hits in the answers that were checked.
        expected: u64,
        /// Hits of the items run one by one.
        found: u64,
    },
    /// A timed block found something else than its items one by one.
    #[error("the timed block of round {round} found something else than its items one by one")]
    Tally {
        /// The round, counted from 0 over clean ones.
        round: usize,
    },
    /// A block took no time: it was optimised away, or the clock is too coarse.
    #[error("a block took no time")]
    NoTime,
    /// It was not measured: every round was disturbed.
    #[error("no undisturbed round was measured")]
    NoRound,
    /// Cancelled before there were enough rounds for figures that stand.
    #[error("interrupted after {rounds} undisturbed rounds")]
    Interrupted {
        /// Clean rounds until then.
        rounds: usize,
    },
}

/// Whether the figures stand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// They do.
    Ok,
    /// There are none.
    Invalid(Invalid),
}

/// What one contestant took. Figures that are withheld or need what the group does not have
/// (a reference, a chain, enough rounds) are `None`.
#[derive(Clone, Debug, PartialEq)]
pub struct Figures {
    /// The contestant.
    pub id: String,
    /// What it was there for.
    pub role: Role,
    /// Whether the figures stand.
    pub status: Status,
    /// Clean rounds, the same for the whole group.
    pub rounds: usize,
    /// Rounds that were dropped because something else ran in between.
    pub dirty_rounds: usize,
    /// Median over the rounds, ns.
    pub ns_per_test: Option<f64>,
    /// Lower end of the median's exact 95 % interval, ns; from 6 rounds on.
    pub ns_low: Option<f64>,
    /// Upper end.
    pub ns_high: Option<f64>,
    /// Smallest of the rounds, ns.
    pub min_ns: Option<f64>,
    /// Cycles by the chain: median of the ratio to it in the same round.
    pub cycles_per_test: Option<f64>,
    /// Time over that of the reference in the same round (> 1 is slower).
    pub ratio_to_reference: Option<Ratio>,
    /// The same over the first half of the rounds alone; from 12 rounds on.
    pub ratio_first_half: Option<Ratio>,
    /// And over the second half.
    pub ratio_second_half: Option<Ratio>,
    /// Share of its time that an empty loop takes: median over the rounds.
    pub empty_loop_ratio: Option<f64>,
    /// Tests of its first block.
    pub tests_per_block: u64,
    /// Repeats of each of its blocks.
    pub repeats: usize,
    /// Windows that its items were cut into.
    pub windows: usize,
    /// ns per test, one a clean round, in the order measured.
    pub samples: Vec<f64>,
}

/// What a group took.
#[derive(Clone, Debug, PartialEq)]
pub struct GroupReport {
    /// In the order of the contestants.
    pub figures: Vec<Figures>,
    /// Largest |ln ratio| of a placebo to the reference: what identical code differs by.
    pub placebo_floor: Option<f64>,
    /// Rounds that were planned.
    pub planned_rounds: usize,
    /// Clean rounds.
    pub rounds: usize,
    /// Dropped rounds.
    pub dirty_rounds: usize,
    /// Planned length of all timed blocks, ns.
    pub planned_ns: u64,
    /// Whether it was ended before its time.
    pub cancelled: bool,
}

/// The samples that all figures of a group are relative to; empty where there are none.
struct Controls {
    reference: Vec<f64>,
    chain: Vec<f64>,
    empty: Vec<f64>,
}

/// The figures of all contestants, in their order.
pub(super) fn figures(runners: &[Runner<'_>], rounds: usize, dirty_rounds: usize) -> Vec<Figures> {
    let of = |role| {
        let runner = runners.iter().find(|r| r.contestant.role == role);
        runner.map_or_else(Vec::new, |r| r.samples.clone())
    };
    let controls =
        Controls { reference: of(Role::Reference), chain: of(Role::Chain), empty: of(Role::Empty) };
    let one = |r| Figures { rounds, dirty_rounds, ..contestant_figures(r, &controls) };
    runners.iter().map(one).collect()
}

fn contestant_figures(runner: &Runner<'_>, controls: &Controls) -> Figures {
    let samples = runner.samples.clone();
    let role = runner.contestant.role;
    let status = match &runner.invalid {
        Some(reason) => Status::Invalid(reason.clone()),
        None if samples.is_empty() => Status::Invalid(Invalid::NoRound),
        None => Status::Ok,
    };
    let interval = sign_interval(&samples);
    // Steps of the chain are no tests: in terms of the reference they say nothing.
    let reference = if role == Role::Chain { &[][..] } else { &controls.reference[..] };
    let half = samples.len() / 2;
    let part =
        |from: usize, to: usize| paired_ratio(samples.get(from..to)?, reference.get(from..to)?);
    Figures {
        id: runner.contestant.id.clone(),
        role,
        status,
        rounds: 0,
        dirty_rounds: 0,
        ns_per_test: median(&samples),
        ns_low: interval.map(|i| i.low),
        ns_high: interval.map(|i| i.high),
        min_ns: samples.iter().copied().reduce(f64::min),
        cycles_per_test: median_quotient(&samples, &controls.chain).map(|q| q * CYCLES_PER_STEP),
        ratio_to_reference: part(0, samples.len()),
        ratio_first_half: part(0, half),
        ratio_second_half: part(half, samples.len()),
        empty_loop_ratio: median_quotient(&controls.empty, &samples),
        tests_per_block: runner.tests(0),
        repeats: runner.plan.repeats,
        windows: runner.plan.windows,
        samples,
    }
}

/// Marks figures as ones that do not stand, whose own reasons are no better.
pub(super) fn withhold(figures: &mut [Figures], reason: Invalid) {
    for figures in figures.iter_mut() {
        if matches!(figures.status, Status::Ok | Status::Invalid(Invalid::NoRound)) {
            figures.status = Status::Invalid(reason.clone());
        }
    }
}

/// Median of `above[i] / below[i]`; unlike a [`Ratio`] it needs one round only.
fn median_quotient(above: &[f64], below: &[f64]) -> Option<f64> {
    if above.len() != below.len() {
        return None;
    }
    let quotients: Vec<f64> = above.iter().zip(below).map(|(a, b)| a / b).collect();
    median(&quotients)
}

/// Largest |ln ratio| among the placebos.
pub(super) fn placebo_floor(figures: &[Figures]) -> Option<f64> {
    let placebos = figures.iter().filter(|f| f.role == Role::Placebo);
    let logs = placebos.filter_map(|f| f.ratio_to_reference).map(|r| r.estimate.ln().abs());
    logs.reduce(f64::max)
}

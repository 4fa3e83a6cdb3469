//! Figures from the samples of a group.

use super::chain::CYCLES_PER_STEP;
use super::contestant::Role;
use super::figures::{CyclesSource, Figures, GroupReport, Invalid, Status};
use super::guard;
use super::measuring::Rounds;
use super::protocol::{Pace, Protocol};
use super::runner::Runner;
use super::sample::Sample;
use super::trace::{self, RoundTrace};
use super::windows;
use crate::stats::{decide, log_ratios, median, paired_ratio, sign_interval};

/// No machine that we know tells less apart between two builds of one source.
const LEAST_NOISE: f64 = 0.002;

/// The samples that all figures of a group are relative to, ns per test; empty where there are
/// none.
struct Controls {
    reference: Vec<f64>,
    chain: Vec<f64>,
    empty: Vec<f64>,
    /// Of the chain: median block among the others over the median alone.
    chain_solo: Option<f64>,
}

impl Controls {
    fn of(runners: &[Runner<'_>]) -> Self {
        let runner = |role| runners.iter().find(|r| r.contestant.role == role);
        let times = |role| runner(role).map_or_else(Vec::new, ns_per_test);
        Controls {
            reference: times(Role::Reference),
            chain: times(Role::Chain),
            empty: times(Role::Empty),
            chain_solo: runner(Role::Chain).and_then(over_solo),
        }
    }
}

/// The report of a group that has run its rounds. What a guard finds too fast is failed first.
pub(super) fn report(
    runners: &mut [Runner<'_>],
    protocol: &Protocol,
    mut rounds: Rounds,
    mut trace: Vec<RoundTrace>,
) -> GroupReport {
    let number = runners.len();
    let planned = protocol.planned_rounds(number);
    let crowded_share = drop_crowded(runners, planned, &mut rounds);
    runners.iter_mut().for_each(windows::level);
    trace::level(&mut trace, runners);
    let controls = Controls::of(runners);
    let floor = noise_floor(runners, &controls);
    if protocol.guards && matches!(protocol.pace, Pace::Throughput | Pace::Walk) {
        guard_all(runners, &controls, floor);
    }
    // Whoever failed has no samples left, the reference neither.
    let controls = Controls::of(runners);
    let mut figures: Vec<Figures> =
        runners.iter().map(|runner| figures_of(runner, &controls, rounds)).collect();
    put_decisions(&mut figures, &controls, protocol.margin.max(floor));
    if rounds.cancelled && rounds.clean < Protocol::LEAST_ROUNDS {
        withhold(&mut figures, &Invalid::Interrupted { rounds: rounds.clean });
    }
    GroupReport {
        placebo_floor: placebo_floor(&figures),
        noise_floor: floor,
        figures,
        planned_rounds: planned,
        rounds: rounds.clean,
        dirty_rounds: rounds.dirty,
        crowded_share,
        repeated_blocks: rounds.repeated_blocks,
        planned_ns: protocol.planned_ns(number),
        cancelled: rounds.cancelled,
        trace,
    }
}

/// Drops the rounds beside a neighbour if a quarter of those planned is left without them, else
/// none. Returns the share of such rounds among those that stay.
fn drop_crowded(runners: &mut [Runner<'_>], planned: usize, rounds: &mut Rounds) -> f64 {
    let all = runners.iter().map(|r| &r.samples).find(|samples| !samples.is_empty());
    let crowded = all.map_or(0, |samples| samples.iter().filter(|s| s.crowded).count());
    let quiet = rounds.clean - crowded;
    if quiet < (planned / 4).max(Protocol::LEAST_ROUNDS) {
        return crowded as f64 / rounds.clean.max(1) as f64;
    }
    for runner in runners.iter_mut() {
        runner.samples.retain(|sample| !sample.crowded);
    }
    rounds.clean = quiet;
    rounds.dirty += crowded;
    0.0
}

/// Marks figures as ones that do not stand, whose own reasons are no better.
fn withhold(figures: &mut [Figures], reason: &Invalid) {
    for figures in figures.iter_mut() {
        if matches!(figures.status, Status::Ok | Status::Invalid(Invalid::NoRound)) {
            figures.status = Status::Invalid(reason.clone());
        }
    }
}

fn ns_per_test(runner: &Runner<'_>) -> Vec<f64> {
    runner.samples.iter().map(Sample::ns_per_test).collect()
}

/// Fails whoever takes less time than its work can.
fn guard_all(runners: &mut [Runner<'_>], controls: &Controls, floor: f64) {
    for runner in runners.iter_mut().filter(|r| !r.contestant.role.is_orderless()) {
        let own = ns_per_test(runner);
        if guard::is_like_nothing(&own, runner.contestant.lanes, &controls.empty, floor) {
            runner.fail(Invalid::LikeNothing);
            continue;
        }
        let least = runner.contestant.least_cycles;
        let cycles = cycles(runner, controls).and_then(|(cycles, _)| median(&cycles));
        if let Some(cycles) = cycles.filter(|cycles| *cycles < least) {
            runner.fail(Invalid::TooFast { cycles, least });
        }
    }
}

/// Cycles of a test in every round: counted where every round was, else by the chain beside the
/// block, else by that of the round.
fn cycles(runner: &Runner<'_>, controls: &Controls) -> Option<(Vec<f64>, CyclesSource)> {
    let counted = |s: &Sample| Some(s.counts?.cycles as f64 / s.tests as f64 * s.share_of_pass);
    let counts: Option<Vec<f64>> = runner.samples.iter().map(counted).collect();
    if let Some(counts) = counts.filter(|counts| !counts.is_empty()) {
        return Some((counts, CyclesSource::Counter));
    }
    let ruled: Option<Vec<f64>> =
        runner.samples.iter().map(|s| Some(s.ns_per_test() / s.ns_per_cycle?)).collect();
    if let Some(ruled) = ruled.filter(|ruled| !ruled.is_empty()) {
        return Some((ruled, CyclesSource::Chain));
    }
    let own = ns_per_test(runner);
    if own.is_empty() || own.len() != controls.chain.len() {
        return None;
    }
    let steps = own.iter().zip(&controls.chain).map(|(own, step)| own / step * CYCLES_PER_STEP);
    Some((steps.collect(), CyclesSource::Chain))
}

fn figures_of(runner: &Runner<'_>, controls: &Controls, rounds: Rounds) -> Figures {
    let samples = ns_per_test(runner);
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
    let (cycles, source) = cycles(runner, controls).unwrap_or((Vec::new(), CyclesSource::Chain));
    let cycles_of = |from: usize, to: usize| median(cycles.get(from..to)?);
    let counted = |of: fn(&Sample) -> Option<f64>| {
        let values: Option<Vec<f64>> = runner.samples.iter().map(of).collect();
        median(&values?)
    };
    Figures {
        id: runner.contestant.id.clone(),
        role,
        status,
        rounds: rounds.clean,
        dirty_rounds: rounds.dirty,
        ns_per_test: median(&samples),
        ns_low: interval.map(|i| i.low),
        ns_high: interval.map(|i| i.high),
        min_ns: samples.iter().copied().reduce(f64::min),
        cycles_per_test: median(&cycles),
        cycles_interval: sign_interval(&cycles),
        cycles_first_half: cycles_of(0, half),
        cycles_second_half: cycles_of(half, samples.len()),
        cycles_source: source,
        instructions_per_test: counted(|s| Some(s.counts?.instructions as f64 / s.tests as f64)),
        mispredicts_per_test: counted(|s| Some(s.counts?.branch_misses as f64 / s.tests as f64)),
        ratio_to_reference: part(0, samples.len()),
        ratio_first_half: part(0, half),
        ratio_second_half: part(half, samples.len()),
        decision: None,
        solo_ratio: over_solo(runner).zip(controls.chain_solo).map(|(own, chain)| own / chain),
        empty_loop_ratio: median_quotient(&controls.empty, &samples),
        tests_per_block: runner.tests(0),
        repeats: runner.plan.repeats,
        windows: runner.plan.windows,
        samples,
    }
}

/// Median block of the first window among the others over the median alone. Medians, since who
/// ends a round and begins the next has nobody in between.
fn over_solo(runner: &Runner<'_>) -> Option<f64> {
    let first = runner.samples.iter().filter(|sample| sample.window == 0);
    let among_others: Vec<f64> = first.map(|sample| sample.ns as f64).collect();
    Some(median(&among_others)? / runner.solo_ns?)
}

/// Median of `above[i] / below[i]`; unlike a ratio with an interval it needs one round only.
fn median_quotient(above: &[f64], below: &[f64]) -> Option<f64> {
    if above.len() != below.len() {
        return None;
    }
    let quotients: Vec<f64> = above.iter().zip(below).map(|(a, b)| a / b).collect();
    median(&quotients)
}

/// Largest |ln ratio| among the placebos.
fn placebo_floor(figures: &[Figures]) -> Option<f64> {
    let placebos = figures.iter().filter(|f| f.role == Role::Placebo);
    let logs = placebos.filter_map(|f| f.ratio_to_reference).map(|r| r.estimate.ln().abs());
    logs.reduce(f64::max)
}

/// What copies of the reference differ by, at the outer end of the interval: chance and code
/// placement together.
fn noise_floor(runners: &[Runner<'_>], controls: &Controls) -> f64 {
    let placebos = runners.iter().filter(|r| r.contestant.role == Role::Placebo);
    let ratios = placebos.filter_map(|r| paired_ratio(&ns_per_test(r), &controls.reference));
    let ends = ratios.map(|ratio| ratio.high.ln().max(-ratio.low.ln()).exp_m1());
    ends.fold(LEAST_NOISE, f64::max)
}

/// Judges all subjects as one family, and each placebo by itself: a placebo is asked whether it
/// alone would have been called different.
fn put_decisions(figures: &mut [Figures], controls: &Controls, margin: f64) {
    let mut families: Vec<Vec<usize>> = vec![Vec::new()];
    let mut members = Vec::new();
    for (place, figures) in figures.iter().enumerate() {
        let logs = log_ratios(&figures.samples, &controls.reference);
        members.push(figures.ratio_to_reference.zip(logs));
        match figures.role {
            _ if members[place].is_none() => {}
            Role::Subject => families[0].push(place),
            Role::Placebo => families.push(vec![place]),
            _ => {}
        }
    }
    for family in families {
        let of: Vec<_> = family.iter().filter_map(|place| members[*place].clone()).collect();
        for (place, decision) in family.into_iter().zip(decide(&of, margin).unwrap_or_default()) {
            figures[place].decision = Some(decision);
        }
    }
}

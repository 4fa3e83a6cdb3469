//! How long a run will take, before it runs.

use std::io::Write;
use std::num::NonZero;

use super::failure::Failure;
use crate::experiment::{ErrorsWorkload, PairsWorkload, Plan, Profile, StiffWorkload, Workload};
use crate::shard::Shard;
use crate::stability::{EXPERIMENT, Sweep};

/// What an experiment is expected to take, in seconds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Estimate {
    timing: f64,
    clock_free: f64,
    drawing: f64,
}

impl Estimate {
    /// All of it.
    pub fn total(&self) -> f64 {
        self.timing + self.clock_free + self.drawing
    }
}

/// How much longer measuring takes than its blocks: looks at the core, new orders, calibration. So
/// it was in a quick run that ran nothing again, on a machine shared with others.
const BESIDE_BLOCKS: f64 = 1.4;

/// Blocks take their time by design; drawing pairs, the exact answers and the check of each
/// variant were measured at about these rates, and a figure takes a few milliseconds. A shard times
/// and draws nothing.
pub fn estimate(plan: &Plan, profile: Profile, shard: Option<Shard>) -> Estimate {
    if let Some(shard) = shard {
        let clock_free = errors_of(plan) * shard.share();
        return Estimate { clock_free, ..Estimate::default() };
    }
    let timing = BESIDE_BLOCKS * plan.seconds(profile);
    let checked = (plan.cells().len() * plan.variants.len()) as f64;
    let clock_free = match &plan.experiment.workload {
        Workload::Codes(codes) => 0.4e-6 * (codes.pairs * plan.variants.len()) as f64,
        Workload::Errors(_) => errors_of(plan),
        _ => errors_of(plan) + 2e-3 * checked + 10e-3 * plan.cells().len() as f64,
    };
    Estimate { timing, clock_free, drawing: 5e-3 * plan.experiment.figure.len() as f64 }
}

/// Errors on random hits and on stiff families.
fn errors_of(plan: &Plan) -> f64 {
    match &plan.experiment.workload {
        Workload::Errors(errors) => of_errors(plan, errors),
        Workload::Pairs(PairsWorkload { errors, stiff, .. }) => {
            let random = errors.as_ref().map_or(0.0, |errors| of_errors(plan, errors));
            random + stiff.as_ref().map_or(0.0, |stiff| of_stiff(plan, stiff))
        }
        _ => 0.0,
    }
}

/// Of one answer held against the exact one, which all processors share out among them.
fn seconds_of_an_answer() -> f64 {
    0.4e-6 / std::thread::available_parallelism().map_or(1.0, |count| count.get() as f64)
}

/// Both references; exact answers take as long as some ten forms.
fn of_errors(plan: &Plan, errors: &ErrorsWorkload) -> f64 {
    seconds_of_an_answer() * (errors.seeds * errors.hits * (2 * plan.variants.len() + 10)) as f64
}

/// Exact answers take as long as some ten forms.
fn of_stiff(plan: &Plan, stiff: &StiffWorkload) -> f64 {
    seconds_of_an_answer() * (stiff.knobs.len() * stiff.cases * (plan.variants.len() + 10)) as f64
}

/// What everything is expected to take, in seconds.
pub fn seconds_of_all(
    plans: &[Plan],
    sweep: Option<&Sweep>,
    profile: Profile,
    shard: Option<Shard>,
) -> f64 {
    let plans: f64 = plans.iter().map(|plan| estimate(plan, profile, shard).total()).sum();
    plans + sweep.map_or(0.0, seconds_of_sweep)
}

fn seconds_of_sweep(sweep: &Sweep) -> f64 {
    sweep.seconds(std::thread::available_parallelism().map_or(1, NonZero::get))
}

/// Prints what would run and how long it would take.
///
/// # Errors
/// When stdout cannot be written.
pub fn dry_run(
    plans: &[Plan],
    sweep: Option<&Sweep>,
    profile: Profile,
    shard: Option<Shard>,
) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    let mut sum = Estimate::default();
    writeln!(
        out,
        "{:<14}{:>9}{:>7}{:>9}{:>12}{:>13}{:>12}",
        "experiment", "variants", "cells", "blocks", "timing s", "clock-free s", "drawing s"
    )?;
    for plan in plans {
        let one = estimate(plan, profile, shard);
        let timed = |count: usize| if shard.is_some() { 0 } else { count };
        writeln!(
            out,
            "{:<14}{:>9}{:>7}{:>9}{:>12.1}{:>13.1}{:>12.1}",
            plan.experiment.id,
            plan.variants.len(),
            timed(plan.cells().len()),
            timed(plan.blocks(profile)),
            one.timing,
            one.clock_free,
            one.drawing
        )?;
        sum.timing += one.timing;
        sum.clock_free += one.clock_free;
        sum.drawing += one.drawing;
    }
    if let Some(sweep) = sweep {
        let seconds = seconds_of_sweep(sweep);
        writeln!(out, "{EXPERIMENT:<14}{:>9}{seconds:>41.1}", sweep.forms.len())?;
        sum.clock_free += seconds;
    }
    writeln!(
        out,
        "{:<39}{:>12.1}{:>13.1}{:>12.1}  in all {:.0} s",
        "",
        sum.timing,
        sum.clock_free,
        sum.drawing,
        sum.total()
    )?;
    Ok(())
}

//! `--shard`: a share of what needs no clock, on as many machines or in as many jobs as wanted.

use std::io::Write;
use std::sync::atomic::Ordering;
use std::time::Instant;

use super::arguments::Batch;
use super::batch::{interrupted, said};
use super::estimate::seconds_of_all;
use super::failure::Failure;
use super::folder::{Before, Folder};
use super::sweep::sweep_once;
use super::{interrupt, progress};
use crate::experiment::{Plan, is_clock_free, run_shard};
use crate::level::levels;
use crate::measure::{Environment, WallClock};
use crate::report::count;
use crate::stability::Sweep;

/// The circumstances of work that needs no clock: nothing is pinned.
pub fn environment() -> Environment {
    let has = |(level, available): (&str, bool)| available.then(|| level.to_owned());
    let levels = levels().into_iter().filter_map(has).collect();
    Environment { levels, ..Environment::capture(&mut WallClock::new()) }
}

/// The plans that have something to share out; the others, and what else the former would time,
/// are left out and named.
///
/// # Errors
/// Usage, if nothing is left.
pub fn clock_free(plans: Vec<Plan>) -> Result<Vec<Plan>, Failure> {
    let kind = |plan: &Plan| is_clock_free(&plan.experiment.workload);
    let names = |plans: &[&Plan]| {
        let ids: Vec<&str> = plans.iter().map(|plan| plan.experiment.id.as_str()).collect();
        ids.join(", ")
    };
    let timed: Vec<&Plan> = plans.iter().filter(|plan| !kind(plan).0).collect();
    let half: Vec<&Plan> = plans.iter().filter(|plan| kind(plan) == (true, true)).collect();
    if timed.len() == plans.len() {
        return Err(Failure::Usage(format!(
            "--shard: {} would be timed; allowed: experiments with work that needs no clock \
             (operations counted, errors, stiff families)",
            names(&timed)
        )));
    }
    if !timed.is_empty() {
        say!("left out, since only what needs no clock is shared out: {}", names(&timed));
    }
    if !half.is_empty() {
        say!("left out of these: their times, as well: {}", names(&half));
    }
    Ok(plans.into_iter().filter(|plan| kind(plan).0).collect())
}

/// Runs the share of every plan, and saves it as a run of its own, without figures: those of a
/// part would show a part.
///
/// # Errors
/// As a run.
pub fn carry_out(
    plans: &[Plan],
    sweep: Option<&Sweep>,
    batch: &Batch,
    folder: &Folder,
) -> Result<(), Failure> {
    let before = folder.open(plans, batch.resume)?;
    let shard = batch.shard.unwrap_or_default();
    say!(
        "part {shard} of {}, about {} s; results in {}",
        count(plans.len(), "experiment", "experiments"),
        seconds_of_all(plans, sweep, batch.profile.value(), Some(shard)).ceil(),
        folder.path().display()
    );
    let cancel = interrupt::flag();
    let bar = progress::bar(plans.len());
    for (plan, before) in plans.iter().zip(before) {
        let id = &plan.experiment.id;
        if matches!(before, Before::Finished(_)) {
            say!("{id}: finished before");
            continue;
        }
        if cancel.load(Ordering::Relaxed) {
            return Err(interrupted(folder));
        }
        let start = Instant::now();
        // There is nothing to go on with within an experiment: its journal says that it has begun.
        folder.begin(plan, Before::Nothing)?;
        let outcome = run_shard(plan, shard, cancel)?;
        folder.save(plan, &outcome)?;
        bar.suspend(|| said(id, &outcome, start.elapsed()));
        bar.inc(1);
        if outcome.interrupted {
            bar.finish_and_clear();
            return Err(interrupted(folder));
        }
    }
    bar.finish_and_clear();
    if let Some(sweep) = sweep
        && !sweep_once(folder, sweep, batch.resume)?
    {
        return Err(interrupted(folder));
    }
    // Everything is saved: a stdout that is closed does not change what came of it.
    let _ = writeln!(std::io::stdout(), "{}", folder.path().display());
    Ok(())
}

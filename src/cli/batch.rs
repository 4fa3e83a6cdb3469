//! `ray_test run` and `ray_test reproduce`.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use regex::Regex;

use super::arguments::{Batch, Reproduce, Run};
use super::built_in::{Source, built_in_sources};
use super::estimate::{dry_run, seconds_of_all};
use super::failure::Failure;
use super::folder::{Before, Folder};
use super::instruments::Instruments;
use super::publish::{draw_all, publish, read};
use super::sweep::{of_profile, sweep_once};
use super::{interrupt, lock, progress, shards, unfinished};
use crate::experiment::{Experiment, Outcome, Plan, pattern_of, run as run_plan};
use crate::measure::Environment;
use crate::report::count;
use crate::results::LoadError;
use crate::stability::Sweep;
use crate::workload::hash::Fnv;

/// Experiments from files.
pub fn run(arguments: &Run) -> Result<(), Failure> {
    let mut sources = Vec::new();
    for path in &arguments.configs {
        let text = std::fs::read_to_string(path).map_err(|error| {
            Failure::Usage(format!("{}: {error}; allowed: a TOML file", path.display()))
        })?;
        sources.push((path.display().to_string(), text));
    }
    carry_out(sources, &arguments.batch, false)
}

/// The experiments that are compiled in, and the stiff cases.
pub fn reproduce(arguments: &Reproduce) -> Result<(), Failure> {
    carry_out(parts(built_in_sources())?, &arguments.batch, true)
}

/// The experiments that are part of `reproduce`; the others are named.
fn parts(sources: Vec<Source>) -> Result<Vec<Source>, Failure> {
    let (mut parts, mut apart) = (Vec::new(), Vec::new());
    for (origin, text) in sources {
        let is_part = Experiment::parse(&origin, &text)?.reproduce;
        if is_part { parts.push((origin, text)) } else { apart.push(origin) }
    }
    if !apart.is_empty() {
        say!("not part of it, to be run by themselves: `ray_test run {}`", apart.join(" "));
    }
    Ok(parts)
}

/// Everything that can be refused is refused before anything runs.
fn carry_out(sources: Vec<Source>, batch: &Batch, with_stiff: bool) -> Result<(), Failure> {
    let filter = filter(batch)?;
    let mut plans = plans(&sources, filter.as_ref())?;
    if plans.is_empty() {
        // All of them are of another build, which was said.
        return Ok(());
    }
    if batch.shard.is_some() {
        plans = shards::clock_free(plans)?;
    }
    let experiments: Vec<String> = plans.iter().map(|plan| plan.experiment.id.clone()).collect();
    batch.baselines.check(&experiments)?;
    let profile = batch.profile.value();
    let sweep = if with_stiff { of_profile(profile, filter.as_ref(), batch.shard) } else { None };
    if batch.dry_run {
        return dry_run(&plans, sweep.as_ref(), profile, batch.shard);
    }
    if let Some(shard) = batch.shard {
        let environment = shards::environment();
        let hash = config_hash(&plans, &sources, batch, &environment);
        let folder = Folder::new(batch.out.as_deref(), hash, environment, settings(batch));
        let folder = folder.of_shard(shard);
        let ended = shards::carry_out(&plans, sweep.as_ref(), batch, &folder);
        return ended.inspect_err(|failure| say_where_it_stands(failure, &folder));
    }
    batch.baselines.prepare()?;
    let _lock = lock::take()?;
    let (instruments, environment) = Instruments::set_up(batch.pin)?;
    let hash = config_hash(&plans, &sources, batch, &environment);
    let folder = Folder::new(batch.out.as_deref(), hash, environment, settings(batch));
    let folder = if batch.resume { folder.going_on() } else { folder };
    let before = folder.open(&plans, batch.resume)?;
    say!(
        "{}, about {} s; results in {}",
        count(plans.len(), "experiment", "experiments"),
        seconds_of_all(&plans, sweep.as_ref(), profile, None).ceil(),
        folder.path().display()
    );
    let ended = measure(&plans, before, batch, &folder, instruments)
        .and_then(|wrong| conclude(sweep.as_ref(), batch, &folder, wrong))
        .inspect_err(|failure| say_where_it_stands(failure, &folder));
    batch.baselines.finish(ended, folder.path(), &experiments)
}

/// The regular expression of `--filter`.
///
/// # Errors
/// Usage where it is none.
pub fn filter(batch: &Batch) -> Result<Option<Regex>, Failure> {
    let filter = batch.filter.as_deref().map(pattern_of).transpose();
    filter.map_err(|error| Failure::Usage(format!("--filter: {error}")))
}

/// What the experiments of files will do; those of other builds are left out, and named.
///
/// # Errors
/// What cannot be read, or chooses what there is not.
pub fn plans(sources: &[Source], filter: Option<&Regex>) -> Result<Vec<Plan>, Failure> {
    let mut plans: Vec<Plan> = Vec::new();
    for (origin, experiment) in here(sources)? {
        let plan = Plan::new(origin, experiment, filter)?;
        if plans.iter().any(|other| other.experiment.id == plan.experiment.id) {
            return Err(Failure::Usage(format!(
                "{origin}: id '{}' stands in two files; allowed: one",
                plan.experiment.id
            )));
        }
        plans.push(plan);
    }
    if filter.is_some() && !plans.is_empty() {
        plans.retain(|plan| !plan.variants.is_empty() && plan.experiment.workload.has_variants());
        if plans.is_empty() {
            return Err(Failure::Usage(
                "--filter: no experiment has a variant that matches; `ray_test list variants` \
                 shows the ids"
                    .to_owned(),
            ));
        }
    }
    Ok(plans)
}

/// The experiments with their files; those of which the variants are not in this build are left out,
/// and named.
fn here(sources: &[Source]) -> Result<Vec<(&str, Experiment)>, Failure> {
    let mut experiments = Vec::new();
    let mut skipped: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (origin, text) in sources {
        let experiment = Experiment::parse(origin, text)?;
        if experiment.is_of_another_build() {
            skipped.entry(experiment.feature).or_default().push(experiment.id);
        } else {
            experiments.push((origin.as_str(), experiment));
        }
    }
    for (feature, ids) in skipped {
        say!(
            "skipped {} ({}): this build lacks the feature '{feature}'; `cargo build --release \
             --features {feature}` has it",
            ids.len(),
            ids.join(", ")
        );
    }
    Ok(experiments)
}

/// Runs plan by plan; each is saved when it is done, and saved as unfinished when interrupted. Gives
/// the variants that were wrong.
fn measure(
    plans: &[Plan],
    before: Vec<Before>,
    batch: &Batch,
    folder: &Folder,
    mut instruments: Instruments,
) -> Result<Vec<String>, Failure> {
    let profile = batch.profile.value();
    let cancel = interrupt::flag();
    let bar = progress::bar(plans.iter().map(|plan| plan.blocks(profile)).sum());
    let mut wrong: Vec<String> = Vec::new();
    let seconds: f64 = plans.iter().map(|plan| plan.seconds(profile)).sum();
    instruments.begin_run(profile.rounds());
    for (plan, before) in plans.iter().zip(before) {
        let id = plan.experiment.id.clone();
        if let Before::Finished(before) = before {
            wrong.extend(before.iter().map(|variant| format!("{id}: {variant}")));
            bar.inc(plan.blocks(profile) as u64);
            say!("{id}: finished before");
            continue;
        }
        if cancel.load(Ordering::Relaxed) {
            return Err(interrupted(folder));
        }
        bar.set_message(id.clone());
        let start = Instant::now();
        let mut keeper = folder.begin(plan, before)?;
        let mut progress = |blocks: usize| bar.inc(blocks as u64);
        instruments.grant(plan.seconds(profile) / seconds.max(f64::MIN_POSITIVE), profile.rounds());
        let bench = &mut instruments.bench(profile.rounds(), &mut progress, cancel, &mut keeper);
        let outcome = run_plan(plan, bench)?;
        folder.save(plan, &outcome)?;
        bar.suspend(|| said(&id, &outcome, start.elapsed()));
        wrong.extend(outcome.wrong.iter().map(|variant| format!("{id}: {variant}")));
        // Told to end after its last block, it is whole, and what comes next is not begun.
        if outcome.interrupted || cancel.load(Ordering::Relaxed) {
            bar.finish_and_clear();
            // Everything is saved: a stdout that is closed does not change what came of it.
            let _ = unfinished::print_rows(&outcome.rows, &folder.table(plan));
            return Err(interrupted(folder));
        }
    }
    bar.finish_and_clear();
    Ok(wrong)
}

/// What stands at the end of a run: stiff cases, the report, where it all is.
fn conclude(
    sweep: Option<&Sweep>,
    batch: &Batch,
    folder: &Folder,
    wrong: Vec<String>,
) -> Result<(), Failure> {
    if let Some(sweep) = sweep
        && !sweep_once(folder, sweep, batch.resume)?
    {
        return Err(interrupted(folder));
    }
    let results = read(&[folder.path().to_owned()])?;
    let summary = publish(&results, folder.path())?;
    // Everything is saved: a stdout that is closed does not change what came of it.
    let _ = writeln!(std::io::stdout(), "{summary}{}", folder.path().display());
    if wrong.is_empty() { Ok(()) } else { Err(Failure::Wrong(wrong)) }
}

/// Draws what was measured, and says how to go on. Parts have no figures: those of a part would show
/// a part.
pub fn interrupted(folder: &Folder) -> Failure {
    let path = folder.path();
    let draw = || match read(&[path.to_owned()]) {
        // It was interrupted before anything was measured.
        Err(LoadError::Nothing(_)) => Ok(()),
        results => draw_all(&results?, path),
    };
    // A picture that cannot be drawn does not change that everything else is saved.
    if !folder.is_of_shard()
        && let Err(failure) = draw()
    {
        failure.print();
    }
    say_how_to_go_on(path, "");
    Failure::Interrupted
}

/// Of a run that failed on its way, a full disk say: what it had measured is not lost.
fn say_where_it_stands(failure: &Failure, folder: &Folder) {
    if matches!(failure, Failure::Runtime(_)) {
        say_how_to_go_on(folder.path(), ", once the cause below is mended");
    }
}

fn say_how_to_go_on(folder: &Path, when: &str) {
    let command = unfinished::resume_command(std::env::args_os(), folder);
    say!("what was measured is saved; to go on{when}:\n  {command}");
}

/// A line per experiment, on stderr.
pub fn said(id: &str, outcome: &Outcome, time: Duration) {
    let of = |status: &str| outcome.rows.iter().filter(|row| row.status == status).count();
    let mut notes = String::new();
    for status in ["skipped", "wrong-result", "invalid", "not-measured"] {
        if of(status) > 0 {
            notes += &format!(", {} {status}", of(status));
        }
    }
    let rows = count(outcome.rows.len(), "row", "rows");
    say!("{id}: {rows}, {:.1} s{notes}", time.as_secs_f64());
}

/// What rows depend on besides experiment, program and machine.
fn settings(batch: &Batch) -> String {
    let profile = format!("--profile {:?}", batch.profile).to_lowercase();
    let filter = batch.filter.as_ref().map(|filter| format!(" --filter {filter}"));
    let shard = batch.shard.map(|shard| format!(" --shard {shard}"));
    profile + filter.as_deref().unwrap_or("") + shard.as_deref().unwrap_or("")
}

/// Of everything that tells runs apart: experiments, profile, filter, build, machine.
fn config_hash(plans: &[Plan], sources: &[Source], batch: &Batch, here: &Environment) -> u64 {
    let mut hash = Fnv::default();
    for plan in plans {
        hash.bytes(plan.experiment.id.as_bytes());
    }
    for (_, text) in sources {
        hash.bytes(text.as_bytes());
    }
    hash.bytes(format!("{:?}", batch.profile).as_bytes());
    hash.bytes(batch.filter.as_deref().unwrap_or("").as_bytes());
    hash.bytes(batch.shard.unwrap_or_default().to_string().as_bytes());
    hash.bytes(format!("{:?}", here.build).as_bytes());
    hash.bytes(here.testbed_id.as_bytes());
    hash.finish()
}

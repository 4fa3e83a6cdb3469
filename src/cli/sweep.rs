//! The sweep over stiff cases into the folder of a run: of `stability`, and at the end of `reproduce`.

use std::time::Instant;

use super::failure::Failure;
use super::folder::Folder;
use super::publish::draw_chapter;
use super::stored::workload_hash;
use super::{interrupt, progress};
use crate::chart::stability_figures;
use crate::experiment::Profile;
use crate::report::count;
use crate::results::{About, Chapter, ROWS, TABLE};
use crate::shard::Shard;
use crate::spread::Watch;
use crate::stability::{Depth, EXPERIMENT, Form, Outcome, Sweep, families, forms};
use crate::table::{RunFile, SCHEMA_VERSION, make_folder, write_csv, write_json};

/// The sweep of a run of that profile, over the forms that a filter lets through; `None` if it lets
/// none through.
pub fn of_profile(
    profile: Profile,
    filter: Option<&regex::Regex>,
    shard: Option<Shard>,
) -> Option<Sweep> {
    let depth = match profile {
        Profile::Quick => Depth::Quick,
        Profile::Standard => Depth::Standard,
        Profile::Thorough => Depth::Thorough,
    };
    // Without words there is none that is not known.
    let mut forms: Vec<Form> = forms(&[], None).unwrap_or_default();
    forms.retain(|form| filter.is_none_or(|filter| filter.is_match(&form.asked.id())));
    let shard = shard.unwrap_or_default();
    (!forms.is_empty()).then(|| Sweep { families: families(), forms, depth, seed: 1, shard })
}

/// What tells sweeps apart, where the text of a file tells experiments apart.
fn text_of(sweep: &Sweep) -> String {
    let families: Vec<&str> = sweep.families.iter().map(|family| family.id).collect();
    let forms: Vec<String> = sweep.forms.iter().map(|form| form.asked.id()).collect();
    format!(
        "{:?}, seed {}, families {}, forms {}",
        sweep.depth,
        sweep.seed,
        families.join(" "),
        forms.join(" ")
    )
}

/// Sweeps, shows how far it is, writes rows.
///
/// # Errors
/// When a file cannot be written.
pub fn sweep_into(folder: &Folder, sweep: &Sweep) -> Result<Outcome, Failure> {
    let bar = progress::bar(sweep.pieces());
    bar.set_message(EXPERIMENT);
    let start = Instant::now();
    let done = |_: usize| bar.inc(1);
    let outcome = sweep.run(&Watch { cancel: interrupt::flag(), done: &done, threads: None });
    bar.finish_and_clear();
    save(folder, &outcome, sweep)?;
    let seconds = start.elapsed().as_secs_f64();
    say!("{EXPERIMENT}: {}, {seconds:.1} s", count(outcome.rows.len(), "row", "rows"));
    Ok(outcome)
}

/// The same at the end of a run, unless that is gone on with and has been here before; whether all
/// of it is there.
///
/// # Errors
/// When a file cannot be written, or what is there is of another sweep.
pub fn sweep_once(folder: &Folder, sweep: &Sweep, resume: bool) -> Result<bool, Failure> {
    if resume && folder.finished(EXPERIMENT, &text_of(sweep))?.is_some() {
        say!("{EXPERIMENT}: finished before");
        return Ok(true);
    }
    Ok(sweep_into(folder, sweep)?.complete)
}

/// Draws the figures of a whole sweep that stands alone; gives how many.
///
/// # Errors
/// When a file cannot be written.
pub fn draw(folder: &Folder, outcome: &Outcome) -> Result<usize, Failure> {
    let figures = stability_figures(&outcome.rows);
    let about = About { figures, ..About::unknown(EXPERIMENT) };
    let chapter = Chapter { about, rows: outcome.rows.clone(), ..Chapter::default() };
    draw_chapter(&chapter, &[], &folder.path().join(EXPERIMENT))
}

/// Writes the rows.
fn save(folder: &Folder, outcome: &Outcome, sweep: &Sweep) -> Result<(), Failure> {
    let path = folder.path().join(EXPERIMENT);
    make_folder(&path)?;
    write_csv(&path.join(TABLE), &outcome.rows)?;
    let environment = folder.circumstances(&text_of(sweep), outcome.complete, &outcome.places)?;
    let run = RunFile {
        schema_version: SCHEMA_VERSION.to_owned(),
        environment,
        seed: sweep.seed,
        workload_hash: workload_hash(EXPERIMENT, &outcome.rows),
        rows: outcome.rows.clone(),
    };
    // Last: it says that everything is there.
    Ok(write_json(&path.join(ROWS), &run)?)
}

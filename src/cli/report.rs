//! `ray_test report`: everything that a reader opens, made again from stored rows.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;

use super::failure::Failure;
use super::publish::{publish, read};
use super::stored;
use crate::results::{ENVIRONMENT, JOURNAL, LoadError, ROWS, Results};
use crate::table::try_folder;

/// What is said below the options.
pub const HELP: &str = "Examples:
  ray_test report results/mine
  ray_test report results/laptop results/server --out results/both
  ray_test report results/part-1 results/part-2 results/part-3 --out results/whole

Folders of one machine and build are put together as one, as are the parts that --shard makes.
Folders of several machines, or builds, are compared: the column `machine` tells their rows apart.";

/// `ray_test report`
#[derive(Args, Debug)]
pub struct Report {
    /// Folders of runs, or of single experiments of them
    #[arg(required = true, value_name = "DIR")]
    pub folders: Vec<PathBuf>,
    /// Folder for what is made [default: DIR, if it is only one and that of a run; several must
    /// have another, which gets their rows as well]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Reads, puts together, writes.
///
/// # Errors
/// Usage for folders that hold no results or broken ones, and for an unusable `--out`.
pub fn run(arguments: &Report) -> Result<(), Failure> {
    let (out, is_own) = out(arguments)?;
    let results = read(&arguments.folders)?;
    say(&results);
    try_folder(&out).map_err(|error| {
        Failure::Usage(format!(
            "--out: {} cannot be written: {error}; allowed: a folder that can be created or written",
            out.display()
        ))
    })?;
    if !is_own {
        stored::write(&results, &out)?;
    }
    let summary = publish(&results, &out)?;
    writeln!(std::io::stdout(), "{summary}{}", out.display())?;
    Ok(())
}

/// Where everything goes, and whether that is the folder that it comes from, whose rows stay as
/// they are: its run may yet be gone on with.
fn out(arguments: &Report) -> Result<(PathBuf, bool), Failure> {
    let same = |folder: &PathBuf, out: &Path| matches!((folder.canonicalize(), out.canonicalize()), (Ok(one), Ok(other)) if one == other);
    match (&arguments.out, arguments.folders.as_slice()) {
        (None, [only]) if is_experiment(only) => Err(Failure::Usage(format!(
            "--out: {} is the folder of one experiment; allowed: a folder for its report",
            only.display()
        ))),
        (None, [only]) => Ok((only.clone(), true)),
        (None, folders) => Err(Failure::Usage(format!(
            "--out: {} folders are put together; allowed: a folder for what comes of them",
            folders.len()
        ))),
        (Some(out), [only]) if same(only, out) && !is_experiment(only) => Ok((only.clone(), true)),
        (Some(out), folders) => {
            if let Some(folder) = folders.iter().find(|folder| same(folder, out)) {
                return Err(Failure::Usage(format!(
                    "--out: {} is one of the folders that are put together, and would be lost in \
                     what comes of them; allowed: another folder",
                    folder.display()
                )));
            }
            Ok((out.clone(), false))
        }
    }
}

/// Whether a folder is that of one experiment.
fn is_experiment(folder: &Path) -> bool {
    [ROWS, JOURNAL].iter().any(|name| folder.join(name).is_file())
}

/// What was found, on stderr.
fn say(results: &Results) {
    for source in &results.sources {
        let folders = source.folders.join(", ");
        if source.environment.is_object() {
            say!("{}: {folders}", source.label);
        } else {
            say!("note: {}: {folders} without {ENVIRONMENT}", source.label);
        }
    }
    for chapter in &results.chapters {
        let id = &chapter.about.id;
        if !chapter.complete {
            say!("note: {id}: of an interrupted run, or a part is missing; shown is what it has");
        }
        if chapter.about.figures.is_empty() {
            say!("note: {id}: no experiment of that name is known; it has no figures");
        }
    }
}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Self {
        Failure::Usage(error.to_string())
    }
}

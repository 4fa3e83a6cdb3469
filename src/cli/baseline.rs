//! Named baselines: a run that is kept, so that later ones can be held against it.

use std::path::{Path, PathBuf};

use clap::Args;

use super::compare::{CompareFormat, report};
use super::failure::Failure;
use crate::compare::{Side, Threshold};
use crate::measure::BuildInfo;
use crate::results::ROWS;
use crate::table::{TableError, make_folder, try_folder, write_atomically};

/// What `run` and `reproduce` do with baselines.
#[derive(Args, Debug)]
pub struct Baselines {
    /// Keep the results as results/baselines/NAME
    #[arg(long, value_name = "NAME", value_parser = name_of, conflicts_with = "baseline")]
    pub save_baseline: Option<String>,
    /// Compare the results with results/baselines/NAME; exit 3 if something got worse
    #[arg(long, value_name = "NAME", value_parser = name_of)]
    pub baseline: Option<String>,
    /// With --baseline: from when on a change of time counts, such as 3% or 0.03
    #[arg(long, default_value = "3%", requires = "baseline")]
    pub threshold: Threshold,
}

/// Where they are kept, relative to the current folder.
const FOLDER: &str = "results/baselines";

/// A baseline's name: it is a folder's name as well, so it cannot lead anywhere else.
fn name_of(text: &str) -> Result<String, &'static str> {
    let allowed = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.');
    if text.is_empty() || text.starts_with('.') || !text.chars().all(allowed) {
        return Err("allowed: letters, digits, '-', '_' and '.', the last not at the start");
    }
    Ok(text.to_owned())
}

impl Baselines {
    /// Refuses what cannot be saved or compared, before anything runs.
    ///
    /// # Errors
    /// Usage: a debug build cannot be saved; a baseline that is not there, or has none of the
    /// experiments, cannot be compared with.
    pub fn check(&self, experiments: &[String]) -> Result<(), Failure> {
        if self.save_baseline.is_some() && BuildInfo::of_this_program().debug_assertions {
            return Err(Failure::Usage(
                "--save-baseline: times of a debug build mean nothing; allowed: a release build"
                    .to_owned(),
            ));
        }
        match &self.baseline {
            Some(name) => stored(Path::new(FOLDER), name, experiments).map(|_| ()),
            None => Ok(()),
        }
    }

    /// Finds out whether a run could be saved, before it runs.
    ///
    /// # Errors
    /// Usage, if it could not.
    pub fn prepare(&self) -> Result<(), Failure> {
        let Some(name) = &self.save_baseline else { return Ok(()) };
        let folder = Path::new(FOLDER);
        let place = folder.join(name);
        // The folder of the baseline itself is made when there is something to keep.
        let tried = if place.exists() { try_folder(&place) } else { try_folder(folder) };
        tried.map_err(|error| {
            Failure::Usage(format!(
                "--save-baseline: {} cannot be written: {error}; allowed: a current folder that \
                 can be written, and no file of that name",
                place.display()
            ))
        })
    }

    /// Saves or compares a run that has ended well, or with wrong answers; those are the worse
    /// failure, and are never saved.
    ///
    /// # Errors
    /// The run's own; a regression; files that cannot be read or written.
    pub fn finish(
        &self,
        ended: Result<(), Failure>,
        run: &Path,
        experiments: &[String],
    ) -> Result<(), Failure> {
        match (&self.save_baseline, &self.baseline) {
            (Some(name), _) if ended.is_ok() => save(run, experiments, Path::new(FOLDER), name),
            (_, Some(name)) if matches!(ended, Ok(()) | Err(Failure::Wrong(_))) => {
                let base = stored(Path::new(FOLDER), name, experiments)?;
                let new = Side::read_experiments(run, experiments)?;
                let compared = report(&base, &new, self.threshold, CompareFormat::Text);
                ended.and(compared)
            }
            (Some(name), _) => {
                say!("not saved as baseline {name}: the run did not end well");
                ended
            }
            _ => ended,
        }
    }
}

/// Those of the experiments that a baseline has.
fn stored(folder: &Path, name: &str, experiments: &[String]) -> Result<Side, Failure> {
    let path = folder.join(name);
    if !path.is_dir() {
        let known = names(folder);
        let known = if known.is_empty() { "none yet".to_owned() } else { known.join(", ") };
        return Err(Failure::Usage(format!(
            "--baseline: there is no {}; there is: {known}; --save-baseline makes one",
            path.display()
        )));
    }
    Side::read_experiments(&path, experiments).map_err(|error| {
        Failure::Usage(format!("--baseline: of {}: {error}", experiments.join(", ")))
    })
}

/// The baselines that there are.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let folders = entries.filter(|entry| entry.path().is_dir());
    let mut names: Vec<String> =
        folders.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Copies the rows of a run. Experiments that the baseline has and the run has not are kept.
fn save(run: &Path, experiments: &[String], folder: &Path, name: &str) -> Result<(), Failure> {
    for id in experiments {
        let file = run.join(id).join(ROWS);
        let bytes = std::fs::read(&file).map_err(|source| TableError::Io { file, source })?;
        let target: PathBuf = folder.join(name).join(id);
        make_folder(&target)?;
        write_atomically(&target.join(ROWS), &bytes)?;
    }
    say!("saved as baseline {}", folder.join(name).display());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_stays_in_its_folder() {
        for name in ["main", "v1.2", "a_b-c", "0"] {
            assert_eq!(name_of(name).as_deref(), Ok(name));
        }
        for name in ["", ".", "..", ".hidden", "a/b", "a\\b", "a b", "a:b", "../x"] {
            assert!(name_of(name).is_err(), "{name}");
        }
    }

    #[test]
    fn a_missing_baseline_is_told_with_those_that_are_there() {
        let folder = std::env::temp_dir().join(format!("ray_test-names-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("b")).unwrap();
        std::fs::create_dir_all(folder.join("a")).unwrap();
        let missing = stored(&folder, "c", &["b-4.2".to_owned()]);
        let empty = stored(&folder, "a", &["b-4.2".to_owned()]);
        std::fs::remove_dir_all(&folder).unwrap();
        let (Err(Failure::Usage(missing)), Err(Failure::Usage(empty))) = (missing, empty) else {
            panic!("both are wrong usage");
        };
        assert!(missing.contains("there is: a, b;"), "{missing}");
        assert!(empty.contains("b-4.2") && empty.contains("no rows.json"), "{empty}");
    }

    #[test]
    fn what_is_saved_is_what_was_run() {
        let folder = std::env::temp_dir().join(format!("ray_test-saved-{}", std::process::id()));
        let run = folder.join("run");
        std::fs::create_dir_all(run.join("x")).unwrap();
        std::fs::write(run.join("x/rows.json"), "rows").unwrap();
        let saved = save(&run, &["x".to_owned()], &folder, "name");
        let read = std::fs::read_to_string(folder.join("name/x/rows.json"));
        let lost = save(&run, &["y".to_owned()], &folder, "name");
        std::fs::remove_dir_all(&folder).unwrap();
        assert!(saved.is_ok());
        assert_eq!(read.unwrap(), "rows");
        assert_eq!(lost.unwrap_err().code(), 1);
    }
}

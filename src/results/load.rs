//! Folders -> parts -> results.

use super::files::{COMPLETE, DESCRIPTION, ENVIRONMENT, JOURNAL, ROWS, SHARD, SOURCES};
use super::merge::merge;
use super::part::{Part, Share};
use super::{About, LoadError, Results};
use crate::table::{Row, RunFile, read_journal, read_json};
use serde_json::Value;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

/// Tells what an experiment asks, from its id and from its text where that was stored; `None` if
/// nobody knows.
pub type Describe<'a> = &'a dyn Fn(&str, Option<&str>) -> Option<About>;

/// Reads folders of results, each that of a run or of one experiment, and puts them together. Runs
/// that were interrupted are read with what is there, and marked as not complete.
///
/// # Errors
/// For files that cannot be read or are broken, and folders that hold no results.
pub fn load(folders: &[PathBuf], describe: Describe<'_>) -> Result<Results, LoadError> {
    let mut parts = Vec::new();
    for folder in folders {
        let found = parts_of(folder)?;
        if found.is_empty() {
            return Err(LoadError::Nothing(folder.clone()));
        }
        parts.push(found);
    }
    Ok(merge(parts, describe))
}

/// What a folder holds, experiment by experiment.
fn parts_of(folder: &Path) -> Result<Vec<Part>, LoadError> {
    let failed = |source| LoadError::Io { file: folder.to_owned(), source };
    let mut parts = Vec::new();
    if holds_rows(folder) {
        let above = folder.parent().unwrap_or(Path::new(""));
        let environment =
            environment(folder)?.map_or_else(|| environment(above), |one| Ok(Some(one)));
        parts.extend(part(folder, folder, environment?.as_ref())?);
        return Ok(parts);
    }
    let environment = environment(folder)?;
    let mut inner = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        inner.push(entry.map_err(failed)?.path());
    }
    inner.sort();
    for experiment in inner.iter().filter(|path| holds_rows(path)) {
        parts.extend(part(folder, experiment, environment.as_ref())?);
    }
    Ok(parts)
}

fn holds_rows(folder: &Path) -> bool {
    [ROWS, JOURNAL].iter().any(|name| folder.join(name).is_file())
}

/// The `environment.json` of a folder, if it has one.
fn environment(folder: &Path) -> Result<Option<Value>, LoadError> {
    let file = folder.join(ENVIRONMENT);
    let Some(bytes) = optional(&file)? else { return Ok(None) };
    let environment = serde_json::from_slice(&bytes);
    environment
        .map(Some)
        .map_err(|error| LoadError::Environment { file, message: error.to_string() })
}

/// The bytes of a file that need not be there.
fn optional(file: &Path) -> Result<Option<Vec<u8>>, LoadError> {
    match std::fs::read(file) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(source) => Err(LoadError::Io { file: file.to_owned(), source }),
    }
}

/// An experiment's folder; several parts if it was put together from several sources before.
fn part(
    folder: &Path,
    experiment: &Path,
    environment: Option<&Value>,
) -> Result<Vec<Part>, LoadError> {
    let file = experiment.join(ROWS);
    let finished = if file.is_file() { Some(read_json(&file)?) } else { None };
    let journal = experiment.join(JOURNAL);
    let begun: Option<Vec<Row>> = read_journal(&journal)?
        .map(|journal| journal.pieces.into_iter().flat_map(|(_, rows)| rows).collect());
    let text = optional(&experiment.join(DESCRIPTION))?;
    let text = text.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    let part = Part {
        folder: folder.display().to_string(),
        experiment: id(experiment, finished.as_ref(), begun.as_deref())?,
        text,
        ..of_rows(finished, begun, environment)
    };
    Ok(part.by_source())
}

/// The experiment that rows are of: what they say, or the name of their folder.
fn id(
    folder: &Path,
    finished: Option<&RunFile>,
    begun: Option<&[Row]>,
) -> Result<String, LoadError> {
    let rows = finished.map(|run| run.rows.as_slice()).into_iter().chain(begun).flatten();
    let named = rows.map(|row| row.experiment.as_str()).find(|id| !id.is_empty());
    // Without a name of its own, as `.`, the folder has one all the same.
    let path = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
    match named {
        Some(id) if !is_a_name(id) => {
            Err(LoadError::Id { file: folder.to_owned(), id: id.to_owned() })
        }
        named => Ok(named.map(str::to_owned).or(name).unwrap_or_default()),
    }
}

/// Whether an id is one of the names that a folder below another can have: what is made of the rows is
/// written into one of that name.
fn is_a_name(id: &str) -> bool {
    let mut parts = Path::new(id).components();
    let is_one = matches!(parts.next(), Some(Component::Normal(part)) if part == id);
    is_one && id.len() <= MOST_BYTES && !id.contains(|c: char| c == '\\' || c.is_control())
}

/// The names of folders are no longer than this anywhere.
const MOST_BYTES: usize = 255;

/// Rows of a file, of a journal, or of both: an interrupted run saves its file and keeps its
/// journal, and what goes on with it adds to the journal alone. The one that has more counts.
fn of_rows(
    finished: Option<RunFile>,
    begun: Option<Vec<Row>>,
    environment: Option<&Value>,
) -> Part {
    let measured =
        |run: &RunFile| run.rows.iter().filter(|row| row.status != "not-measured").count();
    let has_journal = begun.is_some();
    let begun = begun.unwrap_or_default();
    match finished {
        Some(run) if !has_journal || measured(&run) >= begun.len() => {
            let complete = run.environment.get(COMPLETE).and_then(Value::as_bool);
            Part {
                share: Share::of(run.environment.get(SHARD), run.rows.len()),
                // Files of before this field was there were written at the end only.
                complete: complete.unwrap_or(true) && !has_journal,
                workload_hash: run.workload_hash,
                environment: own(run.environment, environment),
                rows: run.rows,
                ..Part::default()
            }
        }
        _ => {
            let environment = environment.cloned().unwrap_or_default();
            Part { rows: begun, environment, ..Part::default() }
        }
    }
}

/// Whether a file says itself what it was measured on; else what its folder says.
fn own(of_file: Value, of_folder: Option<&Value>) -> Value {
    let says = of_file.get("testbed_id").is_some() || of_file.get(SOURCES).is_some();
    match of_folder {
        Some(folder) if !says => folder.clone(),
        _ => of_file,
    }
}

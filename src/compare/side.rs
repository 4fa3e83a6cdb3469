//! One side of a comparison: a file of rows, or a folder of them.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::table::{Row, RunFile, TableError, read_json};

/// A file of rows and where it was read from.
#[derive(Clone, Debug)]
pub struct Source {
    /// The file.
    pub path: PathBuf,
    /// What is in it.
    pub run: RunFile,
}

/// One side of a comparison. It has at least one row.
#[derive(Clone, Debug)]
pub struct Side {
    /// Its files, in alphabetical order.
    pub sources: Vec<Source>,
}

/// Why there is nothing to compare.
#[derive(Debug, thiserror::Error)]
pub enum InputError {
    /// A file cannot be read, or is none of ours.
    #[error("{0}; allowed: a rows.json, or the folder of a run")]
    Table(#[from] TableError),
    /// A folder without results.
    #[error("{}: no rows.json in it or in a folder of it; allowed: a rows.json, or the folder of a run", .0.display())]
    Nothing(PathBuf),
    /// Files without rows.
    #[error("{}: no rows; allowed: at least one", .0.display())]
    NoRows(PathBuf),
}

/// The name of the files.
const ROWS: &str = "rows.json";

impl Side {
    /// Reads a file; of a folder its own `rows.json`, or else that of every folder in it.
    ///
    /// # Errors
    /// When there is no such file, it cannot be read, or there are no rows.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        if !path.is_dir() {
            return Side::of_files(path, vec![path.to_owned()]);
        }
        let own = path.join(ROWS);
        if own.is_file() {
            return Side::of_files(path, vec![own]);
        }
        Side::of_files(path, files_in(path)?)
    }

    /// Reads those of the experiments that a folder has.
    ///
    /// # Errors
    /// As [`Side::read`].
    pub fn read_experiments(folder: &Path, ids: &[String]) -> Result<Self, InputError> {
        let files = ids.iter().map(|id| folder.join(id).join(ROWS));
        Side::of_files(folder, files.filter(|file| file.is_file()).collect())
    }

    fn of_files(from: &Path, files: Vec<PathBuf>) -> Result<Self, InputError> {
        if files.is_empty() {
            return Err(InputError::Nothing(from.to_owned()));
        }
        let read = |path: PathBuf| Ok(Source { run: read_json(&path)?, path });
        let sources = files.into_iter().map(read).collect::<Result<Vec<_>, InputError>>()?;
        if sources.iter().all(|source| source.run.rows.is_empty()) {
            return Err(InputError::NoRows(from.to_owned()));
        }
        Ok(Side { sources })
    }

    /// All rows, file by file.
    pub fn rows(&self) -> impl Iterator<Item = &Row> {
        self.sources.iter().flat_map(|source| &source.run.rows)
    }

    /// Files of runs that were interrupted.
    pub fn unfinished(&self) -> impl Iterator<Item = &Path> {
        let unfinished =
            |source: &&Source| source.field("/complete").and_then(Value::as_bool) == Some(false);
        self.sources.iter().filter(unfinished).map(|source| source.path.as_path())
    }
}

impl Source {
    /// A field of the environment, by its JSON pointer.
    pub fn field(&self, pointer: &str) -> Option<&Value> {
        self.run.environment.pointer(pointer).filter(|value| !value.is_null())
    }
}

fn files_in(folder: &Path) -> Result<Vec<PathBuf>, InputError> {
    let failed = |source| InputError::Table(TableError::Io { file: folder.to_owned(), source });
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let file = entry.map_err(failed)?.path().join(ROWS);
        if file.is_file() {
            files.push(file);
        }
    }
    files.sort();
    Ok(files)
}

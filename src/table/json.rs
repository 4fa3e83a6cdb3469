//! Rows, and what they were measured on, to and from JSON.

use super::{COLUMNS, REQUIRED, Row, TableError, write_atomically};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::path::Path;

/// Version of the form of `rows.json`. A larger first number means that old readers cannot read it.
pub const SCHEMA_VERSION: &str = "1.0";

/// Everything in `rows.json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RunFile {
    /// Version of the form, [`SCHEMA_VERSION`] when written by this program.
    pub schema_version: String,
    /// The machine, the compiler, the versions.
    pub environment: Value,
    /// Seed that the workloads were drawn with.
    pub seed: u64,
    /// Hash of the workloads.
    pub workload_hash: String,
    /// The rows, the same as in `rows.csv`.
    pub rows: Vec<Row>,
}

/// A run file before its rows are looked at, so that each bad cell can be named.
#[derive(Deserialize)]
struct Raw {
    schema_version: String,
    #[serde(default)]
    environment: Value,
    seed: u64,
    workload_hash: String,
    rows: Vec<Map<String, Value>>,
}

/// Writes a run file, each row on a line of its own.
pub fn write_json(path: &Path, run: &RunFile) -> Result<(), TableError> {
    let head = RunFile { rows: Vec::new(), ..run.clone() };
    let mut text = serde_json::to_string_pretty(&head).map_err(|error| syntax(path, &error))?;
    // The rows are the last field; there are none yet.
    let end = text.rfind("[]").unwrap_or(text.len());
    text.truncate(end);
    text.push('[');
    for (index, row) in run.rows.iter().enumerate() {
        text.push_str(if index == 0 { "\n    " } else { ",\n    " });
        text += &serde_json::to_string(row).map_err(|error| syntax(path, &error))?;
    }
    text.push_str("\n  ]\n}\n");
    write_atomically(path, text.as_bytes())
}

/// Reads a run file; names the row and the column of what is wrong, and what is allowed there.
pub fn read_json(path: &Path) -> Result<RunFile, TableError> {
    let text =
        std::fs::read(path).map_err(|source| TableError::Io { file: path.to_owned(), source })?;
    let raw: Raw = serde_json::from_slice(&text).map_err(|error| syntax(path, &error))?;
    version_is_known(path, &raw.schema_version)?;
    let rows = raw.rows.iter().enumerate();
    let rows = rows.map(|(index, cells)| row(path, format!("row {}", index + 1), cells));
    Ok(RunFile {
        rows: rows.collect::<Result<_, _>>()?,
        schema_version: raw.schema_version,
        environment: raw.environment,
        seed: raw.seed,
        workload_hash: raw.workload_hash,
    })
}

/// Refuses a version whose form this program does not know.
pub(super) fn version_is_known(path: &Path, found: &str) -> Result<(), TableError> {
    let major = |version: &str| version.split('.').next().map(str::to_owned);
    if major(found) == major(SCHEMA_VERSION) {
        return Ok(());
    }
    let (file, found) = (path.to_owned(), found.to_owned());
    Err(TableError::Schema { file, found, allowed: SCHEMA_VERSION })
}

/// The row of an object; `place` is where it stands.
pub(super) fn row(
    path: &Path,
    place: String,
    cells: &Map<String, Value>,
) -> Result<Row, TableError> {
    // Rows that say what they are about leave out what is empty.
    let is_sparse = cells.contains_key("record");
    let missing = |column: &&&str| !is_sparse && !cells.contains_key(**column);
    if let Some(column) = COLUMNS[..REQUIRED].iter().find(missing) {
        return Err(TableError::MissingColumn { file: path.to_owned(), column });
    }
    let mut row = Row::default();
    for (column, value) in cells {
        let text = match value {
            Value::Null => continue,
            Value::String(text) => text.clone(),
            other => other.to_string(),
        };
        row.set(column, &text)
            .map_err(|allowed| TableError::cell(path, place.clone(), column, &text, allowed))?;
    }
    Ok(row)
}

fn syntax(path: &Path, error: &serde_json::Error) -> TableError {
    let (file, line) = (path.to_owned(), error.line() as u64);
    TableError::Syntax { file, line, message: error.to_string() }
}

//! The journal of a run that is not finished: rows as lines of JSON, appended while they are
//! measured, so that whatever ends the program loses no more than what it was measuring.
//!
//! The first line is a [`Header`]. Each other line is a row with two keys more: `piece`, the name
//! of the rows that were measured together, and `rows_of_piece`, how many those are. A piece of
//! which a row is missing is not there.

use super::json::{row, version_is_known};
use super::{Row, RunKey, SCHEMA_VERSION, TableError, write_atomically};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// The first line.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Header {
    /// Version of the form, [`SCHEMA_VERSION`] when written by this program.
    pub schema_version: String,
    /// What must be the same for the run to be gone on with.
    pub run_key: RunKey,
    /// Id of the experiment.
    pub experiment: String,
    /// Seed that its workloads are drawn with.
    pub seed: u64,
}

/// A row as it stands in a line.
#[derive(Serialize)]
struct Line<'a> {
    piece: &'a str,
    rows_of_piece: usize,
    #[serde(flatten)]
    row: &'a Row,
}

/// What a journal holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Journaled {
    /// Its first line.
    pub header: Header,
    /// The pieces that are whole, by name, in the order of the file.
    pub pieces: Vec<(String, Vec<Row>)>,
}

/// A journal that is being written.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
}

impl Journal {
    /// Begins a journal in place of what was there, with pieces that were measured before.
    pub fn begin(path: &Path, contents: &Journaled) -> Result<Self, TableError> {
        let json = |error| syntax(path, 0, &error);
        let mut bytes = serde_json::to_vec(&contents.header).map_err(json)?;
        bytes.push(b'\n');
        for (piece, rows) in &contents.pieces {
            for line in lines(piece, rows) {
                bytes.extend(line.map_err(json)?);
            }
        }
        write_atomically(path, &bytes)?;
        let opened = OpenOptions::new().append(true).open(path);
        let file = opened.map_err(|source| TableError::Io { file: path.to_owned(), source })?;
        Ok(Journal { path: path.to_owned(), file })
    }

    /// Appends the rows of a piece, each line whole by one write, and syncs them to the disk.
    pub fn append(&mut self, piece: &str, rows: &[Row]) -> Result<(), TableError> {
        let failed = |source| TableError::Io { file: self.path.clone(), source };
        for line in lines(piece, rows) {
            let line = line.map_err(|error| syntax(&self.path, 0, &error))?;
            self.file.write_all(&line).map_err(failed)?;
        }
        self.file.sync_data().map_err(failed)
    }
}

/// The lines of a piece, with their ends.
fn lines<'a>(
    piece: &'a str,
    rows: &'a [Row],
) -> impl Iterator<Item = Result<Vec<u8>, serde_json::Error>> + 'a {
    rows.iter().map(move |row| {
        let mut line = serde_json::to_vec(&Line { piece, rows_of_piece: rows.len(), row })?;
        line.push(b'\n');
        Ok(line)
    })
}

/// Reads a journal; `None` if there is none. A last line that was cut, so that it has no end or is
/// no JSON, is dropped, and so are pieces that are not whole; any other bad line is named.
pub fn read_journal(path: &Path) -> Result<Option<Journaled>, TableError> {
    let bytes = match std::fs::read(path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(source) => return Err(TableError::Io { file: path.to_owned(), source }),
    };
    let mut lines: Vec<&[u8]> = bytes.split(|byte| *byte == b'\n').collect();
    // What stands behind the last end of a line: nothing, or a line that was cut.
    lines.pop();
    let header = header(path, lines.first().copied().unwrap_or_default())?;
    let mut pieces: Vec<(String, usize, Vec<Row>)> = Vec::new();
    for (index, line) in lines.iter().enumerate().skip(1) {
        let number = index as u64 + 1;
        let cells: Map<String, Value> = match serde_json::from_slice(line) {
            Ok(cells) => cells,
            Err(_) if index + 1 == lines.len() => break,
            Err(error) => return Err(syntax(path, number, &error)),
        };
        let (piece, rows_of_piece) = place(path, number, &cells)?;
        let row = row(path, format!("line {number}"), &cells)?;
        match pieces.iter_mut().find(|(name, ..)| *name == piece) {
            Some((_, _, rows)) => rows.push(row),
            None => pieces.push((piece, rows_of_piece, vec![row])),
        }
    }
    let whole = |(piece, number, rows): (String, usize, Vec<Row>)| {
        (rows.len() == number).then_some((piece, rows))
    };
    Ok(Some(Journaled { header, pieces: pieces.into_iter().filter_map(whole).collect() }))
}

fn header(path: &Path, line: &[u8]) -> Result<Header, TableError> {
    let header: Header = serde_json::from_slice(line).map_err(|error| {
        let message = format!(
            "{error}; allowed: a header with {} (without this file everything is measured anew)",
            "schema_version, run_key, experiment and seed"
        );
        TableError::Syntax { file: path.to_owned(), line: 1, message }
    })?;
    version_is_known(path, &header.schema_version)?;
    Ok(header)
}

/// The piece that a line belongs to, and how many rows that has.
fn place(
    path: &Path,
    number: u64,
    cells: &Map<String, Value>,
) -> Result<(String, usize), TableError> {
    let piece = cells.get("piece").and_then(Value::as_str);
    let rows = cells.get("rows_of_piece").and_then(Value::as_u64);
    let place = piece.zip(rows.and_then(|rows| usize::try_from(rows).ok()));
    place.map(|(piece, rows)| (piece.to_owned(), rows)).ok_or_else(|| {
        let message = "'piece' and 'rows_of_piece' are missing; allowed: a text, a whole number";
        TableError::Syntax { file: path.to_owned(), line: number, message: message.to_owned() }
    })
}

fn syntax(path: &Path, line: u64, error: &serde_json::Error) -> TableError {
    let message = format!("{error}; allowed: one JSON object in each line");
    TableError::Syntax { file: path.to_owned(), line, message }
}

impl Header {
    /// The header of an experiment of this program's version.
    pub fn new(run_key: RunKey, experiment: &str, seed: u64) -> Self {
        let schema_version = SCHEMA_VERSION.to_owned();
        Header { schema_version, run_key, experiment: experiment.to_owned(), seed }
    }
}

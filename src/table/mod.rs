//! THE WAIST: rows to and from CSV and JSON.
//!
//! Whatever is measured becomes rows; whatever is drawn, judged or reported starts from rows.
//! Nothing right of here can run a kernel, nothing left of here can draw.

mod cell;
mod clock;
mod columns;
mod csv;
mod file;
mod interval;
mod journal;
#[cfg(test)]
mod journal_tests;
mod json;
mod key;
mod naming;
mod rounds;
mod row;
#[cfg(test)]
mod tests;

pub use self::csv::{csv_bytes, read_csv, write_csv};
pub use cell::Cell;
pub use clock::CLOCK_COLUMNS;
pub use file::{
    can_write, make_folder, remove_file, remove_partial_files, try_folder, write_atomically,
};
pub use interval::{has_interval, interval};
pub use journal::{Header, Journal, Journaled, read_journal};
pub use json::{RunFile, SCHEMA_VERSION, read_json, write_json};
pub use key::RunKey;
pub use naming::{SETTING_COLUMNS, SUBJECT_COLUMNS};
pub use rounds::{Round, RoundsFile, read_rounds};
pub use row::{COLUMNS, REQUIRED, Row};

use std::io;
use std::path::{Path, PathBuf};

/// What can be wrong with a file of rows: where, and what is allowed.
#[derive(Debug, thiserror::Error)]
pub enum TableError {
    /// The file cannot be read or written.
    #[error("{}: {source}", file.display())]
    Io {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The file is not CSV or not JSON, or a field around the rows is missing.
    #[error("{}, line {line}: {message}", file.display())]
    Syntax {
        /// The file.
        file: PathBuf,
        /// Line, counted from 1; 0 if it is not known.
        line: u64,
        /// What the parser says.
        message: String,
    },
    /// A column of the contract is not there.
    #[error("{}: column '{column}' is missing; it must be there, its cells may be empty", file.display())]
    MissingColumn {
        /// The file.
        file: PathBuf,
        /// The column.
        column: &'static str,
    },
    /// A cell holds something else than its column allows.
    #[error("{}, {place}, column '{column}': '{text}' is not allowed; allowed: {allowed}", file.display())]
    Cell {
        /// The file.
        file: PathBuf,
        /// `line 7` of a CSV file or a journal, `row 6` of a JSON file.
        place: String,
        /// The column.
        column: String,
        /// What stands there.
        text: String,
        /// What may stand there.
        allowed: &'static str,
    },
    /// The file was written by a version whose form this one does not know.
    #[error("{}: schema_version '{found}' is not known; this program reads {allowed}", file.display())]
    Schema {
        /// The file.
        file: PathBuf,
        /// The version it names.
        found: String,
        /// The version that is read.
        allowed: &'static str,
    },
}

impl TableError {
    fn cell(file: &Path, place: String, column: &str, text: &str, allowed: &'static str) -> Self {
        let (file, column, text) = (file.to_owned(), column.to_owned(), text.to_owned());
        TableError::Cell { file, place, column, text, allowed }
    }
}

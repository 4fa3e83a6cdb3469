//! Rows to and from CSV.

use super::{COLUMNS, REQUIRED, Row, TableError, write_atomically};
use std::path::Path;

/// Writes rows with one header line. Numbers keep their full precision, missing values are empty.
pub fn write_csv(path: &Path, rows: &[Row]) -> Result<(), TableError> {
    let bytes = csv_bytes(rows).map_err(|error| syntax(path, 0, &error))?;
    write_atomically(path, &bytes)
}

/// The text of `rows.csv`.
///
/// # Errors
/// None that is known: the text is kept in memory.
pub fn csv_bytes(rows: &[Row]) -> Result<Vec<u8>, csv::Error> {
    let mut bytes = Vec::new();
    let mut writer = csv::Writer::from_writer(&mut bytes);
    writer.write_record(COLUMNS)?;
    for row in rows {
        let cells = COLUMNS.iter().map(|column| row.cell(column));
        writer
            .write_record(cells.map(|cell| cell.map_or(String::new(), |cell| cell.to_string())))?;
    }
    writer.flush()?;
    drop(writer);
    Ok(bytes)
}

/// Reads rows. Columns may stand in any order; the contract's must be there, ours may be missing,
/// unknown ones are ignored.
pub fn read_csv(path: &Path) -> Result<Vec<Row>, TableError> {
    let text =
        std::fs::read(path).map_err(|source| TableError::Io { file: path.to_owned(), source })?;
    let mut reader = csv::Reader::from_reader(text.as_slice());
    let header = reader.headers().map_err(|error| syntax(path, 1, &error))?.clone();
    for column in &COLUMNS[..REQUIRED] {
        if !header.iter().any(|name| name == *column) {
            return Err(TableError::MissingColumn { file: path.to_owned(), column });
        }
    }
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| syntax(path, 0, &error))?;
        let line = record.position().map_or(0, csv::Position::line);
        let mut row = Row::default();
        for (column, text) in header.iter().zip(&record) {
            row.set(column, text).map_err(|allowed| {
                TableError::cell(path, format!("line {line}"), column, text, allowed)
            })?;
        }
        rows.push(row);
    }
    Ok(rows)
}

fn syntax(path: &Path, line: u64, error: &csv::Error) -> TableError {
    let line = error.position().map_or(line, csv::Position::line);
    TableError::Syntax { file: path.to_owned(), line, message: error.to_string() }
}

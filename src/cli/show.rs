//! Tables on stdout: for people, as CSV, as JSON.

use std::io::Write;

use comfy_table::Table;
use comfy_table::presets::NOTHING;
use serde_json::{Map, Value};

use super::arguments::Format;
use super::failure::Failure;

/// A table: column names, and rows of values in their order.
pub struct Sheet {
    /// Column names.
    pub columns: Vec<&'static str>,
    /// One value per column; `Null` is a missing value.
    pub rows: Vec<Vec<Value>>,
}

/// Prints a sheet on stdout.
///
/// # Errors
/// When stdout cannot be written.
pub fn print(sheet: &Sheet, format: Format) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match format {
        Format::Text => writeln!(out, "{}", text(sheet))?,
        Format::Csv => csv(sheet, &mut out)?,
        Format::Json => {
            let objects: Vec<Value> = sheet.rows.iter().map(|row| object(sheet, row)).collect();
            let text = serde_json::to_string_pretty(&objects)
                .map_err(|error| Failure::Runtime(error.into()))?;
            writeln!(out, "{text}")?;
        }
    }
    Ok(())
}

fn object(sheet: &Sheet, row: &[Value]) -> Value {
    let pairs = sheet.columns.iter().zip(row);
    Value::Object(
        pairs.map(|(name, value)| ((*name).to_owned(), value.clone())).collect::<Map<_, _>>(),
    )
}

/// A sheet as CSV, in full.
///
/// # Errors
/// When `out` cannot be written.
pub fn csv(sheet: &Sheet, out: &mut impl Write) -> Result<(), Failure> {
    let mut writer = ::csv::Writer::from_writer(out);
    let failed = |error: ::csv::Error| match error.into_kind() {
        ::csv::ErrorKind::Io(error) => Failure::from(error),
        other => Failure::Runtime(anyhow::anyhow!("{other:?}")),
    };
    writer.write_record(&sheet.columns).map_err(failed)?;
    for row in &sheet.rows {
        writer.write_record(row.iter().map(cell)).map_err(failed)?;
    }
    writer.flush()?;
    Ok(())
}

/// A value in full.
fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// A value as people read it: four significant digits are more than any interval here supports.
pub fn rounded(value: &Value) -> String {
    match value.as_f64() {
        Some(0.0) => "0".to_owned(),
        Some(number) if value.is_f64() => {
            let digits = 3 - number.abs().max(1e-9).log10().floor() as i32;
            format!("{number:.*}", digits.clamp(0, 12) as usize)
        }
        _ => cell(value),
    }
}

/// A sheet as a table to read.
pub fn text(sheet: &Sheet) -> String {
    let mut table = Table::new();
    table.load_style(NOTHING);
    table.set_header(&sheet.columns);
    for row in &sheet.rows {
        table.add_row(row.iter().map(rounded));
    }
    for (index, column) in table.column_iter_mut().enumerate() {
        if sheet.rows.iter().any(|row| row.get(index).is_some_and(Value::is_number)) {
            column.set_cell_alignment(comfy_table::CellAlignment::Right);
        }
    }
    table.trim_fmt()
}

/// Lines of cells under each other, the first line a head whose cells may have several lines
/// themselves; the first column stands left, the others right.
pub fn aligned(lines: &[Vec<String>]) -> String {
    let mut table = Table::new();
    table.load_style(NOTHING);
    let mut lines = lines.iter();
    if let Some(head) = lines.next() {
        table.set_header(head);
    }
    lines.for_each(|line| {
        table.add_row(line);
    });
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(comfy_table::CellAlignment::Right);
    }
    table.trim_fmt()
}

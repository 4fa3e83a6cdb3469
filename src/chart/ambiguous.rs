//! What is said of rows that claim the same place in a figure.

use super::ChartError;
use super::figure::Figure;
use super::select::Point;
use crate::table::{COLUMNS, Cell, Row};

/// The error that names the place, and the columns in which the rows differ.
pub(super) fn ambiguous(figure: &Figure, point: &Point, one: &Row, other: &Row) -> ChartError {
    let place = [&point.panel, &point.series, &point.x].map(String::as_str);
    let place = place.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ");
    ChartError::Ambiguous { figure: figure.file.clone(), place, differing: differing(one, other) }
}

/// The columns that tell two rows apart, in words. Figures differ between any two rows; only what names
/// a row counts.
pub fn differing(one: &Row, other: &Row) -> String {
    const NAMING: [&str; 7] = ["density", "spread", "triangles", "code", "repeats", "seed", "knob"];
    let names = |column: &&&str| {
        let text = matches!(one.cell(column), Some(Cell::Text(_)))
            || matches!(other.cell(column), Some(Cell::Text(_)));
        (text && **column != "id") || NAMING.contains(*column)
    };
    let differing =
        COLUMNS.iter().filter(names).filter(|column| one.cell(column) != other.cell(column));
    let differing: Vec<_> = differing.copied().collect();
    if differing.is_empty() {
        "nothing: a row is there twice".to_owned()
    } else {
        differing.join(", ")
    }
}

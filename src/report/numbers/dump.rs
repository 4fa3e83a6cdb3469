//! A figure's numbers as CSV.

use super::{Table, standing};
use crate::chart::{ChartError, Count, Dot, Field, Figure, Numbers, Point, Published, numbers};
use crate::report::ReportError;
use crate::table::Row;

/// A figure's numbers as CSV, in the order of its rows and unrounded. Columns of `lines`, `bars` and
/// `shares`: `panel,series,x,column,value,low,high,kind`, kind being `measured`, `published` or
/// `bound`; of `counts`: `series,operation,counted,published`; of `heat`: `series,x,value,shown`; of
/// `precision`: `panel,series,precision,error,error_low,error_high,value,low,high,standing`. Only the
/// header where there is nothing to draw.
///
/// # Errors
/// As [`draw`](crate::chart::draw).
pub fn figure_csv(figure: &Figure, rows: &[Row]) -> Result<Vec<u8>, ReportError> {
    let table = match numbers(figure, rows, &Published::embedded()?) {
        Ok(numbers) => unrounded(figure, &numbers),
        Err(ChartError::Nothing(_)) => {
            Table { head: POINTS.map(str::to_owned).into(), ..Table::default() }
        }
        Err(error) => return Err(error.into()),
    };
    let mut bytes = Vec::new();
    let mut writer = csv::Writer::from_writer(&mut bytes);
    writer.write_record(&table.head)?;
    table.rows.iter().try_for_each(|row| writer.write_record(row))?;
    writer.flush().map_err(csv::Error::from)?;
    drop(writer);
    Ok(bytes)
}

const POINTS: [&str; 8] = ["panel", "series", "x", "column", "value", "low", "high", "kind"];
const COUNTS: [&str; 4] = ["series", "operation", "counted", "published"];
const FIELDS: [&str; 4] = ["series", "x", "value", "shown"];
const DOTS: [&str; 10] = [
    "panel",
    "series",
    "precision",
    "error",
    "error_low",
    "error_high",
    "value",
    "low",
    "high",
    "standing",
];

fn unrounded(figure: &Figure, numbers: &Numbers) -> Table {
    let below = figure.y_below.as_deref().unwrap_or_default();
    let bound = figure.bound.as_deref().unwrap_or_default();
    let y = figure.y.as_str();
    let (head, rows): (&[&str], _) = match numbers {
        Numbers::Points { ours, published, bounds } => {
            let parts =
                [(ours, y, "measured"), (published, y, "published"), (bounds, bound, "bound")];
            (&POINTS, raw_points(&parts))
        }
        Numbers::Shares { ours, published, ours_below, published_below } => {
            let parts = [
                (ours, y, "measured"),
                (published, y, "published"),
                (ours_below, below, "measured"),
                (published_below, below, "published"),
            ];
            (&POINTS, raw_points(&parts))
        }
        Numbers::Counts(counts) => (&COUNTS, counts.iter().map(raw_count).collect()),
        Numbers::Fields(fields) => (&FIELDS, fields.iter().map(raw_field).collect()),
        Numbers::Dots(dots) => (&DOTS, dots.iter().map(raw_dot).collect()),
    };
    Table { head: head.iter().map(|name| (*name).to_owned()).collect(), rows }
}

/// Points with their column and their kind.
fn raw_points(parts: &[(&Vec<Point>, &str, &str)]) -> Vec<Vec<String>> {
    let part = |(points, column, kind): &(&Vec<Point>, &str, &str)| {
        points.iter().map(|point| raw(point, column, kind)).collect::<Vec<_>>()
    };
    parts.iter().flat_map(part).collect()
}

fn raw(point: &Point, column: &str, kind: &str) -> Vec<String> {
    let end = |end: Option<f64>| end.map_or(String::new(), |end| end.to_string());
    let names = [&point.panel, &point.series, &point.x].map(String::clone);
    let mut row: Vec<String> = names.into();
    row.extend([column.to_owned(), point.y.to_string()]);
    row.extend([end(point.interval.map(|ends| ends.0)), end(point.interval.map(|ends| ends.1))]);
    row.push(kind.to_owned());
    row
}

pub(super) fn raw_count(count: &Count) -> Vec<String> {
    let ours = count.ours.map_or(String::new(), |ours| ours.to_string());
    let theirs = count.published.map_or(String::new(), |theirs| theirs.to_string());
    vec![count.series.clone(), count.operation.to_owned(), ours, theirs]
}

fn raw_field(field: &Field) -> Vec<String> {
    let shown = field.shown.map_or(String::new(), |shown| shown.to_string());
    vec![field.series.clone(), field.x.clone(), field.share.to_string(), shown]
}

fn raw_dot(dot: &Dot) -> Vec<String> {
    let numbers = [dot.error, dot.errors.0, dot.errors.1, dot.time, dot.times.0, dot.times.1];
    let mut row = vec![dot.panel.clone(), dot.name.clone(), dot.precision.clone()];
    row.extend(numbers.map(|number| number.to_string()));
    row.push(standing(dot).to_owned());
    row
}

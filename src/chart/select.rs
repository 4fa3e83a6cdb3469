//! From rows to the points of a figure.

use super::ChartError;
use super::ambiguous::ambiguous;
use super::figure::{Figure, Names};
pub(super) use super::normalise::{normalise_both, normalise_within_x, scale};
use super::published::{Measure, Published};
use crate::stats::median;
use crate::table::{Cell, Row, interval};
use std::collections::BTreeSet;

/// One value to draw.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point {
    /// Which small multiple; empty if there is only one.
    pub panel: String,
    /// Which line or bar.
    pub series: String,
    /// Place along the x axis, or category, as text.
    pub x: String,
    /// The value.
    pub y: f64,
    /// Its interval.
    pub interval: Option<(f64, f64)>,
}

/// Ours, the published ones, and the name of the x at which they are 1, where they are divided.
pub(super) type Values = (Vec<Point>, Vec<Point>, Option<String>);

impl Point {
    /// `x` as a number, if it is one.
    pub fn x_number(&self) -> Option<f64> {
        self.x.parse().ok().filter(|x: &f64| x.is_finite())
    }
}

/// The rows that a figure's filter lets through, and what is to be said of them.
pub(super) struct Selection<'a> {
    /// The rows.
    pub rows: Vec<&'a Row>,
}

impl<'a> Selection<'a> {
    /// The rows of a figure; it is an answer, not an error, that there are none.
    pub fn new(figure: &Figure, rows: &'a [Row]) -> Result<Self, ChartError> {
        let kept: Vec<&Row> = rows.iter().filter(|row| figure.admits(row)).collect();
        if kept.is_empty() {
            let reason = match rows.len() {
                0 => "there are no rows".to_owned(),
                count => format!("no row (of {count}) passes the figure's filter"),
            };
            return Err(ChartError::Nothing(reason));
        }
        Ok(Selection { rows: kept })
    }

    /// The points of a column. Rows without a value in it have no point.
    pub fn points(&self, figure: &Figure, column: &str) -> Result<Vec<Point>, ChartError> {
        let mut points: Vec<(Point, Vec<&Row>)> = Vec::new();
        for row in &self.rows {
            let Some(y) = row.cell(column).and_then(Cell::number) else { continue };
            let panel = figure.panels.as_deref().and_then(|panel| row.cell(panel));
            let point = Point {
                panel: panel.map_or(String::new(), |cell| cell.to_string()),
                series: joined(row, &figure.series),
                x: joined(row, &figure.x),
                y,
                interval: interval(row, column, y),
            };
            let same = |other: &&mut (Point, Vec<&Row>)| {
                (&other.0.panel, &other.0.series, &other.0.x)
                    == (&point.panel, &point.series, &point.x)
            };
            match points.iter_mut().find(same) {
                None => points.push((point, vec![row])),
                Some((_, others)) => {
                    let over = figure.over.as_deref();
                    let twin = others
                        .iter()
                        .find(|other| !over.is_some_and(|over| differ(other, row, over)));
                    if let Some(twin) = twin {
                        return Err(ambiguous(figure, &point, twin, row));
                    }
                    others.push(row);
                }
            }
        }
        if points.is_empty() {
            let reason = format!("no row (of {}) has a value of {column}", self.rows.len());
            return Err(ChartError::Nothing(reason));
        }
        let together = |(point, rows): (Point, Vec<&Row>)| put_together(point, &rows, column);
        Ok(points.into_iter().map(together).collect())
    }

    /// The points of `y` and of what stands beside it; with several, the series is the column.
    pub fn points_of_all(&self, figure: &Figure) -> Result<Vec<Point>, ChartError> {
        if figure.also.is_empty() {
            return self.points(figure, &figure.y);
        }
        let mut points = Vec::new();
        for column in std::iter::once(&figure.y).chain(&figure.also) {
            let of_column = self.points(figure, column)?.into_iter();
            points.extend(of_column.map(|point| Point { series: column.clone(), ..point }));
        }
        Ok(points)
    }

    /// The points of `y` and of what stands beside it, a panel a column; a column without values
    /// has no panel, unless none has.
    pub fn points_by_column(&self, figure: &Figure) -> Result<Vec<Point>, ChartError> {
        if figure.also.is_empty() {
            return self.points(figure, &figure.y);
        }
        let mut points = Vec::new();
        let mut nothing = Ok(Vec::new());
        for column in std::iter::once(&figure.y).chain(&figure.also) {
            match self.points(figure, column) {
                Ok(found) => points.extend(
                    found.into_iter().map(|point| Point { panel: column.clone(), ..point }),
                ),
                Err(ChartError::Nothing(reason)) => nothing = Err(ChartError::Nothing(reason)),
                Err(other) => return Err(other),
            }
        }
        if points.is_empty() { nothing } else { Ok(points) }
    }

    /// The points of the bounds that stand where a value is 0.
    pub fn bounds(&self, figure: &Figure) -> Result<Vec<Point>, ChartError> {
        match figure.bound.as_ref().map(|bound| self.points(figure, bound)) {
            None | Some(Err(ChartError::Nothing(_))) => Ok(Vec::new()),
            Some(other) => other,
        }
    }

    /// Where the figures come from: experiment, number of rows, rounds, pairs, seed.
    pub fn source(&self) -> String {
        let mut parts = vec![self.distinct("experiment", "", "experiments")];
        parts.push(format!("n = {} rows", self.rows.len()));
        parts.push(self.span("rounds", "rounds"));
        parts.push(self.span("triangles", "triangles"));
        parts.push(self.distinct("seed", "seed ", "seeds"));
        parts.retain(|part| !part.is_empty());
        parts.join(" · ")
    }

    /// How many rows have no value in a column, and their status: a wrong answer has no time.
    pub fn without(&self, column: &str) -> String {
        let missing = |row: &&&Row| row.cell(column).and_then(Cell::number).is_none();
        let rows: Vec<&&Row> = self.rows.iter().filter(missing).collect();
        let status: BTreeSet<&str> = rows.iter().map(|row| row.status.as_str()).collect();
        let status: Vec<&str> = status.into_iter().filter(|status| !status.is_empty()).collect();
        match rows.len() {
            0 => String::new(),
            count if status.is_empty() => format!("rows without a value: {count}"),
            count => format!("rows without a value: {count} ({})", status.join(", ")),
        }
    }

    fn distinct(&self, column: &str, before: &str, several: &str) -> String {
        let values: BTreeSet<String> = self.texts(column).collect();
        match values.len() {
            0 => String::new(),
            1..=3 => format!("{before}{}", values.into_iter().collect::<Vec<_>>().join(", ")),
            count => format!("{count} {several}"),
        }
    }

    fn span(&self, column: &str, unit: &str) -> String {
        let values: Vec<u64> = self.texts(column).filter_map(|text| text.parse().ok()).collect();
        match (values.iter().min(), values.iter().max()) {
            (Some(low), Some(high)) if low == high => format!("{low} {unit}"),
            (Some(low), Some(high)) => format!("{low} to {high} {unit}"),
            _ => String::new(),
        }
    }

    fn texts(&self, column: &str) -> impl Iterator<Item = String> {
        let cells = self.rows.iter().filter_map(move |row| row.cell(column));
        cells.filter(|cell| *cell != Cell::Missing).map(|cell| cell.to_string())
    }
}

/// The values of some columns as one name; empty cells leave no trace.
pub(super) fn joined(row: &Row, columns: &Names) -> String {
    let cells = columns.list().iter().filter_map(|column| row.cell(column));
    let texts = cells.map(|cell| cell.to_string()).filter(|text| !text.is_empty());
    texts.collect::<Vec<_>>().join(" · ")
}

fn differ(one: &Row, other: &Row, column: &str) -> bool {
    one.cell(column) != other.cell(column)
}

/// The point of several rows: their median, and the range from the smallest to the largest.
fn put_together(point: Point, rows: &[&Row], column: &str) -> Point {
    if rows.len() < 2 {
        return point;
    }
    let mut values: Vec<f64> =
        rows.iter().filter_map(|row| row.cell(column).and_then(Cell::number)).collect();
    values.sort_by(f64::total_cmp);
    let y = median(&values).unwrap_or(point.y);
    let interval = values.first().copied().zip(values.last().copied());
    Point { y, interval, ..point }
}

/// The published points of a figure, named as ours are and in every panel that they belong in.
pub(super) fn published(
    figure: &Figure,
    published: &Published,
    measure: Measure,
    panels: &[String],
) -> Vec<Point> {
    let Some(beside) = &figure.published else { return Vec::new() };
    let points = published.points(&beside.table, measure);
    let belongs = |panel: &&String| beside.panel.as_ref().is_none_or(|only| only == *panel);
    let in_panel = |panel: &String| {
        points
            .iter()
            .map(|point| Point {
                panel: panel.clone(),
                series: beside.names.get(&point.series).unwrap_or(&point.series).clone(),
                x: point.x.clone(),
                y: point.y,
                interval: None,
            })
            .collect::<Vec<_>>()
    };
    panels.iter().filter(belongs).flat_map(in_panel).collect()
}

/// The different values of a name, in the order in which they first appear.
pub(super) fn distinct(points: &[Point], name: impl Fn(&Point) -> &String) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for point in points {
        if !names.contains(name(point)) {
            names.push(name(point).clone());
        }
    }
    names
}

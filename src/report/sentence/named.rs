//! What points are called in a sentence.

use crate::chart::{Figure, Kind, Point};
use crate::report::sense::{Sense, sense};
use crate::report::words::{capital, with_interval};

/// Names and values of a figure's points.
pub(super) struct Named<'a> {
    pub figure: &'a Figure,
}

/// Which parts of its name tell a point from the others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Telling {
    x: bool,
    series: bool,
}

impl Telling {
    /// Of the points of a panel.
    pub fn among(points: &[&Point]) -> Self {
        let differ =
            |name: fn(&Point) -> &String| points.iter().any(|point| name(point) != name(points[0]));
        let (x, series) = (differ(|point| &point.x), differ(|point| &point.series));
        Telling { x: x || !series, series }
    }
}

impl Named<'_> {
    /// The sense of the values.
    pub fn sense(&self) -> Sense {
        let sense = sense(&self.figure.y);
        // A quotient has no unit; of shares, only what stands below them is divided.
        let divided = self.figure.normalise_to.is_some() && self.figure.kind != Kind::Shares;
        let unit = if divided { "" } else { sense.unit };
        Sense { unit, ..sense }
    }

    /// A value with its unit and its interval.
    pub fn value(&self, point: &Point) -> String {
        self.quantity(point.y, point.interval)
    }

    /// The same of a number.
    pub fn quantity(&self, value: f64, interval: Option<(f64, f64)>) -> String {
        let words = with_interval(value, interval);
        match self.sense().unit {
            "" => words,
            unit => format!("{words} {unit}"),
        }
    }

    /// A point's category and series, as far as they tell it from the others.
    pub fn name(&self, point: &Point, telling: Telling) -> String {
        let x = telling.x.then(|| self.figure.label(&point.x));
        let series = telling.series.then(|| self.figure.label(&point.series));
        let parts = x.into_iter().chain(series).filter(|part| !part.is_empty());
        let mut parts: Vec<String> = parts.collect();
        // Bars whose series is their category.
        parts.dedup();
        let name = parts.join(", ");
        if name.is_empty() { self.figure.label(&point.series) } else { name }
    }

    /// `Order fixed: `, where there are several panels.
    pub fn panel(&self, panel: &str, several: bool) -> String {
        if !several {
            return String::new();
        }
        let name = self.figure.label(panel);
        match &self.figure.panels {
            Some(column) => format!("{} {name}: ", capital(&column.replace('_', " "))),
            None => format!("{}: ", capital(&name.replace('_', " "))),
        }
    }
}

/// Whether two intervals have something in common; `None` where one has none.
pub(super) fn overlap(one: &Point, other: &Point) -> Option<bool> {
    let ((a, b), (c, d)) = (one.interval?, other.interval?);
    Some(a <= d && c <= b)
}

/// What is to be said of that.
pub(super) fn apart(one: &Point, other: &Point) -> &'static str {
    match overlap(one, other) {
        Some(true) => ", their intervals overlap",
        Some(false) | None => "",
    }
}

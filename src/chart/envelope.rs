//! What may be expected of every series of a line chart, and the crowd that stays near it.

use super::canvas::Type;
use super::figure::{Figure, Scale};
use super::frame::Frame;
use super::line_marks::{Area, Plan};
use super::palette::{FAINT, GREY};
use super::select::Point;
use crate::table::{Cell, Row};
use serde::Deserialize;
use std::collections::BTreeMap;

/// An envelope: errors that a rounding of the inputs explains.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Envelope {
    /// The column of the envelope of `y`, then of each of `also`.
    pub columns: Vec<String>,
    /// What they are multiplied by.
    pub factor: f64,
    /// Series that nowhere exceed the lower quartile of all by more than this factor are the crowd:
    /// thin grey lines, named together. (The lowest one may owe its place to the few hits that it
    /// still has.)
    pub crowd: f64,
    /// Upper end of the axis; what is higher is drawn there.
    pub limit: f64,
    /// What the envelope is called.
    pub name: String,
}

/// The envelope's points: per panel and x the largest value of its rows.
pub(super) fn points(figure: &Figure, rows: &[&Row]) -> Vec<Point> {
    let Some(envelope) = &figure.envelope else { return Vec::new() };
    let panels = std::iter::once(&figure.y).chain(&figure.also).zip(&envelope.columns);
    let mut points: Vec<Point> = Vec::new();
    for (panel, column) in panels {
        for row in rows {
            let Some(value) = row.cell(column).and_then(Cell::number) else { continue };
            let x = super::select::joined(row, &figure.x);
            let y = value * envelope.factor;
            let same = |point: &&mut Point| point.panel == *panel && point.x == x;
            match points.iter_mut().find(same) {
                Some(point) => point.y = point.y.max(y),
                None => points.push(Point {
                    panel: if figure.also.is_empty() { String::new() } else { panel.clone() },
                    series: envelope.name.clone(),
                    x,
                    y,
                    interval: None,
                }),
            }
        }
    }
    points.retain(|point| figure.scale == Scale::Linear || point.y > 0.0);
    points.sort_by(|a, b| {
        a.x_number().partial_cmp(&b.x_number()).unwrap_or(std::cmp::Ordering::Equal)
    });
    points
}

/// Per panel the series that are in the crowd; none where it would be a single one.
pub(super) fn crowds(figure: &Figure, ours: &[Point]) -> BTreeMap<String, Vec<String>> {
    let mut crowds: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let Some(settings) = &figure.envelope else { return crowds };
    for panel in super::select::distinct(ours, |point| &point.panel) {
        let of_panel: Vec<&Point> = ours.iter().filter(|point| point.panel == panel).collect();
        let floor = |x: &str| {
            let here = of_panel.iter().filter(|point| point.x == x).map(|point| point.y);
            let mut here: Vec<f64> = here.collect();
            here.sort_unstable_by(f64::total_cmp);
            here.get(here.len() / 4).copied().unwrap_or(f64::INFINITY)
        };
        let within = |name: &String| {
            let mine = of_panel.iter().filter(|point| point.series == *name);
            mine.clone().count() > 0
                && mine.clone().all(|point| point.y <= settings.crowd * floor(&point.x))
        };
        let mut names = super::select::distinct(ours, |point| &point.series);
        names.retain(within);
        if names.len() > 1 {
            crowds.insert(panel, names);
        }
    }
    crowds
}

/// The series, those first that stand out in some panel: they have the first colours.
pub(super) fn by_standing_out(
    mut series: Vec<String>,
    crowds: &BTreeMap<String, Vec<String>>,
) -> Vec<String> {
    let is_crowd = |name: &String| crowds.values().all(|crowd| crowd.contains(name));
    series.sort_by_key(|name| !crowds.is_empty() && is_crowd(name));
    series
}

/// Draws the envelope of a panel: everything below it is shaded.
pub(super) fn drawn(frame: &mut Frame, plan: &Plan, panel: &str, area: &Area) {
    let mine = plan.envelope.iter().filter(|point| point.panel == panel);
    let line: Vec<_> =
        mine.filter_map(|point| Some(area.at(plan, point.x_number()?, point.y))).collect();
    let (Some(first), Some(last)) = (line.first(), line.last()) else { return };
    let mut outline = line.clone();
    outline.extend([(last.0, area.bottom), (first.0, area.bottom)]);
    frame.canvas.area(&outline, FAINT, 0.55);
    frame.canvas.dashed(&line, GREY, 1.4);
}

/// Names the crowd below a panel; returns where that ends.
pub(super) fn crowd_named(
    frame: &mut Frame,
    figure: &Figure,
    plan: &Plan,
    panel: &str,
    (left, top, width): (f64, f64, f64),
) -> f64 {
    const SIZE: f64 = 11.0;
    let Some(names) = plan.crowds.get(panel) else { return top };
    let names: Vec<String> = names.iter().map(|name| figure.label(name)).collect();
    let words = format!("grey lines: {}", names.join(", "));
    let mut under = top;
    for line in super::text::wrap(&words, SIZE, false, width) {
        frame.canvas.text((left, under), &line, Type::new(SIZE, GREY));
        under += SIZE * 1.35;
    }
    under
}

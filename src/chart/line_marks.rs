//! What stands in a panel of a line chart: bands, lines, markers, and labels at the lines' ends.

use super::axis::Axis;
use super::canvas::Type;
use super::figure::Figure;
use super::frame::{Frame, SMALL};
use super::labels;
use super::palette::{GREY, INK, LEADER, style};
use super::select::Point;
use super::upright::Upright;
use std::collections::BTreeMap;

/// Distance of two labels.
pub(super) const LABEL_GAP: f64 = 16.0;
/// From a line's end to the marker of its label, and from there to its words.
const LEADER_LENGTH: f64 = 18.0;
pub(super) const LABEL_INDENT: f64 = LEADER_LENGTH + 10.0;

/// Everything that is the same in all panels.
pub(super) struct Plan {
    pub ours: Vec<Point>,
    pub published: Vec<Point>,
    /// What may be expected of every series, see [`super::envelope`].
    pub envelope: Vec<Point>,
    /// Marks on the x axis.
    pub marks: Vec<Upright>,
    /// Per panel the series that are drawn together.
    pub crowds: BTreeMap<String, Vec<String>>,
    pub panels: Vec<String>,
    pub series: Vec<String>,
    pub x: Axis,
    pub y: Axis,
}

/// Where the drawing of one panel is.
pub(super) struct Area {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Area {
    pub fn at(&self, plan: &Plan, x: f64, y: f64) -> (f64, f64) {
        let across = self.left + plan.x.place(x) * (self.right - self.left);
        (across, self.bottom - plan.y.place(y) * (self.bottom - self.top))
    }
}

/// Draws every series of a panel.
pub(super) fn series_drawn(
    frame: &mut Frame,
    figure: &Figure,
    plan: &Plan,
    panel: &str,
    area: &Area,
) {
    let of = |points: &[Point], name: &String| in_order(points, panel, name);
    let places = |points: &[Point]| -> Vec<(f64, f64)> {
        points.iter().filter_map(|point| Some(area.at(plan, point.x_number()?, point.y))).collect()
    };
    let crowd = plan.crowds.get(panel).map_or(&[][..], Vec::as_slice);
    for name in crowd {
        frame.canvas.line(&places(&of(&plan.ours, name)), LEADER, 1.2);
    }
    let each = || plan.series.iter().enumerate().filter(|(_, name)| !crowd.contains(name));
    for (index, name) in each() {
        band(frame, plan, area, &of(&plan.ours, name), index);
    }
    for (index, name) in each() {
        published_line(frame, &places(&of(&plan.published, name)), index);
    }
    each().for_each(|(index, name)| {
        frame.canvas.line(&places(&of(&plan.ours, name)), style(index).0, 1.7);
    });
    // Markers of all series over the lines of all series.
    let mut ends = Vec::new();
    for (index, name) in each() {
        let (colour, shape) = style(index);
        let ours = places(&of(&plan.ours, name));
        ours.iter().for_each(|at| frame.canvas.marker(shape, *at, 3.0, colour));
        let theirs = places(&of(&plan.published, name));
        if let Some(end) = ours.last().or(theirs.last()) {
            ends.push((index, *end, ours.is_empty()));
        }
    }
    // The crowd has one label, where its last line ends; its number is beyond every series'.
    if let Some(end) = crowd.last().and_then(|name| places(&of(&plan.ours, name)).last().copied()) {
        ends.push((plan.series.len(), end, false));
    }
    end_labels(frame, figure, plan, panel, area, &ends);
}

fn published_line(frame: &mut Frame, places: &[(f64, f64)], series: usize) {
    let (colour, shape) = style(series);
    frame.canvas.dashed(places, colour, 1.0);
    places.iter().for_each(|at| frame.canvas.hollow(shape, *at, 3.8, colour));
}

/// The points of a series in a panel, from left to right.
fn in_order(points: &[Point], panel: &str, series: &str) -> Vec<Point> {
    let mine = points.iter().filter(|point| point.panel == panel && point.series == series);
    let mut mine: Vec<Point> = mine.cloned().collect();
    // A point without a place sorts last; it is not drawn.
    let place = |point: &Point| point.x_number().unwrap_or(f64::INFINITY);
    mine.sort_by(|a, b| place(a).total_cmp(&place(b)));
    mine
}

fn band(frame: &mut Frame, plan: &Plan, area: &Area, points: &[Point], series: usize) {
    let ends: Vec<_> = points
        .iter()
        .filter_map(|point| Some((point.x_number()?, point.interval?)))
        .map(|(x, (low, high))| (area.at(plan, x, low), area.at(plan, x, high)))
        .collect();
    let colour = style(series).0;
    match ends.as_slice() {
        [] => {}
        [(low, high)] => frame.canvas.whisker(*low, *high, 4.0, colour),
        _ => {
            let mut outline: Vec<_> = ends.iter().map(|(_, high)| *high).collect();
            outline.extend(ends.iter().rev().map(|(low, _)| *low));
            frame.canvas.area(&outline, colour, 0.15);
        }
    }
}

fn end_labels(
    frame: &mut Frame,
    figure: &Figure,
    plan: &Plan,
    panel: &str,
    area: &Area,
    ends: &[(usize, (f64, f64), bool)],
) {
    let wanted: Vec<f64> = ends.iter().map(|(_, end, _)| end.1).collect();
    let heights = labels::pushed_apart(&wanted, LABEL_GAP, area.top, area.bottom);
    for ((index, end, hollow), height) in ends.iter().zip(heights) {
        let (colour, shape) = style(*index);
        let at = (area.right + LEADER_LENGTH, height);
        frame.canvas.line(&[(end.0 + 6.0, end.1), (at.0 - 6.0, height)], LEADER, 0.8);
        let Some(name) = plan.series.get(*index) else {
            let crowd = plan.crowds.get(panel).map_or(0, Vec::len);
            let words = if ends.len() == 1 { "all" } else { "the others" };
            let words = format!("{words} ({crowd}), grey");
            frame.canvas.text((area.right + LABEL_INDENT, height), &words, Type::new(SMALL, GREY));
            continue;
        };
        if *hollow {
            frame.canvas.hollow(shape, at, 3.4, colour);
        } else {
            frame.canvas.marker(shape, at, 3.4, colour);
        }
        let words = label(figure, plan, panel, name);
        frame.canvas.text((area.right + LABEL_INDENT, height), &words, Type::new(SMALL, INK));
    }
}

/// A series' name; one that this panel (or, for an empty name, some panel) lacks is a published one.
pub(super) fn label(figure: &Figure, plan: &Plan, panel: &str, name: &str) -> String {
    let in_panel =
        |wanted: &str| plan.ours.iter().any(|point| point.series == name && point.panel == wanted);
    let measured = if panel.is_empty() {
        plan.panels.iter().all(|panel| in_panel(panel))
    } else {
        in_panel(panel)
    };
    let name = figure.label(name);
    if measured { name } else { format!("{name} (published)") }
}

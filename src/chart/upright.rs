//! Values of x that are marked by an upright line, named at its upper end: sizes of caches.

use super::canvas::{Anchor, Type};
use super::figure::Figure;
use super::frame::{Frame, SMALL, title};
use super::line_marks::{Area, Plan};
use super::palette::{GREY, LEADER};
use crate::table::{Cell, Row};

/// A mark.
pub(super) struct Upright {
    /// Where on the axis.
    pub x: f64,
    /// Its name.
    pub name: String,
}

/// Beyond this share of the axis a name stands on the left of its line.
const TURNS_AT: f64 = 0.8;

/// The different values of the columns of [`Figure::x_marks`]; a column without one has no mark.
pub(super) fn of(figure: &Figure, rows: &[&Row]) -> Vec<Upright> {
    let mut marks: Vec<Upright> = Vec::new();
    for column in figure.x_marks.list() {
        let name = figure.labels.get(column).cloned().unwrap_or_else(|| title(column));
        for x in rows.iter().filter_map(|row| row.cell(column).and_then(Cell::number)) {
            if !marks.iter().any(|mark| mark.x == x && mark.name == name) {
                marks.push(Upright { x, name: name.clone() });
            }
        }
    }
    marks
}

/// Draws the marks that lie on the axis.
pub(super) fn drawn(frame: &mut Frame, plan: &Plan, area: &Area) {
    for mark in plan.marks.iter().filter(|mark| plan.x.reaches(mark.x)) {
        let share = plan.x.place(mark.x);
        let x = area.left + share * (area.right - area.left);
        frame.canvas.dashed(&[(x, area.top), (x, area.bottom)], LEADER, 1.2);
        let (x, anchor) =
            if share > TURNS_AT { (x - 4.0, Anchor::End) } else { (x + 4.0, Anchor::Start) };
        frame.canvas.value((x, area.top + 8.0), &mark.name, Type::new(SMALL, GREY).at(anchor));
    }
}

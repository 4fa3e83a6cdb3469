//! Time over error, both logarithmic (a work-precision diagram): which form to take if one can
//! afford this error, or this time.
//!
//! ```text
//! rows -> dot (points, front, what is set apart) -> scale (axis) -> placing (labels) -> panel
//! ```
//!
//! The figure's keys: `x` one column of errors, `x_low` and `x_high` two more of its quantiles for
//! whiskers, `y` the time, `series` what a point is called. Points of a series in several values of
//! the column `precision` have one marker each and are joined. With `errors_from`, the errors are
//! those of other rows with the same id: a chart of times on random data over errors on a stiff
//! family is drawn from the rows of both experiments in one list, `filter` choosing the times and
//! `errors_from` the family and one value of its knob, so that each id has one row of errors.
//!
//! The front of a precision are the points that no other of it is surely better than
//! (`Dot::dominates`); the steps go through those of them that are the best of their time. Each
//! panel has an axis of times of its own, all share that of the errors.

mod dot;
mod panel;
mod placing;
mod scale;

pub use self::dot::{Dot, Standing, on_steps};

use self::dot::{Without, dots};
use self::panel::Area;
use self::scale::Errors;
use super::axis::Axis;
use super::canvas::{Anchor, Type};
use super::figure::Figure;
use super::frame::{Frame, MARGIN, SMALL, heading, title};
use super::palette::{GREY, INK, Shape};
use super::select::Selection;
use super::{ChartError, text};
use crate::table::Row;

const PLOT: f64 = 860.0;
const HEIGHT: f64 = 500.0;
const TICKS: usize = 6;

/// Everything that is drawn.
struct Plan {
    dots: Vec<Dot>,
    panels: Vec<String>,
    precisions: Vec<String>,
    x: Errors,
}

/// Draws the figure.
pub(super) fn draw(figure: &Figure, rows: &[Row]) -> Result<String, ChartError> {
    let selection = Selection::new(figure, rows)?;
    let (dots, without) = dots(figure, &selection, rows)?;
    let plan = plan(dots)?;
    let y_title = figure.y_title.clone().unwrap_or_else(|| title(&figure.y));
    let axes: Vec<Times> =
        plan.panels.iter().map(|panel| Times::of(&plan, panel)).collect::<Result<_, _>>()?;
    let width_of = |(_, words): &(f64, String)| text::width(words, SMALL, false);
    let ticks = axes.iter().flat_map(|axis| &axis.ticks);
    let left = ticks.map(width_of).fold(0.0, f64::max) + 10.0;
    let mut frame = Frame::new(figure, 2.0 * MARGIN + left + PLOT);
    legend(&mut frame, figure, &plan);
    frame.paragraph(&format!("{y_title} (log scale)"), Type::new(SMALL, GREY));
    for (panel, times) in plan.panels.iter().zip(axes) {
        for words in heading(figure, panel, PLOT) {
            frame.paragraph(&words, Type::new(13.0, INK).bold());
        }
        let top = frame.top + 6.0;
        let (left, bottom) = (MARGIN + left, top + HEIGHT);
        let area = Area { left, right: left + PLOT, top, bottom, times };
        let unnamed = panel::drawn(&mut frame, figure, &plan, panel, &area);
        frame.top = area.bottom + 26.0;
        let x_title = figure.x_title.clone().unwrap_or_else(|| title(&figure.x.list().join(" ")));
        frame.paragraph(&format!("{x_title} (log scale)"), Type::new(SMALL, GREY));
        below(&mut frame, figure, &plan, panel, &unnamed);
        frame.top += 12.0;
    }
    let notes = notes(figure, &selection, &plan, &without);
    let (bottom, description) = (frame.top - 12.0, described(figure, &plan, &y_title));
    frame.close(figure, bottom, &notes, &description)
}

/// The points, those far behind the others included.
pub(super) fn values(figure: &Figure, rows: &[Row]) -> Result<Vec<Dot>, ChartError> {
    let selection = Selection::new(figure, rows)?;
    Ok(dots(figure, &selection, rows)?.0)
}

fn plan(dots: Vec<Dot>) -> Result<Plan, ChartError> {
    let distinct = |of: fn(&Dot) -> &String| {
        let mut values: Vec<String> = Vec::new();
        for dot in &dots {
            if !values.contains(of(dot)) {
                values.push(of(dot).clone());
            }
        }
        values
    };
    let drawn = || dots.iter().filter(|dot| !matches!(dot.standing, Standing::Apart(_)));
    // Whiskers are drawn of the front alone; the others must not stretch the axis by theirs.
    let errors = |dot: &Dot| match dot.standing {
        Standing::Front => dot.errors,
        _ => (dot.error, dot.error),
    };
    let errors: Vec<(f64, f64)> = drawn().map(errors).collect();
    let x = Errors::of(&errors).ok_or_else(nothing)?;
    let (panels, precisions) = (distinct(|dot| &dot.panel), distinct(|dot| &dot.precision));
    Ok(Plan { panels, precisions, x, dots })
}

fn nothing() -> ChartError {
    ChartError::Nothing("no value is above zero".to_owned())
}

/// The axis of times of a panel.
struct Times {
    axis: Axis,
    ticks: Vec<(f64, String)>,
}

impl Times {
    fn of(plan: &Plan, panel: &str) -> Result<Self, ChartError> {
        let is_drawn =
            |dot: &&Dot| dot.panel == panel && !matches!(dot.standing, Standing::Apart(_));
        let dots = plan.dots.iter().filter(is_drawn);
        let times: Vec<f64> = dots.flat_map(|dot| [dot.times.0, dot.time, dot.times.1]).collect();
        let axis = Axis::log(&times).ok_or_else(nothing)?;
        let range = times.iter().fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), time| {
            (low.min(*time), high.max(*time))
        });
        // Within a decade 1, 2 and 5 are too few.
        let ticks = if range.1 < 8.0 * range.0 {
            Axis::exact(&[range.0 / 1.1, range.1 * 1.1]).ticks(TICKS)
        } else {
            axis.ticks(TICKS)
        };
        Ok(Times { axis, ticks })
    }
}

/// Marker of a precision.
fn shape(plan: &Plan, precision: &str) -> Shape {
    const SHAPES: [Shape; 4] = [Shape::Circle, Shape::Square, Shape::Up, Shape::Diamond];
    let index = plan.precisions.iter().position(|other| other == precision).unwrap_or(0);
    SHAPES[index % SHAPES.len()]
}

/// What the markers mean.
fn legend(frame: &mut Frame, figure: &Figure, plan: &Plan) {
    let (mut x, y) = (MARGIN + 5.0, frame.top + 6.0);
    let style = Type::new(SMALL, INK);
    for precision in &plan.precisions {
        let words = figure.label(precision);
        frame.canvas.marker(shape(plan, precision), (x, y), 4.5, panel::FRONT);
        frame.canvas.text((x + 10.0, y), &words, style);
        x += 10.0 + text::width(&words, SMALL, false) + 18.0;
    }
    frame.canvas.marker(Shape::Circle, (x, y), 3.6, panel::BEHIND);
    let words = "another of the same precision is faster beyond doubt and errs no more";
    frame.canvas.text((x + 10.0, y), words, Type::new(SMALL, GREY).at(Anchor::Start));
    frame.top += 24.0;
}

/// What is said under a panel: points that are not in it, and labels that found no room.
fn below(frame: &mut Frame, figure: &Figure, plan: &Plan, panel: &str, unnamed: &[&Dot]) {
    let style = Type::new(11.0, GREY);
    let name = |dot: &Dot| format!("{} {}", figure.label(&dot.name), figure.label(&dot.precision));
    let apart = plan.dots.iter().filter(|dot| dot.panel == panel);
    let apart = apart.filter_map(|dot| match &dot.standing {
        Standing::Apart(why) => Some(format!(
            "{} ({}; error {}, {why})",
            name(dot),
            text::figure(dot.time),
            text::figure(dot.error)
        )),
        _ => None,
    });
    let apart: Vec<String> = apart.collect();
    if !apart.is_empty() {
        frame.paragraph(&format!("Set apart, not drawn: {}.", apart.join(", ")), style);
    }
    if !unnamed.is_empty() {
        let names: Vec<String> = unnamed.iter().map(|dot| name(dot)).collect();
        frame.paragraph(&format!("Without a label: {}.", names.join(", ")), style);
    }
}

fn notes(
    figure: &Figure,
    selection: &Selection<'_>,
    plan: &Plan,
    without: &Without,
) -> Vec<String> {
    let mut notes = vec![selection.source(), selection.without(&figure.y)];
    let whiskers = [&figure.x_low, &figure.x_high].map(Option::is_some);
    notes.push(match whiskers {
        [false, false] => "upright whiskers: interval of the time".to_owned(),
        _ => "whiskers of the front: interval of the time, and quantiles of the error".to_owned(),
    });
    if !without.error.is_empty() {
        notes.push(format!("without this error: {}", without.error.join(", ")));
    }
    if plan.x.has_zero {
        notes.push("errors of 0 stand at the left edge".to_owned());
    }
    if !plan.x.cuts().is_empty() {
        notes.push("// the error axis leaves out decades in which there is nothing".to_owned());
    }
    notes
}

fn described(figure: &Figure, plan: &Plan, y_title: &str) -> String {
    let of_panel = |panel: &String| {
        let dots = plan.dots.iter().filter(|dot| dot.panel == *panel);
        let mut front: Vec<&Dot> = dots.filter(|dot| dot.standing == Standing::Front).collect();
        front.sort_by(|a, b| a.time.total_cmp(&b.time));
        let names = front.iter().map(|dot| {
            let (name, precision) = (figure.label(&dot.name), figure.label(&dot.precision));
            format!("{name} {precision} ({}, {})", text::figure(dot.time), text::figure(dot.error))
        });
        format!("{} {}", figure.label(panel), names.collect::<Vec<_>>().join(", "))
    };
    let panels: Vec<String> = plan.panels.iter().map(of_panel).collect();
    format!("Chart of {y_title} over error. Front: {}.", panels.join("; "))
}

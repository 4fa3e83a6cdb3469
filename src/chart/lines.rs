//! Lines over a numeric x, one small multiple per panel: thesis B's time over density.

use super::axis::Axis;
use super::canvas::{Anchor, Type};
use super::figure::{Figure, Scale};
use super::frame::{Frame, MARGIN, SMALL, published_note, title};
use super::palette::{FAINT, GREY, INK, LEADER, style};
use super::published::{Measure, Published};
use super::select::{self, Point, Selection};
use super::{ChartError, labels, text};
use crate::table::Row;

const COLUMNS: usize = 3;
const TICKS: usize = 6;
const LABEL_GAP: f64 = 16.0;
/// From a line's end to the marker of its label, and from there to its words.
const LEADER_LENGTH: f64 = 18.0;
const LABEL_INDENT: f64 = LEADER_LENGTH + 10.0;

/// Everything that is the same in all panels.
struct Plan {
    ours: Vec<Point>,
    published: Vec<Point>,
    panels: Vec<String>,
    series: Vec<String>,
    x: Axis,
    y: Axis,
}

/// Where the drawing of one panel is.
struct Area {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl Area {
    fn at(&self, plan: &Plan, x: f64, y: f64) -> (f64, f64) {
        let across = self.left + plan.x.place(x) * (self.right - self.left);
        (across, self.bottom - plan.y.place(y) * (self.bottom - self.top))
    }
}

/// Draws the figure.
pub(super) fn draw(figure: &Figure, rows: &[Row], published: &Published) -> Result<String, ChartError> {
    let selection = Selection::new(figure, rows)?;
    let mut ours = selection.points(figure, &figure.y)?;
    let panels = select::distinct(&ours, |point| &point.panel);
    let mut theirs = select::published(figure, published, Measure::Seconds, &panels);
    let mut y_title = figure.y_title.clone().unwrap_or_else(|| title(&figure.y));
    if let Some(base) = &figure.normalise_to {
        let first = select::normalise(&mut ours, base)?;
        if !theirs.is_empty() {
            select::normalise(&mut theirs, base)?;
        }
        let x = figure.x.list().join(" ").replace('_', " ");
        y_title = format!("{y_title}, relative to {} at {x} {first}", figure.label(base));
    }
    let (plan, hidden) = plan(figure, panels, ours, theirs)?;
    y_title.push_str(match figure.scale {
        Scale::Log => " (log scale)",
        Scale::Linear if !plan.y.has_zero() => " (the axis does not start at 0)",
        Scale::Linear => "",
    });
    let mut notes = vec![selection.source(), published_note(figure)];
    if plan.ours.iter().any(|point| point.interval.is_some()) {
        notes.push("bands: intervals".to_owned());
    }
    if hidden > 0 {
        notes.push(format!("{hidden} values have no place on the axes and are not drawn"));
    }
    panels_drawn(figure, &plan, &y_title, &notes)
}

fn plan(
    figure: &Figure,
    panels: Vec<String>,
    mut ours: Vec<Point>,
    mut published: Vec<Point>,
) -> Result<(Plan, usize), ChartError> {
    let before = ours.len() + published.len();
    let placed = |point: &Point| {
        let x = point.x_number().is_some_and(|x| figure.x_scale == Scale::Linear || x > 0.0);
        x && point.y.is_finite() && (figure.scale == Scale::Linear || point.y > 0.0)
    };
    ours.retain(placed);
    published.retain(placed);
    let hidden = before - ours.len() - published.len();
    if ours.is_empty() {
        return Err(ChartError::Nothing("no value has a place on the axes".to_owned()));
    }
    let all = || ours.iter().chain(&published);
    let xs: Vec<f64> = all().filter_map(Point::x_number).collect();
    let mut ys: Vec<f64> = all().map(|point| point.y).chain(figure.reference).collect();
    ys.extend(all().filter_map(|point| point.interval).flat_map(|(low, high)| [low, high]));
    let none = || ChartError::Nothing("no value is above zero".to_owned());
    let x = if figure.x_scale == Scale::Log { Axis::log(&xs).ok_or_else(none)? } else { Axis::exact(&xs) };
    let y = if figure.scale == Scale::Log { Axis::log(&ys).ok_or_else(none)? } else { Axis::fitted(&ys, TICKS) };
    let named: Vec<Point> = all().cloned().collect();
    let series = select::distinct(&named, |point| &point.series);
    Ok((Plan { ours, published, panels, series, x, y }, hidden))
}

fn panels_drawn(figure: &Figure, plan: &Plan, y_title: &str, notes: &[String]) -> Result<String, ChartError> {
    let columns = plan.panels.len().clamp(1, COLUMNS);
    let plot = [640.0, 400.0, 300.0][columns - 1];
    let width_of = |words: &String| text::width(words, SMALL, false);
    let ticks = plan.y.ticks(TICKS);
    let left = ticks.iter().map(|(_, label)| width_of(label)).fold(0.0, f64::max) + 10.0;
    let names = plan.series.iter().map(|name| width_of(&label(figure, plan, "", name)));
    let right = LABEL_INDENT + names.fold(0.0, f64::max) + 14.0;
    let height = (plan.series.len() as f64 * LABEL_GAP + 20.0).max(300.0);
    let width = 2.0 * MARGIN + left + columns as f64 * (plot + right);

    let mut frame = Frame::new(figure, width);
    frame.paragraph(y_title, Type::new(SMALL, GREY));
    let mut top = frame.top + 6.0;
    let mut bottom = top;
    for (index, panel) in plan.panels.iter().enumerate() {
        let column = index % columns;
        if column == 0 {
            top = if index == 0 { top } else { bottom + 22.0 };
            bottom = top;
        }
        let start = MARGIN + left + column as f64 * (plot + right);
        let heading = heading(figure, panel, plot + right - 10.0);
        for (line, words) in heading.iter().enumerate() {
            frame.canvas.text((start, top + 10.0 + 17.0 * line as f64), words, Type::new(13.0, INK).bold());
        }
        let upper = top + 17.0 * heading.len() as f64 + 12.0;
        let area = Area { left: start, right: start + plot, top: upper, bottom: upper + height };
        axes(&mut frame, figure, plan, &area, column == 0);
        series_drawn(&mut frame, figure, plan, panel, &area);
        let x_title = figure.x_title.clone().unwrap_or_else(|| title(&figure.x.list().join(" ")));
        let mut under = area.bottom + 36.0;
        for words in text::wrap(&x_title, SMALL, false, plot + right - 10.0) {
            frame.canvas.text((area.left, under), &words, Type::new(SMALL, GREY));
            under += 16.0;
        }
        bottom = bottom.max(under);
    }
    let description = described(figure, plan, y_title);
    frame.close(figure, bottom, notes, &description)
}

fn heading(figure: &Figure, panel: &str, width: f64) -> Vec<String> {
    let Some(column) = &figure.panels else { return Vec::new() };
    let words = format!("{}: {}", column.replace('_', " "), figure.label(panel));
    text::wrap(&words, 13.0, true, width)
}

fn axes(frame: &mut Frame, figure: &Figure, plan: &Plan, area: &Area, labelled: bool) {
    let style = Type::new(SMALL, GREY);
    for (value, words) in plan.y.ticks(TICKS) {
        let y = area.bottom - plan.y.place(value) * (area.bottom - area.top);
        frame.canvas.line(&[(area.left, y), (area.right, y)], FAINT, 1.0);
        if labelled {
            frame.canvas.text((area.left - 8.0, y), &words, style.at(Anchor::End));
        }
    }
    if let Some(reference) = figure.reference.filter(|value| plan.y.shows(*value)) {
        let y = area.bottom - plan.y.place(reference) * (area.bottom - area.top);
        frame.canvas.line(&[(area.left, y), (area.right, y)], GREY, 1.2);
    }
    for (value, words) in x_ticks(plan, area.right - area.left) {
        let x = area.left + plan.x.place(value) * (area.right - area.left);
        frame.canvas.line(&[(x, area.bottom + 2.0), (x, area.bottom + 6.0)], LEADER, 1.0);
        frame.canvas.text((x, area.bottom + 17.0), &words, style.at(Anchor::Middle));
    }
}

/// The values of x themselves where their labels fit side by side, else round ones.
fn x_ticks(plan: &Plan, width: f64) -> Vec<(f64, String)> {
    let mut own: Vec<(f64, String)> =
        plan.ours.iter().filter_map(|point| Some((point.x_number()?, point.x.clone()))).collect();
    own.sort_by(|a, b| a.0.total_cmp(&b.0));
    own.dedup_by(|a, b| a.0 == b.0);
    let fits = |ticks: &[(f64, String)]| {
        ticks.windows(2).all(|pair| {
            let distance = (plan.x.place(pair[1].0) - plan.x.place(pair[0].0)) * width;
            let words = text::width(&pair[0].1, SMALL, false) + text::width(&pair[1].1, SMALL, false);
            distance >= words / 2.0 + 4.0
        })
    };
    if own.len() <= 11 && fits(&own) {
        return own;
    }
    let candidates = [8, 6, 5, 4, 3, 2, 1].map(|about| plan.x.ticks(about));
    candidates.into_iter().find(|ticks| fits(ticks)).unwrap_or_default()
}

fn series_drawn(frame: &mut Frame, figure: &Figure, plan: &Plan, panel: &str, area: &Area) {
    let of = |points: &[Point], name: &String| -> Vec<Point> {
        let mine = points.iter().filter(|point| point.panel == panel && point.series == *name);
        let mut mine: Vec<Point> = mine.cloned().collect();
        mine.sort_by(|a, b| a.x_number().partial_cmp(&b.x_number()).unwrap_or(std::cmp::Ordering::Equal));
        mine
    };
    let places = |points: &[Point]| -> Vec<(f64, f64)> {
        points.iter().filter_map(|point| Some(area.at(plan, point.x_number()?, point.y))).collect()
    };
    let each = || plan.series.iter().enumerate();
    for (index, name) in each() {
        band(frame, plan, area, &of(&plan.ours, name), index);
    }
    for (index, name) in each() {
        let (colour, shape) = style(index);
        let theirs = places(&of(&plan.published, name));
        frame.canvas.dashed(&theirs, colour, 1.0);
        theirs.iter().for_each(|at| frame.canvas.hollow(shape, *at, 3.8, colour));
    }
    for (index, name) in each() {
        frame.canvas.line(&places(&of(&plan.ours, name)), style(index).0, 1.8);
    }
    let mut ends = Vec::new();
    for (index, name) in each() {
        let (colour, shape) = style(index);
        let ours = places(&of(&plan.ours, name));
        ours.iter().for_each(|at| frame.canvas.marker(shape, *at, 3.4, colour));
        let theirs = places(&of(&plan.published, name));
        if let Some(end) = ours.last().or(theirs.last()) {
            ends.push((index, *end, ours.is_empty()));
        }
    }
    end_labels(frame, figure, plan, panel, area, &ends);
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
            frame.canvas.area(&outline, colour, 0.18);
        }
    }
}

fn end_labels(frame: &mut Frame, figure: &Figure, plan: &Plan, panel: &str, area: &Area, ends: &[(usize, (f64, f64), bool)]) {
    let wanted: Vec<f64> = ends.iter().map(|(_, end, _)| end.1).collect();
    let heights = labels::pushed_apart(&wanted, LABEL_GAP, area.top, area.bottom);
    for ((index, end, hollow), height) in ends.iter().zip(heights) {
        let (colour, shape) = style(*index);
        let at = (area.right + LEADER_LENGTH, height);
        frame.canvas.line(&[(end.0 + 6.0, end.1), (at.0 - 6.0, height)], LEADER, 0.8);
        if *hollow {
            frame.canvas.hollow(shape, at, 3.4, colour);
        } else {
            frame.canvas.marker(shape, at, 3.4, colour);
        }
        let words = label(figure, plan, panel, &plan.series[*index]);
        frame.canvas.text((area.right + LABEL_INDENT, height), &words, Type::new(SMALL, INK));
    }
}

/// A series' name; one that this panel (or, for an empty name, some panel) lacks is a published one.
fn label(figure: &Figure, plan: &Plan, panel: &str, name: &str) -> String {
    let in_panel = |wanted: &str| plan.ours.iter().any(|point| point.series == name && point.panel == wanted);
    let measured = if panel.is_empty() { plan.panels.iter().all(|panel| in_panel(panel)) } else { in_panel(panel) };
    let name = figure.label(name);
    if measured { name } else { format!("{name} (published)") }
}

fn described(figure: &Figure, plan: &Plan, y_title: &str) -> String {
    let ranges = plan.series.iter().map(|name| {
        let mine = plan.ours.iter().filter(|point| point.series == *name).map(|point| point.y);
        let (low, high) = mine.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
        let name = figure.label(name);
        if low > high { format!("{name} published only") } else { format!("{name} {} to {}", text::figure(low), text::figure(high)) }
    });
    format!("Line chart of {y_title}: {}.", ranges.collect::<Vec<_>>().join("; "))
}

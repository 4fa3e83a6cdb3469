//! Lines over a numeric x, one small multiple per panel: thesis B's time over density.

use super::axis::Axis;
use super::canvas::{Anchor, Type};
use super::envelope;
use super::figure::{Figure, Scale};
use super::frame::{Frame, MARGIN, SMALL, heading, published_note, title};
use super::line_marks::{Area, LABEL_GAP, LABEL_INDENT, Plan, label, series_drawn};
use super::palette::{FAINT, GREY, INK, LEADER};
use super::published::{Measure, Published};
use super::select::{self, Point, Selection, Values};
use super::upright;
use super::{ChartError, text};
use crate::table::Row;

const COLUMNS: usize = 3;
const TICKS: usize = 6;

/// Draws the figure.
pub(super) fn draw(
    figure: &Figure,
    rows: &[Row],
    published: &Published,
) -> Result<String, ChartError> {
    let selection = Selection::new(figure, rows)?;
    let (ours, theirs, first) = values(figure, &selection, published)?;
    let panels = select::distinct(&ours, |point| &point.panel);
    let mut y_title = figure.y_title.clone().unwrap_or_else(|| title(&figure.y));
    if let (Some(base), Some(first)) = (&figure.normalise_to, first) {
        let x = figure.x.list().join(" ").replace('_', " ");
        y_title = format!("{y_title}, relative to {} at {x} {first}", figure.label(base));
    }
    let envelope = envelope::points(figure, &selection.rows);
    let (mut plan, hidden) = plan(figure, panels, (ours, theirs, envelope))?;
    plan.marks = upright::of(figure, &selection.rows);
    y_title.push_str(match figure.scale {
        Scale::Log => " (log scale)",
        Scale::Linear if !plan.y.has_zero() => " (the axis does not start at 0)",
        Scale::Linear => "",
    });
    let mut notes = vec![selection.source(), published_note(figure), selection.without(&figure.y)];
    if plan.ours.iter().any(|point| point.interval.is_some()) {
        notes.push(figure.intervals("bands"));
    }
    if let Some(envelope) = &figure.envelope {
        notes.push(format!("dashed, shaded below: {}", envelope.name));
        if plan.ours.iter().any(|point| point.y > envelope.limit) {
            notes.push(format!("values above {} stand at the upper edge", envelope.limit));
        }
    }
    if hidden > 0 {
        notes.push(format!("values without a place on the axes, not drawn: {hidden}"));
    }
    panels_drawn(figure, &plan, &y_title, &notes)
}

/// Ours, the published ones, and the name of the x at which they are 1, where they are divided.
pub(super) fn values(
    figure: &Figure,
    selection: &Selection<'_>,
    published: &Published,
) -> Result<Values, ChartError> {
    let mut ours = selection.points_by_column(figure)?;
    let panels = select::distinct(&ours, |point| &point.panel);
    let mut theirs = select::published(figure, published, Measure::Seconds, &panels);
    let base = figure.normalise_to.as_ref();
    let first =
        base.map(|base| select::normalise_both(&mut ours, &mut theirs, base)).transpose()?;
    Ok((ours, theirs, first))
}

fn plan(
    figure: &Figure,
    panels: Vec<String>,
    (mut ours, mut published, envelope): (Vec<Point>, Vec<Point>, Vec<Point>),
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
    let (x, y) = fitted_axes(figure, &ours, &published, &envelope)?;
    let named: Vec<Point> = ours.iter().chain(&published).cloned().collect();
    let crowds = envelope::crowds(figure, &ours);
    let series =
        envelope::by_standing_out(select::distinct(&named, |point| &point.series), &crowds);
    let marks = Vec::new();
    Ok((Plan { ours, published, envelope, marks, crowds, panels, series, x, y }, hidden))
}

/// Axes over all values, their intervals, the envelope and the reference.
fn fitted_axes(
    figure: &Figure,
    ours: &[Point],
    published: &[Point],
    envelope: &[Point],
) -> Result<(Axis, Axis), ChartError> {
    let all = || ours.iter().chain(published);
    let xs: Vec<f64> = all().filter_map(Point::x_number).collect();
    let mut ys: Vec<f64> = all().map(|point| point.y).chain(figure.reference).collect();
    ys.extend(all().filter_map(|point| point.interval).flat_map(|(low, high)| [low, high]));
    let none = || ChartError::Nothing("no value is above zero".to_owned());
    let x = if figure.x_scale == Scale::Log {
        Axis::log(&xs).ok_or_else(none)?
    } else {
        Axis::exact(&xs)
    };
    ys.extend(envelope.iter().map(|point| point.y));
    if let Some(settings) = &figure.envelope {
        ys.iter_mut().for_each(|y| *y = y.min(settings.limit));
    }
    let y = if figure.scale == Scale::Log {
        Axis::log(&ys).ok_or_else(none)?
    } else {
        Axis::fitted(&ys, TICKS)
    };
    Ok((x, y))
}

fn panels_drawn(
    figure: &Figure,
    plan: &Plan,
    y_title: &str,
    notes: &[String],
) -> Result<String, ChartError> {
    let columns = plan.panels.len().clamp(1, COLUMNS);
    let plot = [640.0, 400.0, 300.0][columns - 1];
    let width_of = |words: &String| text::width(words, SMALL, false);
    let ticks = plan.y.ticks(TICKS);
    let left = ticks.iter().map(|(_, label)| width_of(label)).fold(0.0, f64::max) + 10.0;
    let names = plan.series.iter().map(|name| width_of(&label(figure, plan, "", name)));
    let right = LABEL_INDENT + names.fold(0.0, f64::max) + 14.0;
    let height = (plan.series.len() as f64 * LABEL_GAP + 20.0).max(330.0);
    let width = 2.0 * MARGIN + left + columns as f64 * (plot + right);

    let mut frame = Frame::new(figure, width);
    frame.paragraph(y_title, Type::new(SMALL, GREY));
    let mut top = frame.top + 6.0;
    let mut bottom = top;
    for (index, panel) in plan.panels.iter().enumerate() {
        let column = index % columns;
        if column == 0 && index > 0 {
            top = bottom + 22.0;
        }
        let start = MARGIN + left + column as f64 * (plot + right);
        let room = Room { left: start, top, plot, height, width: plot + right - 10.0 };
        bottom = bottom.max(panel_drawn(&mut frame, figure, plan, panel, &room, column == 0));
    }
    let description = described(figure, plan, y_title);
    frame.close(figure, bottom, notes, &description)
}

/// What a panel may fill: the plot, with `width` for the words above and below it.
struct Room {
    left: f64,
    top: f64,
    plot: f64,
    height: f64,
    width: f64,
}

/// Draws one panel and returns where it ends below.
fn panel_drawn(
    frame: &mut Frame,
    figure: &Figure,
    plan: &Plan,
    panel: &str,
    room: &Room,
    labelled: bool,
) -> f64 {
    let heading = heading(figure, panel, room.width);
    for (line, words) in heading.iter().enumerate() {
        let at = (room.left, room.top + 10.0 + 17.0 * line as f64);
        frame.canvas.text(at, words, Type::new(13.0, INK).bold());
    }
    let top = room.top + 17.0 * heading.len() as f64 + 12.0;
    let area =
        Area { left: room.left, right: room.left + room.plot, top, bottom: top + room.height };
    envelope::drawn(frame, plan, panel, &area);
    axes(frame, figure, plan, &area, labelled);
    upright::drawn(frame, plan, &area);
    series_drawn(frame, figure, plan, panel, &area);
    let x_title = figure.x_title.clone().unwrap_or_else(|| title(&figure.x.list().join(" ")));
    let mut under = area.bottom + 36.0;
    for words in text::wrap(&x_title, SMALL, false, room.width) {
        frame.canvas.text((area.left, under), &words, Type::new(SMALL, GREY));
        under += 16.0;
    }
    envelope::crowd_named(frame, figure, plan, panel, (area.left, under, room.width))
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
    let own = plan.ours.iter().filter_map(|point| Some((point.x_number()?, point.x.clone())));
    let mut own: Vec<(f64, String)> = own.collect();
    own.sort_by(|a, b| a.0.total_cmp(&b.0));
    own.dedup_by(|a, b| a.0 == b.0);
    let few = own.len() <= 11 && plan.x.fit(&own, width, SMALL);
    if few { own } else { plan.x.ticks_within(width, SMALL) }
}

fn described(figure: &Figure, plan: &Plan, y_title: &str) -> String {
    let ranges = plan.series.iter().map(|name| {
        let mine = plan.ours.iter().filter(|point| point.series == *name).map(|point| point.y);
        let (low, high) = mine
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
        let name = figure.label(name);
        if low > high {
            format!("{name} published only")
        } else {
            format!("{name} {} to {}", text::figure(low), text::figure(high))
        }
    });
    format!("Line chart of {y_title}: {}.", ranges.collect::<Vec<_>>().join("; "))
}

//! Return codes: which share of the calls ends where, and below it, on the same categories, what a
//! call that ends there costs.

use super::axis::Axis;
use super::canvas::{Anchor, Type};
use super::figure::Figure;
use super::frame::{Frame, MARGIN, SMALL, published_note, title};
use super::palette::{FAINT, GREY, INK, style};
use super::published::{Measure, Published};
use super::select::{self, Point, Selection};
use super::{ChartError, text};
use crate::table::Row;

const HEIGHT: f64 = 190.0;
const TICKS: usize = 5;
const BAR_LIMIT: f64 = 46.0;
const SLOT: f64 = 66.0;
const VALUE_SIZE: f64 = 11.0;

/// One of the two charts.
pub(super) struct Half {
    title: String,
    pub ours: Vec<Point>,
    pub published: Vec<Point>,
    axis: Axis,
}

/// What both charts share.
struct Plan {
    categories: Vec<String>,
    series: Vec<String>,
    left: f64,
    slot: f64,
}

/// Draws the figure.
pub(super) fn draw(
    figure: &Figure,
    rows: &[Row],
    published: &Published,
) -> Result<String, ChartError> {
    let selection = Selection::new(figure, rows)?;
    let mut halves = vec![upper(figure, &selection, published)?];
    let mut notes = vec![selection.source(), published_note(figure)];
    if let Some(column) = &figure.y_below {
        match lower(figure, column, &selection, published) {
            Ok(half) => halves.push(half),
            // The shares alone are still an answer.
            Err(ChartError::Nothing(reason)) => {
                notes.push(format!("the lower chart is not drawn: {reason}"))
            }
            Err(error) => return Err(error),
        }
    }
    if halves.iter().flat_map(|half| &half.ours).any(|point| point.interval.is_some()) {
        notes.push("whiskers: intervals".to_owned());
    }
    let plan = plan(&halves);
    drawn(figure, published, &plan, &halves, &notes)
}

/// What the upper chart shows.
pub(super) fn upper(
    figure: &Figure,
    selection: &Selection<'_>,
    published: &Published,
) -> Result<Half, ChartError> {
    let mut ours = selection.points(figure, &figure.y)?;
    let share = figure.y == "share";
    let measure = if share { Measure::Share } else { Measure::Seconds };
    let mut theirs = select::published(figure, published, measure, &[String::new()]);
    if share {
        ours.iter_mut().chain(&mut theirs).for_each(|point| select::scale(point, 100.0));
    }
    let title = figure.y_title.clone().unwrap_or_else(|| title(&figure.y));
    Ok(half(title, ours, theirs))
}

/// What the lower chart shows.
pub(super) fn lower(
    figure: &Figure,
    column: &str,
    selection: &Selection<'_>,
    published: &Published,
) -> Result<Half, ChartError> {
    let mut ours = selection.points(figure, column)?;
    let mut theirs = select::published(figure, published, Measure::Seconds, &[String::new()]);
    let mut title = figure.y_below_title.clone().unwrap_or_else(|| title(column));
    if let Some(base) = &figure.normalise_to {
        relative(&mut ours, base)?;
        relative(&mut theirs, base)?;
        title = format!("{title}, relative to {} {base}", figure.x.list().join(" "));
    }
    Ok(half(title, ours, theirs))
}

fn half(title: String, ours: Vec<Point>, published: Vec<Point>) -> Half {
    let all = || ours.iter().chain(&published);
    let mut values: Vec<f64> = all().map(|point| point.y).collect();
    values.extend(all().filter_map(|point| point.interval).map(|(_, high)| high));
    let axis = Axis::from_zero(&values, TICKS);
    Half { title, ours, published, axis }
}

/// Divides each series by its own value in the category `base`.
fn relative(points: &mut [Point], base: &str) -> Result<(), ChartError> {
    for series in select::distinct(points, |point| &point.series) {
        let mine = |point: &&Point| point.series == series && point.x == base;
        let unit = points.iter().find(mine).map(|point| point.y).filter(|unit| *unit != 0.0);
        let missing =
            || ChartError::Nothing(format!("{series} has no value at '{base}' to divide by"));
        let unit = unit.ok_or_else(missing)?;
        points
            .iter_mut()
            .filter(|point| point.series == series)
            .for_each(|point| select::scale(point, 1.0 / unit));
    }
    Ok(())
}

fn plan(halves: &[Half]) -> Plan {
    let all: Vec<Point> =
        halves.iter().flat_map(|half| half.ours.iter().chain(&half.published)).cloned().collect();
    let mut categories = select::distinct(&all, |point| &point.x);
    let number = |name: &String| name.parse::<f64>().unwrap_or(f64::INFINITY);
    categories.sort_by(|a, b| number(a).total_cmp(&number(b)));
    let series = select::distinct(&all, |point| &point.series);
    let ticks = halves.iter().flat_map(|half| half.axis.ticks(TICKS));
    let left = ticks.map(|(_, words)| text::width(&words, SMALL, false)).fold(0.0, f64::max) + 10.0;
    let slot = (SLOT * series.len() as f64 + 24.0).max(118.0);
    Plan { categories, series, left: MARGIN + left, slot }
}

fn drawn(
    figure: &Figure,
    published: &Published,
    plan: &Plan,
    halves: &[Half],
    notes: &[String],
) -> Result<String, ChartError> {
    let width = (plan.left + plan.slot * plan.categories.len() as f64 + MARGIN).max(640.0);
    let mut frame = Frame::new(figure, width);
    if plan.series.len() > 1 {
        legend(&mut frame, figure, plan, width);
    }
    for half in halves {
        frame.paragraph(&half.title, Type::new(SMALL, GREY));
        let (top, bottom) = (frame.top + 26.0, frame.top + 26.0 + HEIGHT);
        axis(&mut frame, plan, half, top, bottom);
        for (index, category) in plan.categories.iter().enumerate() {
            let middle = plan.left + plan.slot * (index as f64 + 0.5);
            columns(&mut frame, plan, half, category, middle, (top, bottom));
            let words = Type::new(SMALL, INK).bold().at(Anchor::Middle);
            frame.canvas.text((middle, bottom + 15.0), category, words);
        }
        frame.top = bottom + 32.0;
    }
    let meanings = meanings(&mut frame, figure, published, plan);
    frame.top += meanings;
    let x_title = figure.x_title.clone().unwrap_or_else(|| title(&figure.x.list().join(" ")));
    frame.paragraph(&x_title, Type::new(SMALL, GREY));
    let description = described(figure, plan, halves);
    let bottom = frame.top;
    frame.close(figure, bottom, notes, &description)
}

/// Colour and shape of each series, in a row without a box.
fn legend(frame: &mut Frame, figure: &Figure, plan: &Plan, width: f64) {
    let mut x = MARGIN + 6.0;
    for (index, name) in plan.series.iter().enumerate() {
        let words = figure.label(name);
        let room = 14.0 + text::width(&words, SMALL, false) + 22.0;
        if x + room > width - MARGIN && x > MARGIN + 6.0 {
            x = MARGIN + 6.0;
            frame.top += 19.0;
        }
        let (colour, shape) = style(index);
        frame.canvas.marker(shape, (x, frame.top + 8.0), 5.0, colour);
        frame.canvas.text((x + 12.0, frame.top + 8.0), &words, Type::new(SMALL, INK));
        x += room;
    }
    frame.top += 30.0;
}

fn axis(frame: &mut Frame, plan: &Plan, half: &Half, top: f64, bottom: f64) {
    let right = plan.left + plan.slot * plan.categories.len() as f64;
    for (value, words) in half.axis.ticks(TICKS) {
        let y = bottom - half.axis.place(value) * (bottom - top);
        let colour = if value == 0.0 { GREY } else { FAINT };
        frame.canvas.line(&[(plan.left, y), (right, y)], colour, 1.0);
        frame.canvas.text((plan.left - 8.0, y), &words, Type::new(SMALL, GREY).at(Anchor::End));
    }
}

fn columns(
    frame: &mut Frame,
    plan: &Plan,
    half: &Half,
    category: &str,
    middle: f64,
    (top, bottom): (f64, f64),
) {
    let at = |value: f64| bottom - half.axis.place(value) * (bottom - top);
    let count = plan.series.len() as f64;
    let bar = if count > 1.0 { BAR_LIMIT * 0.8 } else { BAR_LIMIT };
    for (index, series) in plan.series.iter().enumerate() {
        let x = middle + SLOT * (index as f64 - (count - 1.0) / 2.0);
        let (colour, shape) = style(index);
        let wanted = |point: &&Point| point.x == category && point.series == *series;
        let mut end = bottom;
        let ours = half.ours.iter().find(wanted);
        if let Some(point) = ours {
            frame.canvas.bar((x - bar / 2.0, at(point.y)), (x + bar / 2.0, at(0.0)), colour);
            end = at(point.y.max(0.0));
            if let Some((low, high)) = point.interval {
                frame.canvas.whisker((x, at(low)), (x, at(high)), 5.0, INK);
                end = end.min(at(high));
            }
        }
        let published = half.published.iter().find(wanted);
        if let Some(point) = published {
            // Beside the bar's middle, where the whisker is.
            let aside = if ours.is_some() { bar / 2.0 + 1.0 } else { 0.0 };
            frame.canvas.hollow(shape, (x + aside, at(point.y)), 5.0, colour);
            end = end.min(at(point.y) - 6.0);
        }
        let colour = if ours.is_some() { INK } else { GREY };
        let words = ours.or(published).map_or("–".to_owned(), |point| text::figure(point.y));
        frame.canvas.value(
            (x, end - 10.0),
            &words,
            Type::new(VALUE_SIZE, colour).at(Anchor::Middle),
        );
    }
}

/// What each category means, under its name; returns the height used.
fn meanings(frame: &mut Frame, figure: &Figure, published: &Published, plan: &Plan) -> f64 {
    let mut most = 0;
    for (index, category) in plan.categories.iter().enumerate() {
        let table = figure.published.as_ref().map_or("", |beside| beside.table.as_str());
        let own = figure.labels.get(category).map(String::as_str);
        let words = own.or_else(|| published.meaning(table, category)).unwrap_or("");
        let lines = text::wrap(words, VALUE_SIZE, false, plan.slot - 12.0);
        for (line, words) in lines.iter().enumerate() {
            let at = (plan.left + plan.slot * (index as f64 + 0.5), frame.top + 14.0 * line as f64);
            frame.canvas.text(at, words, Type::new(VALUE_SIZE, GREY).at(Anchor::Middle));
        }
        most = most.max(lines.len());
    }
    14.0 * most as f64 + 4.0
}

fn described(figure: &Figure, plan: &Plan, halves: &[Half]) -> String {
    let half = |half: &Half| {
        let values = half.ours.iter().map(|point| {
            let series = if plan.series.len() > 1 {
                format!("{} ", figure.label(&point.series))
            } else {
                String::new()
            };
            format!("{series}{} {}", point.x, text::figure(point.y))
        });
        format!("{}: {}.", half.title, values.collect::<Vec<_>>().join("; "))
    };
    format!(
        "Bar charts on the same categories. {}",
        halves.iter().map(half).collect::<Vec<_>>().join(" ")
    )
}

//! Horizontal bars grouped by category: thesis H's illustrations. On a log axis, where nothing can
//! start at zero, points with whiskers take the bars' place.

use super::axis::Axis;
use super::bar_widths::Widths;
use super::canvas::{Anchor, Type};
use super::figure::{Figure, Scale, Within};
use super::frame::{Frame, MARGIN, SMALL, bound_note, heading, published_note, title};
use super::palette::{FAINT, GREY, INK, style};
use super::published::{Measure, Published};
use super::select::{self, Point, Selection, Values};
use super::{ChartError, text};
use crate::table::Row;

const BAR: f64 = 15.0;
const BAR_GAP: f64 = 3.0;
const GROUP_GAP: f64 = 11.0;
const LINE: f64 = 15.0;
const CATEGORY_LIMIT: f64 = 230.0;
pub(super) const SERIES_SIZE: f64 = 11.0;
pub(super) const VALUE_SIZE: f64 = 11.0;

/// One category: its label in lines, and which series have a value in it.
pub(super) struct Group {
    pub name: String,
    pub lines: Vec<String>,
    pub series: Vec<usize>,
}

impl Group {
    fn height(&self) -> f64 {
        let bars = self.series.len() as f64 * (BAR + BAR_GAP) - BAR_GAP;
        bars.max(self.lines.len() as f64 * LINE)
    }
}

pub(super) struct Plan {
    pub ours: Vec<Point>,
    pub published: Vec<Point>,
    pub panels: Vec<String>,
    pub series: Vec<String>,
    pub groups: Vec<Group>,
    axis: Axis,
}

/// Draws the figure.
pub(super) fn draw(
    figure: &Figure,
    rows: &[Row],
    published: &Published,
) -> Result<String, ChartError> {
    let selection = Selection::new(figure, rows)?;
    let ((mut ours, mut theirs, relative_to), without_unit) =
        values(figure, &selection, published)?;
    let panels = select::distinct(&ours, |point| &point.panel);
    let mut y_title = figure.y_title.clone().unwrap_or_else(|| title(&figure.y));
    if let Some(relative_to) = relative_to {
        y_title = format!("{y_title}, relative to {relative_to}");
    }
    if figure.scale == Scale::Log {
        y_title.push_str(" (log scale)");
    }
    if figure.bound.is_some() {
        theirs.extend(selection.bounds(figure)?);
        ours.retain(|point| point.y > 0.0);
    }
    let before = ours.len() + theirs.len();
    for points in [&mut ours, &mut theirs] {
        points.retain(|point| figure.scale == Scale::Linear || point.y > 0.0);
    }
    let hidden = before - ours.len() - theirs.len() + without_unit;
    let plan = plan(figure, panels, ours, theirs)?;
    let mut notes = vec![
        selection.source(),
        published_note(figure),
        bound_note(figure),
        selection.without(&figure.y),
    ];
    if plan.ours.iter().any(|point| point.interval.is_some()) {
        notes.push(figure.intervals("whiskers"));
    }
    if hidden > 0 {
        notes.push(format!("values without a place on the axis, not drawn: {hidden}"));
    }
    drawn(figure, &plan, &y_title, &notes)
}

/// Ours, the published ones, and by what they are divided, if they are; how many of them had nothing
/// to be divided by.
pub(super) fn values(
    figure: &Figure,
    selection: &Selection<'_>,
    published: &Published,
) -> Result<(Values, usize), ChartError> {
    let mut ours = selection.points_of_all(figure)?;
    let panels = select::distinct(&ours, |point| &point.panel);
    let mut theirs = select::published(figure, published, Measure::Seconds, &panels);
    let Some(base) = &figure.normalise_to else { return Ok(((ours, theirs, None), 0)) };
    let name = figure.label(base);
    if figure.normalise == Within::Panel {
        let first = select::normalise_both(&mut ours, &mut theirs, base)?;
        let relative_to = format!("{name} at {}", figure.label(&first));
        return Ok(((ours, theirs, Some(relative_to)), 0));
    }
    let mut left_out = select::normalise_within_x(&mut theirs, base);
    left_out += select::normalise_within_x(&mut ours, base);
    if ours.is_empty() {
        return Err(ChartError::Nothing(format!("there is no value of {base} to divide by")));
    }
    Ok(((ours, theirs, Some(format!("{name} in the same group"))), left_out))
}

fn plan(
    figure: &Figure,
    panels: Vec<String>,
    ours: Vec<Point>,
    published: Vec<Point>,
) -> Result<Plan, ChartError> {
    if ours.is_empty() && (figure.bound.is_none() || published.is_empty()) {
        return Err(ChartError::Nothing("no value is above zero".to_owned()));
    }
    let all: Vec<Point> = ours.iter().chain(&published).cloned().collect();
    let mut values: Vec<f64> = all.iter().map(|point| point.y).chain(figure.reference).collect();
    values
        .extend(all.iter().filter_map(|point| point.interval).flat_map(|(low, high)| [low, high]));
    let axis = match figure.scale {
        Scale::Linear => Axis::from_zero(&values, 5),
        Scale::Log => Axis::log(&values)
            .ok_or_else(|| ChartError::Nothing("no value is above zero".to_owned()))?,
    };
    let series = select::distinct(&all, |point| &point.series);
    let group = |name: String| {
        let has =
            |series: &String| all.iter().any(|point| point.x == name && point.series == *series);
        let present =
            series.iter().enumerate().filter(|(_, series)| has(series)).map(|(index, _)| index);
        let lines = text::wrap(&figure.label(&name), SMALL, true, CATEGORY_LIMIT);
        Group { lines, series: present.collect(), name }
    };
    let groups = select::distinct(&all, |point| &point.x).into_iter().map(group).collect();
    Ok(Plan { ours, published, panels, series, groups, axis })
}

fn drawn(
    figure: &Figure,
    plan: &Plan,
    y_title: &str,
    notes: &[String],
) -> Result<String, ChartError> {
    let widths = Widths::new(figure, plan);
    let mut frame = Frame::new(figure, widths.panel(plan.panels.len().max(1)) + MARGIN);
    let room = widths.plot + widths.value;
    let headings = plan.panels.iter().map(|panel| heading(figure, panel, room));
    let headings: Vec<_> = headings.collect();
    for (index, heading) in headings.iter().enumerate() {
        for (line, words) in heading.iter().enumerate() {
            let at = (widths.panel(index), frame.top + 9.0 + 17.0 * line as f64);
            frame.canvas.text(at, words, Type::new(13.0, INK).bold());
        }
    }
    let top = frame.top + 17.0 * headings.iter().map(Vec::len).max().unwrap_or(0) as f64 + 8.0;
    let heights = plan.groups.iter().map(|group| group.height() + GROUP_GAP);
    let bottom = top + heights.sum::<f64>();
    for (index, panel) in plan.panels.iter().enumerate() {
        axis(&mut frame, figure, plan, widths.panel(index), widths.plot, (top, bottom));
        let mut y = top + GROUP_GAP / 2.0;
        for group in &plan.groups {
            if index == 0 {
                names(&mut frame, figure, plan, group, &widths, y);
            }
            bars(&mut frame, figure, plan, panel, group, (widths.panel(index), widths.plot), y);
            y += group.height() + GROUP_GAP;
        }
    }
    let mut under = bottom + 36.0;
    for words in text::wrap(y_title, SMALL, false, room * plan.panels.len() as f64) {
        frame.canvas.text((widths.panel(0), under), &words, Type::new(SMALL, GREY));
        under += 16.0;
    }
    let description = described(figure, plan, y_title);
    frame.close(figure, under, notes, &description)
}

fn axis(
    frame: &mut Frame,
    figure: &Figure,
    plan: &Plan,
    left: f64,
    width: f64,
    (top, bottom): (f64, f64),
) {
    for (value, words) in plan.axis.ticks_within(width, SMALL) {
        let x = left + plan.axis.place(value) * width;
        let zero = value == 0.0 && plan.axis.has_zero();
        frame.canvas.line(&[(x, top), (x, bottom + 4.0)], if zero { GREY } else { FAINT }, 1.0);
        frame.canvas.text((x, bottom + 15.0), &words, Type::new(SMALL, GREY).at(Anchor::Middle));
    }
    if let Some(reference) = figure.reference.filter(|value| plan.axis.shows(*value)) {
        let x = left + plan.axis.place(reference) * width;
        frame.canvas.dashed(&[(x, top), (x, bottom)], GREY, 1.2);
    }
}

fn names(frame: &mut Frame, figure: &Figure, plan: &Plan, group: &Group, widths: &Widths, y: f64) {
    let first = y + if group.series.len() == 1 {
        (group.height() - group.lines.len() as f64 * LINE) / 2.0
    } else {
        0.0
    };
    for (line, words) in group.lines.iter().enumerate() {
        let at = (MARGIN, first + LINE * (line as f64 + 0.5));
        frame.canvas.text(at, words, Type::new(SMALL, INK).bold());
    }
    if widths.series > 0.0 {
        for (bar, series) in group.series.iter().enumerate() {
            let at = (widths.panel(0) - 8.0, bar_middle(group, y, bar));
            let words = figure.label(&plan.series[*series]);
            frame.canvas.text(at, &words, Type::new(SERIES_SIZE, GREY).at(Anchor::End));
        }
    }
}

fn bar_middle(group: &Group, y: f64, bar: usize) -> f64 {
    let bars = group.series.len() as f64 * (BAR + BAR_GAP) - BAR_GAP;
    let first = if group.series.len() == 1 { y + (group.height() - bars) / 2.0 } else { y };
    first + (BAR + BAR_GAP) * bar as f64 + BAR / 2.0
}

fn bars(
    frame: &mut Frame,
    figure: &Figure,
    plan: &Plan,
    panel: &str,
    group: &Group,
    (left, width): (f64, f64),
    y: f64,
) {
    let at = |value: f64| left + plan.axis.place(value) * width;
    for (bar, series) in group.series.iter().enumerate() {
        let middle = bar_middle(group, y, bar);
        let (colour, shape) = style(*series);
        let wanted = |point: &&Point| {
            point.panel == panel && point.x == group.name && point.series == plan.series[*series]
        };
        let (ours, published) = (plan.ours.iter().find(wanted), plan.published.iter().find(wanted));
        let mut end = published.map_or(left, |point| at(point.y) + 6.0);
        if let Some(point) = ours {
            end = end.max(at(point.y.max(0.0)));
            let whisker = point.interval.map(|(low, high)| ((at(low), middle), (at(high), middle)));
            end = whisker.map_or(end, |(_, high)| end.max(high.0));
            if plan.axis.has_zero() {
                let half = BAR / 2.0;
                frame.canvas.bar((at(0.0), middle - half), (at(point.y), middle + half), colour);
            }
            if let Some((low, high)) = whisker {
                frame.canvas.whisker(low, high, 4.0, INK);
            }
            if !plan.axis.has_zero() {
                frame.canvas.marker(shape, (at(point.y), middle), 4.5, colour);
                end += 6.0;
            }
        }
        // Over the bar, which may be longer, but under no number.
        if let Some(point) = published {
            frame.canvas.hollow(shape, (at(point.y), middle), 4.5, colour);
        }
        let words = value_words(figure, ours, published);
        let ink = if ours.is_some() { INK } else { GREY };
        frame.canvas.value((end + 7.0, middle), &words, Type::new(VALUE_SIZE, ink));
    }
}

/// A value, a bound as one, or a dash.
fn value_words(figure: &Figure, ours: Option<&Point>, published: Option<&Point>) -> String {
    let words = ours.or(published).map_or("–".to_owned(), |point| text::figure(point.y));
    let is_bound = ours.is_none() && published.is_some() && figure.bound.is_some();
    if is_bound { format!("< {words}") } else { words }
}

fn described(figure: &Figure, plan: &Plan, y_title: &str) -> String {
    let extreme = |better: fn(f64, f64) -> bool| {
        let point = plan.ours.iter().reduce(|a, b| if better(b.y, a.y) { b } else { a });
        point.map_or(String::new(), |point| {
            // An empty x may have words, the panel of a figure without panels has none.
            let panel = Some(&point.panel).filter(|panel| !panel.is_empty());
            let names = panel.into_iter().chain([&point.x, &point.series]);
            let names: Vec<_> =
                names.map(|name| figure.label(name)).filter(|name| !name.is_empty()).collect();
            format!("{} ({})", text::figure(point.y), names.join(", "))
        })
    };
    format!(
        "Bar chart of {y_title} for {} categories: smallest {}, largest {}.",
        plan.groups.len(),
        extreme(|a, b| a < b),
        extreme(|a, b| a > b)
    )
}

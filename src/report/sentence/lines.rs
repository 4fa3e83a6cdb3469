//! Lines: who is best at the start and at the end, where that changes, and what was published.

use super::bars::panels;
use super::named::{Named, apart};
use crate::chart::{Point, short_figure};
use crate::report::words::percent;

/// Panels told one by one with all that there is to say.
const PANELS: usize = 3;

/// What lines show.
pub(super) fn sentence(named: &Named<'_>, ours: &[Point], published: &[Point]) -> String {
    let all: Vec<&Point> = ours.iter().filter(|point| point.x_number().is_some()).collect();
    let panels = panels(&all);
    let mut parts: Vec<String> = Vec::new();
    for panel in &panels {
        let points: Vec<&Point> = all.iter().copied().filter(|point| point.panel == *panel).collect();
        let words = of_panel(named, &points, panels.len() <= PANELS);
        parts.push(format!("{}{words}.", named.panel(panel, panels.len() > 1)));
    }
    parts.extend(furthest(named, ours, published));
    parts.join(" ")
}

/// The best of each x, from left to right.
struct Lead<'a> {
    x: f64,
    best: &'a Point,
    next: Option<&'a Point>,
}

fn leads<'a>(named: &Named<'_>, points: &[&'a Point]) -> Vec<Lead<'a>> {
    let sense = named.sense();
    let mut order: Vec<&Point> = points.to_vec();
    let place = |point: &Point| point.x_number().unwrap_or(f64::INFINITY);
    order.sort_by(|a, b| place(a).total_cmp(&place(b)).then(sense.order(a.y, b.y)));
    let columns = order.chunk_by(|a, b| place(a) == place(b));
    let lead = |column: &[&'a Point]| Lead {
        x: place(column[0]),
        best: column[0],
        next: column.get(1).copied(),
    };
    columns.map(lead).collect()
}

fn of_panel(named: &Named<'_>, points: &[&Point], whole: bool) -> String {
    let leads = leads(named, points);
    let (Some(first), Some(last)) = (leads.first(), leads.last()) else {
        return "nothing was measured".to_owned();
    };
    let x = x_name(named);
    let alone = points.iter().all(|point| point.series == points[0].series);
    if alone {
        return growth(named, points, &x);
    }
    if leads.len() == 1 {
        return format!("at {x} {} {}", short_figure(first.x), led(named, first));
    }
    let mut words = changes(named, &leads, &x);
    if whole {
        words += &format!(
            "; at {x} {} {}, and at {} {}",
            short_figure(first.x),
            led(named, first),
            short_figure(last.x),
            led(named, last)
        );
        let mine: Vec<&Point> =
            points.iter().copied().filter(|point| point.series == first.best.series).collect();
        words += &format!("; {}", growth(named, &mine, &x));
    }
    words
}

/// `x is the fastest (1 ns), y comes next, 3 % slower`
fn led(named: &Named<'_>, lead: &Lead<'_>) -> String {
    let (sense, label) = (named.sense(), |point: &Point| named.figure.label(&point.series));
    let mut words = format!("{} has {}", label(lead.best), named.value(lead.best));
    if let Some(next) = lead.next {
        let behind = sense.behind(lead.best.y, next.y);
        let behind = if behind.is_empty() { named.value(next) } else { behind };
        words += &format!(" with {} {behind}{}", label(next), apart(lead.best, next));
    }
    words
}

/// Who is the best where.
fn changes(named: &Named<'_>, leads: &[Lead<'_>], x: &str) -> String {
    const MOST: usize = 3;
    let best = named.sense().best;
    let label = |lead: &Lead<'_>| named.figure.label(&lead.best.series);
    let runs: Vec<&[Lead<'_>]> =
        leads.chunk_by(|a, b| a.best.series == b.best.series).collect();
    if let [only] = runs.as_slice() {
        return format!("{} {best} at every {x}", label(&only[0]));
    }
    let run = |run: &&[Lead<'_>]| {
        let (from, to) = (short_figure(run[0].x), short_figure(run[run.len() - 1].x));
        let span = if from == to { format!("at {from}") } else { format!("from {from} to {to}") };
        format!("{} {span}", label(&run[0]))
    };
    let told: Vec<String> = runs.iter().take(MOST).map(run).collect();
    let more = match runs.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!(", and it changes {more} more times"),
    };
    format!("which one {best} changes with {x}: {}{more}", told.join(", "))
}

/// How the values of one series change from left to right.
fn growth(named: &Named<'_>, points: &[&Point], x: &str) -> String {
    let mut order = points.to_vec();
    order.sort_by(|a, b| a.x_number().partial_cmp(&b.x_number()).unwrap_or(std::cmp::Ordering::Equal));
    let (Some(first), Some(last)) = (order.first(), order.last()) else { return String::new() };
    let name = named.figure.label(&first.series);
    if order.len() == 1 {
        return format!("{name} has {} at {x} {}", named.value(first), first.x);
    }
    let change = last.y / first.y - 1.0;
    let change = match change {
        change if !change.is_finite() || first.y <= 0.0 => String::new(),
        change if change >= 1.0 => format!(", {} times as much", short_figure(1.0 + change)),
        change if change > 0.0 => format!(", {} more", percent(change)),
        change => format!(", {} less", percent(-change)),
    };
    format!(
        "{name} goes from {} at {x} {} to {} at {}{change}",
        named.value(first),
        first.x,
        named.value(last),
        last.x
    )
}

fn x_name(named: &Named<'_>) -> String {
    let column = named.figure.x.list().first().map_or("x", String::as_str);
    column.replace('_', " ")
}

/// Where the published figures are furthest from ours.
pub(super) fn furthest(named: &Named<'_>, ours: &[Point], published: &[Point]) -> Option<String> {
    let twins = published.iter().filter_map(|theirs| {
        let same = |point: &&Point| {
            point.panel == theirs.panel && point.series == theirs.series && point.x == theirs.x
        };
        let mine = ours.iter().find(same)?;
        let apart = (mine.y / theirs.y).ln().abs();
        apart.is_finite().then_some((apart, mine, theirs))
    });
    let (_, mine, theirs) = twins.max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(format!(
        "The published figure that is furthest from ours is that of {} at {}: {} there, {} here.",
        named.figure.label(&mine.series),
        named.figure.label(&mine.x),
        short_figure(theirs.y),
        named.value(mine)
    ))
}

//! Lines: who is best at the start and at the end, where that changes, and what was published.

use super::bars::panels;
use super::named::{Named, apart};
use crate::chart::{Kind, Point, short_figure};
use crate::report::words::percent;

/// Panels told one by one with all that there is to say.
const PANELS: usize = 3;

/// What lines show.
pub(super) fn sentences(named: &Named<'_>, ours: &[Point], published: &[Point]) -> Vec<String> {
    let all: Vec<&Point> = ours.iter().filter(|point| point.x_number().is_some()).collect();
    let panels = panels(&all);
    let mut parts: Vec<String> = Vec::new();
    for panel in &panels {
        let points: Vec<&Point> =
            all.iter().copied().filter(|point| point.panel == *panel).collect();
        let words = of_panel(named, &points, panels.len() <= PANELS);
        parts.push(format!("{}{words}.", named.panel(panel, panels.len() > 1)));
    }
    parts.extend(furthest(named, ours, published));
    parts
}

/// The best and the next at an x that most series have a value at.
struct Lead<'a> {
    best: &'a Point,
    next: Option<&'a Point>,
}

/// From left to right; none where the series have no x in common.
fn leads<'a>(named: &Named<'_>, points: &[&'a Point], series: usize) -> Vec<Lead<'a>> {
    let sense = named.sense();
    let mut order: Vec<&Point> = points.to_vec();
    order.sort_by(|a, b| place(a).total_cmp(&place(b)).then(sense.order(a.y, b.y)));
    let columns = order.chunk_by(|a, b| place(a) == place(b));
    let shared = columns.filter(|column| 2 * column.len() > series);
    shared.map(|column| Lead { best: column[0], next: column.get(1).copied() }).collect()
}

fn place(point: &Point) -> f64 {
    point.x_number().unwrap_or(f64::INFINITY)
}

fn of_panel(named: &Named<'_>, points: &[&Point], whole: bool) -> String {
    const TOLD: usize = 4;
    let mut series: Vec<&String> = Vec::new();
    for point in points {
        if !series.contains(&&point.series) {
            series.push(&point.series);
        }
    }
    let of = |name: &String| -> Vec<&Point> {
        points.iter().copied().filter(|point| point.series == *name).collect()
    };
    let leads = if series.len() > 1 { leads(named, points, series.len()) } else { Vec::new() };
    if leads.is_empty() {
        let told: Vec<String> = series.iter().map(|name| growth(named, &of(name), true)).collect();
        let more = match told.len().saturating_sub(TOLD) {
            0 => String::new(),
            more => format!("; {more} more"),
        };
        return format!("{}{more}", told[..told.len().min(TOLD)].join("; "));
    }
    let words = runs(named, &leads);
    if !whole {
        return words;
    }
    format!("{words}; {}", growth(named, &of(&leads[0].best.series), false))
}

/// Who is the best where, and by how much at the start, at the end and where there is one value.
fn runs(named: &Named<'_>, leads: &[Lead<'_>]) -> String {
    const MOST: usize = 3;
    let x = x_name(named);
    let runs: Vec<&[Lead<'_>]> = leads.chunk_by(|a, b| a.best.series == b.best.series).collect();
    let last = runs.len() - 1;
    let run = |(index, run): (usize, &&[Lead<'_>])| {
        let (first, end) = (&run[0], &run[run.len() - 1]);
        let (from, to) = (&first.best.x, &end.best.x);
        let span = match (index, from == to) {
            (0, true) => format!("at {x} {from}"),
            (_, true) => format!("at {from}"),
            (0, false) => format!("from {x} {from} to {to}"),
            (_, false) => format!("from {from} to {to}"),
        };
        let verb = if index == 0 { named.sense().best } else { "then" };
        let name = named.figure.label(&first.best.series);
        let lead = if index == last && index > 0 { end } else { first };
        let margin = margin(named, lead);
        match index {
            0 => format!("{name} {verb} {span}{margin}"),
            _ => format!("{verb} {name} {span}{margin}"),
        }
    };
    let told: Vec<String> = runs.iter().enumerate().take(MOST).map(run).collect();
    let more = match runs.len().saturating_sub(MOST) {
        0 => String::new(),
        1 => ", and it changes once more".to_owned(),
        more => format!(", and it changes {more} more times"),
    };
    format!("{}{more}", told.join(", "))
}

/// ` (1.23; Wald 3.1 % slower)`, the value with its interval.
fn margin(named: &Named<'_>, lead: &Lead<'_>) -> String {
    let value = named.value(lead.best);
    let Some(next) = lead.next else { return format!(" ({value})") };
    let behind = named.sense().behind(lead.best.y, next.y);
    let behind = if behind.is_empty() { named.value(next) } else { behind };
    format!(
        " ({value} at {}; {} {behind}{})",
        lead.best.x,
        named.figure.label(&next.series),
        apart(lead.best, next)
    )
}

/// How the values of one series change from left to right; `whole` says with which values.
fn growth(named: &Named<'_>, points: &[&Point], whole: bool) -> String {
    let mut order = points.to_vec();
    order.sort_by(|a, b| place(a).total_cmp(&place(b)));
    let (Some(first), Some(last)) = (order.first(), order.last()) else { return String::new() };
    let (name, x) = (named.figure.label(&first.series), x_name(named));
    if first.x == last.x {
        return format!("{name} has {} at {x} {}", named.value(first), first.x);
    }
    let change = last.y / first.y - 1.0;
    let change = match change {
        change if !change.is_finite() || first.y <= 0.0 => "changes".to_owned(),
        change if change.abs() < 5e-5 => "stays the same".to_owned(),
        change if change >= 1.0 => format!("grows to {} times", short_figure(1.0 + change)),
        change if change > 0.0 => format!("grows by {}", percent(change)),
        change => format!("falls by {}", percent(-change)),
    };
    let values = match whole {
        true => format!(": {} and {}", named.value(first), named.value(last)),
        false => String::new(),
    };
    format!("{name} {change} from {x} {} to {}{values}", first.x, last.x)
}

/// How the column of the x is called.
pub(super) fn x_name(named: &Named<'_>) -> String {
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
        // Shares are compared by their difference: of rare codes, chance decides the quotient.
        let shares = named.figure.kind == Kind::Shares;
        let apart = if shares { mine.y - theirs.y } else { (mine.y / theirs.y).ln() }.abs();
        apart.is_finite().then_some((apart, mine, theirs))
    });
    let (_, mine, theirs) = twins.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let x = named.figure.x.list().join(", ").replace('_', " ");
    let (there, here) = (short_figure(theirs.y), named.value(mine));
    let whose = format!("{} at {x} {}", named.figure.label(&mine.series), mine.x);
    if there == short_figure(mine.y) {
        let what = if named.figure.kind == Kind::Shares { "shares" } else { "figures" };
        return Some(format!(
            "The published {what} are ours: the furthest, that of {whose}, is {there} there and {here} \
             here."
        ));
    }
    Some(format!(
        "The published figure that is furthest from ours is that of {whose}: {there} there, {here} here."
    ))
}

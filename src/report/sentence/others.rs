//! Shares of calls, operation counts, and errors against times.

use super::lines::furthest;
use super::named::Named;
use crate::chart::{Count, Dot, Point, on_steps, short_figure};
use crate::report::words::{capital, count, first_of, with_interval};

/// Return codes: where most and fewest calls end, and which end costs most.
pub(super) fn shares(
    named: &Named<'_>,
    ours: &[Point],
    published: &[Point],
    below: &[Point],
) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    let mut series: Vec<&String> = ours.iter().map(|point| &point.series).collect();
    series.dedup();
    for name in series {
        let label = named.figure.label(name);
        let mine = |points: &[Point]| -> Vec<Point> {
            points.iter().filter(|point| point.series == *name).cloned().collect()
        };
        let code = |point: &Point| format!("code {}", point.x);
        if let Some((least, most)) = ends(&mine(ours)) {
            parts.push(format!(
                "{label}: most calls end with {} ({}), fewest with {} ({}).",
                code(&most),
                named.value(&most),
                code(&least),
                named.value(&least)
            ));
        }
        if let Some((least, most)) = ends(&mine(below)) {
            let value = |point: &Point| with_interval(point.y, point.interval);
            parts.push(format!(
                "The dearest end is {} ({}), the cheapest {} ({}).",
                code(&most),
                value(&most),
                code(&least),
                value(&least)
            ));
        }
    }
    parts.extend(furthest(named, ours, published));
    parts
}

/// The least and the largest of several.
fn ends(points: &[Point]) -> Option<(Point, Point)> {
    let least = points.iter().min_by(|a, b| a.y.total_cmp(&b.y))?;
    let most = points.iter().max_by(|a, b| a.y.total_cmp(&b.y))?;
    (points.len() > 1).then(|| (least.clone(), most.clone()))
}

/// Operation counts: whether they are the published ones.
pub(super) fn counts(named: &Named<'_>, counts: &[Count]) -> String {
    let compared: Vec<&Count> = counts.iter().filter(|count| count.published.is_some()).collect();
    let same = |count: &&&Count| count.ours.map(|ours| ours as f64) == count.published;
    let agree = compared.iter().filter(same).count();
    let differ = compared.iter().filter(|count| !same(count));
    let differ: Vec<String> = differ
        .map(|count| {
            let ours = count.ours.map_or("none".to_owned(), |ours| ours.to_string());
            let theirs = count.published.map_or(String::new(), |theirs| theirs.to_string());
            let series = named.figure.label(&count.series);
            format!("{series} has {ours} {} instead of {theirs}", count.operation)
        })
        .collect();
    match (compared.len(), differ.as_slice()) {
        (0, _) => sums(named, counts),
        (all, []) => format!("All {all} counts are the published ones."),
        (all, differ) => {
            format!("{agree} of {all} counts are the published ones; {}.", first_of(differ, 4))
        }
    }
}

/// Who needs the fewest and the most operations.
fn sums(named: &Named<'_>, counts: &[Count]) -> String {
    let mut sums: Vec<(u64, String)> = Vec::new();
    for count in counts {
        let (ours, name) = (count.ours.unwrap_or(0), named.figure.label(&count.series));
        match sums.iter_mut().find(|(_, other)| *other == name) {
            Some((sum, _)) => *sum += ours,
            None => sums.push((ours, name)),
        }
    }
    sums.sort();
    match (sums.first(), sums.last()) {
        (Some(least), Some(most)) if sums.len() > 1 => format!(
            "{} needs the fewest operations, {}, and {} the most, {}.",
            least.1, least.0, most.1, most.0
        ),
        _ => "There is nothing to compare.".to_owned(),
    }
}

/// Panels and precisions, in their order.
fn keys(dots: &[Dot]) -> Vec<(&String, &String)> {
    let mut keys: Vec<(&String, &String)> = Vec::new();
    for dot in dots {
        if !keys.contains(&(&dot.panel, &dot.precision)) {
            keys.push((&dot.panel, &dot.precision));
        }
    }
    keys
}

/// Errors against times: what is on the steps, from the fastest to the most exact.
pub(super) fn dots(named: &Named<'_>, dots: &[Dot]) -> Vec<String> {
    let keys = keys(dots);
    let several = keys.iter().any(|(panel, _)| *panel != keys[0].0);
    let mut before: Option<&String> = None;
    let mut parts: Vec<String> = Vec::new();
    for (panel, precision) in keys {
        let mine = |dot: &&Dot| dot.panel == *panel && dot.precision == *precision;
        let all: Vec<&Dot> = dots.iter().filter(mine).collect();
        let steps = on_steps(&all);
        let step = |dot: &&Dot| {
            let (time, error) = (named.quantity(dot.time, None), short_figure(dot.error));
            format!("{} ({time}, error {error})", named.figure.label(&dot.name))
        };
        let names: Vec<String> = steps.iter().map(step).collect();
        let words = match names.as_slice() {
            [] => continue,
            [only] => format!("{only} is both the fastest and the most exact"),
            [first, rest @ ..] => {
                format!(
                    "from the fastest to the most exact, take {first}, then {}",
                    rest.join(", then ")
                )
            }
        };
        let heading =
            if before == Some(panel) { String::new() } else { named.panel(panel, several) };
        before = Some(panel);
        let others = all.len() - steps.len();
        parts.push(format!(
            "{heading}{}: {words}; {} off these steps.",
            capital(&named.figure.label(precision)),
            count(others, "form is", "forms are")
        ));
    }
    parts
}

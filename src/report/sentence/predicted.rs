//! Times held against predicted ones: by how much they differ, since neither side competes.

use super::bars::panels;
use super::named::Named;
use crate::chart::{Point, short_figure};

const PREDICTED: &str = "predicted";
const MEASURED: &str = "measured";

/// What lines show of which one predicts another, or which are what a prediction leaves; none of
/// other lines.
pub(super) fn sentences(named: &Named<'_>, ours: &[Point]) -> Option<Vec<String>> {
    // Differences are drawn around 0.
    if named.figure.reference == Some(0.0) {
        return Some(vec![differences(named, ours)]);
    }
    let is_pair = |name: &str| ours.iter().any(|point| point.series == name);
    if !(is_pair(PREDICTED) && is_pair(MEASURED)) {
        return None;
    }
    let panels = panels(&ours.iter().collect::<Vec<_>>());
    let of_panel = |panel: &String| {
        let points: Vec<&Point> = ours.iter().filter(|point| point.panel == *panel).collect();
        format!("{}{}.", named.panel(panel, panels.len() > 1), quotients(named, &points))
    };
    Some(panels.iter().map(of_panel).collect())
}

/// A value with the x that it stands at.
type At<'a> = (f64, &'a str);

/// The least and the most.
fn ends<'a>(values: impl Iterator<Item = At<'a>>) -> Option<(At<'a>, At<'a>)> {
    values.fold(None, |ends, value| {
        let (least, most) = ends.unwrap_or((value, value));
        let least = if value.0 < least.0 { value } else { least };
        let most = if value.0 > most.0 { value } else { most };
        Some((least, most))
    })
}

/// `measured is 0.990 (at density 0.1) to 1.21 times (at 0) predicted`, for each that was predicted.
fn quotients(named: &Named<'_>, points: &[&Point]) -> String {
    let x = super::lines::x_name(named);
    let mut told: Vec<String> = Vec::new();
    let mut done: Vec<&str> = Vec::new();
    for point in points {
        let Some(rest) = point.series.strip_prefix(PREDICTED) else { continue };
        if done.contains(&point.series.as_str()) {
            continue;
        }
        done.push(&point.series);
        let measured = format!("{MEASURED}{rest}");
        let quotient = |predicted: &&'_ Point| {
            let twin =
                points.iter().find(|other| other.series == measured && other.x == predicted.x)?;
            let quotient = twin.y / predicted.y;
            quotient.is_finite().then_some(quotient)
        };
        let of_series = points.iter().filter(|other| other.series == point.series);
        let quotients = of_series.filter_map(|one| Some((quotient(one)?, one.x.as_str())));
        if let Some(((least, from), (most, to))) = ends(quotients) {
            let (name, predicted) =
                (named.figure.label(&measured), named.figure.label(&point.series));
            let (least, most) = (short_figure(least), short_figure(most));
            told.push(format!(
                "{name} is {least} times {predicted} at {x} {from} and {most} times at {to}, \
                 everywhere else between these"
            ));
        }
    }
    told.join("; ")
}

/// `fixed lies from -3.30 cycles (at density 0) to -0.00328 cycles (at 1)`, for each series.
fn differences(named: &Named<'_>, points: &[Point]) -> String {
    let mut series: Vec<&str> = Vec::new();
    for point in points {
        if !series.contains(&point.series.as_str()) {
            series.push(&point.series);
        }
    }
    let x = super::lines::x_name(named);
    let range = |name: &&str| {
        let own = points.iter().filter(|point| point.series == *name && point.y.is_finite());
        let ((least, from), (most, to)) = ends(own.map(|point| (point.y, point.x.as_str())))?;
        let (least, most) = (named.quantity(least, None), named.quantity(most, None));
        let name = named.figure.label(name);
        Some(format!("{name} lies from {least} (at {x} {from}) to {most} (at {to})"))
    };
    let told: Vec<String> = series.iter().filter_map(range).collect();
    if told.is_empty() { String::new() } else { format!("{}.", told.join("; ")) }
}

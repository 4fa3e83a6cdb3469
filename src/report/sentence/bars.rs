//! Bars: the best, the next and the worst of each panel.

use super::named::{Named, Telling, apart};
use crate::chart::short_figure;
use crate::chart::{Figure, Point};
use crate::report::sense::Better;

/// Panels told one by one; more are told by their best alone.
const PANELS: usize = 3;

/// What bars show.
pub(super) fn sentences(named: &Named<'_>, ours: &[Point], published: &[Point]) -> Vec<String> {
    let columns = !named.figure.also.is_empty();
    let main: Vec<&Point> =
        ours.iter().filter(|point| !columns || point.series == named.figure.y).collect();
    let panels = panels(&main);
    let several = panels.len() > 1;
    let mut parts: Vec<String> = Vec::new();
    for panel in &panels {
        let points: Vec<&Point> =
            main.iter().copied().filter(|point| point.panel == *panel).collect();
        let words = ranking(named, &points, panels.len() <= PANELS);
        parts.push(format!("{}{words}.", named.panel(panel, several)));
    }
    if columns {
        parts.extend(beside(named.figure, ours));
    }
    parts.extend(super::lines::furthest(named, ours, published));
    parts
}

/// The panels, in their order.
pub(super) fn panels(points: &[&Point]) -> Vec<String> {
    let mut panels: Vec<String> = Vec::new();
    for point in points {
        if !panels.contains(&point.panel) {
            panels.push(point.panel.clone());
        }
    }
    panels
}

/// Best, next and worst.
fn ranking(named: &Named<'_>, points: &[&Point], whole: bool) -> String {
    let sense = named.sense();
    let telling = Telling::among(points);
    let mut order = points.to_vec();
    order.sort_by(|a, b| sense.order(a.y, b.y));
    let name = |point: &Point| named.name(point, telling);
    let tied = order.iter().take_while(|point| point.y == order[0].y).count().max(1);
    order.drain(1..tied.min(order.len()));
    let [best, rest @ ..] = order.as_slice() else { return "nothing was measured".to_owned() };
    let mut words = match rest {
        [] => format!("{}: {}", name(best), named.value(best)),
        _ => format!("{}{} {} ({})", name(best), ties(points, best), sense.best, named.value(best)),
    };
    if let (true, [next, ..]) = (whole, rest) {
        let behind = sense.behind(best.y, next.y);
        let behind = if behind.is_empty() { named.value(next) } else { behind };
        let verb = if sense.better == Better::Neither { "is next" } else { "comes next" };
        words += &format!("; {} {verb}, {behind}{}", name(next), apart(best, next));
    }
    if let [_, .., worst] = rest {
        let behind = sense.behind(best.y, worst.y);
        let behind = if behind.is_empty() { named.value(worst) } else { behind };
        words += &format!("; {} {}, {behind}", name(worst), sense.worst);
    }
    words
}

/// Said behind the name of the best where others have just the same value.
fn ties(points: &[&Point], best: &Point) -> String {
    match points.iter().filter(|point| point.y == best.y).count() {
        0 | 1 => String::new(),
        2 => ", like one other,".to_owned(),
        several => format!(", like {} others,", several - 1),
    }
}

/// Where columns stand beside each other: in which category they are nearest and furthest apart.
fn beside(figure: &Figure, ours: &[Point]) -> Vec<String> {
    let of = |other: &String| {
        let ratio = |point: &Point| {
            let same = |twin: &&Point| {
                twin.series == *other && twin.x == point.x && twin.panel == point.panel
            };
            let twin = ours.iter().find(same)?;
            let ratio = point.y / twin.y;
            ratio.is_finite().then(|| (ratio, figure.label(&point.x)))
        };
        let mut ratios: Vec<(f64, String)> =
            ours.iter().filter(|point| point.series == figure.y).filter_map(ratio).collect();
        ratios.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let ((low, least), (high, most)) = (ratios.first()?, ratios.last()?);
        let (one, two) = (figure.label(&figure.y), figure.label(other));
        Some(format!(
            "\u{201c}{one}\u{201d} over \u{201c}{two}\u{201d} goes from {} ({least}) to {} ({most}).",
            short_figure(*low),
            short_figure(*high)
        ))
    };
    figure.also.iter().filter_map(of).collect()
}

//! Claim B-4.5m: whether the shares and times of the return codes give the time over the density.

use super::derived::{about, chapter};
use super::{Chapter, Results};
use crate::chart::{Measure, Published};
use crate::table::Row;
use std::collections::BTreeSet;

const WORDS: &str = include_str!("../../configs/derived/b-4.5m.toml");

/// Where the times by code are, and where those over the density.
const CODES: &str = "b-4.5";
const DENSITIES: &str = "b-4.2";
/// The kernel as we call it, and as the thesis does.
const KERNEL: &str = "moller1";
const KERNEL_2007: &str = "moller";

/// A figure with its interval: median, lower and upper end.
type Figure = [f64; 3];

/// The chapter `b-4.5m`: for every order and density of b-4.2 the cycles of a test as measured, as
/// predicted from b-4.5, and what is left (column `form`: `measured`, `predicted`, `residual`), with
/// intervals that hold all that the intervals of their parts leave possible. `ratio_to_reference` is
/// the time over that of the same form and order at density 0. The thesis's own figures stand
/// beside as `measured-2007` and `predicted-2007`, without cycles. `None` where either experiment
/// lacks the rows.
pub fn mixture(results: &Results) -> Option<Chapter> {
    let (codes, densities) = (results.chapter(CODES)?, results.chapter(DENSITIES)?);
    let machines: BTreeSet<&str> = densities.rows.iter().map(|row| row.machine.as_str()).collect();
    let mut rows = Vec::new();
    for machine in machines {
        let of = |chapter: &'_ Chapter| -> Vec<Row> {
            let own = |row: &&Row| row.kernel == KERNEL && row.machine == machine;
            chapter.rows.iter().filter(own).cloned().collect()
        };
        rows.extend(of_machine(&of(codes), &of(densities)));
    }
    if rows.is_empty() {
        return None;
    }
    rows.extend(of_2007(&Published::embedded().ok()?));
    chapter(about(WORDS).ok()?, rows, &[codes, densities])
}

/// The rows of one machine.
fn of_machine(codes: &[Row], densities: &[Row]) -> Vec<Row> {
    let mut orders: Vec<&str> = Vec::new();
    for row in densities {
        if !orders.contains(&row.order.as_str()) {
            orders.push(&row.order);
        }
    }
    let mut rows = Vec::new();
    for order in orders {
        let Some(exits) = Exits::of(codes, exits_of(order)) else { continue };
        let own = densities.iter().filter(|row| row.order == order);
        let points: Vec<(&Row, f64, Figure)> =
            own.filter_map(|row| Some((row, row.density?, cycles(row)?))).collect();
        let measured = points.iter().map(|(row, density, cycles)| (*row, *density, *cycles));
        rows.extend(series("measured", &measured.collect::<Vec<_>>()));
        let predicted =
            points.iter().map(|(row, density, _)| (*row, *density, exits.mixed(*density)));
        let predicted = series("predicted", &predicted.collect::<Vec<_>>());
        rows.extend(predicted.into_iter().map(|row| Row { crowded_share: exits.crowded, ..row }));
        rows.extend(points.iter().map(|(row, density, [median, low, high])| {
            let [mixed, mixed_low, mixed_high] = exits.mixed(*density);
            let left = [median - mixed, low - mixed_high, high - mixed_low];
            let crowded_share = worst([row.crowded_share, exits.crowded]);
            Row { crowded_share, ..with_cycles(point(row, "residual", *density), left) }
        }));
    }
    rows
}

/// The order whose times by code an order is predicted from: pairs of one code cannot be shuffled
/// into anything else.
fn exits_of(order: &str) -> &str {
    if order == "reshuffled" { "fixed" } else { order }
}

/// Times of the two ways in which a call can end.
struct Exits {
    hit: Figure,
    /// Mean over the exits, by their shares.
    miss: Figure,
    /// The most of any of them.
    crowded: Option<f64>,
}

impl Exits {
    /// By the rows of an order; `None` if there is no hit or no miss among them.
    fn of(codes: &[Row], order: &str) -> Option<Self> {
        let own = || codes.iter().filter(|row| row.order == order);
        let parts: Vec<(u64, f64, Figure)> =
            own().filter_map(|row| Some((row.code?, row.share?, cycles(row)?))).collect();
        let crowded = worst(own().map(|row| row.crowded_share));
        Exits::mean(&parts).map(|exits| Exits { crowded, ..exits })
    }

    /// By code, share and time.
    fn mean(parts: &[(u64, f64, Figure)]) -> Option<Self> {
        let hit = parts.iter().find(|(code, ..)| *code == 0).map(|(.., time)| *time)?;
        let misses = || parts.iter().filter(|(code, ..)| *code != 0);
        let shares: f64 = misses().map(|(_, share, _)| share).sum();
        let sum = |end: usize| misses().map(|(_, share, time)| share * time[end]).sum::<f64>();
        let miss = [0, 1, 2].map(|end| sum(end) / shares);
        (shares > 0.0).then_some(Exits { hit, miss, crowded: None })
    }

    /// The time where that share of the pairs hits.
    fn mixed(&self, density: f64) -> Figure {
        [0, 1, 2].map(|end| density * self.hit[end] + (1.0 - density) * self.miss[end])
    }
}

fn cycles(row: &Row) -> Option<Figure> {
    let median = row.cycles_per_test?;
    Some([median, row.cycles_low.unwrap_or(median), row.cycles_high.unwrap_or(median)])
}

/// What is made of times beside a neighbour is no better than the worst of them.
fn worst(crowded_shares: impl IntoIterator<Item = Option<f64>>) -> Option<f64> {
    crowded_shares.into_iter().flatten().reduce(f64::max)
}

/// A row of this chapter, about the same as one of b-4.2.
fn point(row: &Row, form: &str, density: f64) -> Row {
    let mut point = row.without_clock();
    point.experiment = "b-4.5m".into();
    point.form = form.into();
    point.status = "ok".into();
    point.density = Some(density);
    point.crowded_share = row.crowded_share;
    point
}

fn with_cycles(row: Row, [median, low, high]: Figure) -> Row {
    let cycles = (Some(median), Some(low), Some(high));
    Row { cycles_per_test: cycles.0, cycles_low: cycles.1, cycles_high: cycles.2, ..row }
}

/// Rows over the density, with the time over that at density 0.
fn series(form: &str, points: &[(&Row, f64, Figure)]) -> Vec<Row> {
    let first = points.iter().find(|(_, density, _)| *density == 0.0);
    let at_zero = first.map(|(.., time)| *time);
    let crowded_at_zero = first.and_then(|(row, ..)| row.crowded_share);
    let row = |(row, density, time): &(&Row, f64, Figure)| {
        let crowded_share = worst([row.crowded_share, crowded_at_zero]);
        let row = Row { crowded_share, ..with_cycles(point(row, form, *density), *time) };
        with_ratio(row, *time, at_zero)
    };
    points.iter().map(row).collect()
}

fn with_ratio(row: Row, [median, low, high]: Figure, at_zero: Option<Figure>) -> Row {
    let Some([zero, zero_low, zero_high]) = at_zero else { return row };
    // The time itself over itself is exactly 1.
    let (low, high) =
        if row.density == Some(0.0) { (1.0, 1.0) } else { (low / zero_high, high / zero_low) };
    Row {
        ratio_to_reference: Some(median / zero),
        ratio_low: Some(low),
        ratio_high: Some(high),
        ..row
    }
}

/// The thesis's table 4.2, and what its table 4.5 predicts of it: times over that at density 0.
fn of_2007(published: &Published) -> Vec<Row> {
    let points = |table: &str, measure| {
        let mut points = published.points(table, measure);
        points.retain(|point| point.series == KERNEL_2007);
        points
    };
    let number = |x: &str| x.parse::<f64>().ok();
    let shares = points("table_4_5", Measure::Share);
    let share = |code: &str| shares.iter().find(|point| point.x == code).map(|point| point.y);
    let exits = points("table_4_5", Measure::Seconds);
    let exits: Vec<(u64, f64, Figure)> = exits
        .iter()
        .filter_map(|point| Some((point.x.parse().ok()?, share(&point.x)?, [point.y; 3])))
        .collect();
    let measured = points("table_4_2", Measure::Seconds);
    let measured: Vec<(f64, Figure)> =
        measured.iter().filter_map(|point| Some((number(&point.x)?, [point.y; 3]))).collect();
    let predicted = Exits::mean(&exits).map_or_else(Vec::new, |exits| {
        measured.iter().map(|(density, _)| (*density, exits.mixed(*density))).collect()
    });
    let blank = Row {
        kernel: KERNEL.into(),
        order: "literal".into(),
        workload: "pairs-line".into(),
        ..Row::default()
    };
    let rows = |form: &str, points: &[(f64, Figure)]| -> Vec<Row> {
        let at_zero = points.iter().find(|(density, _)| *density == 0.0).map(|(_, time)| *time);
        let row = |(density, time): &(f64, Figure)| {
            let row = with_ratio(point(&blank, form, *density), *time, at_zero);
            // A printed figure has no interval.
            Row { ratio_low: None, ratio_high: None, ..row }
        };
        points.iter().map(row).collect()
    };
    let mut all = rows("measured-2007", &measured);
    all.extend(rows("predicted-2007", &predicted));
    all
}

#[cfg(test)]
#[path = "mixture_tests.rs"]
mod tests;

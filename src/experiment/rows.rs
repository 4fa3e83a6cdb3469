//! Rows from what was measured and judged.

use super::scene::Scene;
use crate::job::{Block, Job, Tally};
use crate::measure::{Figures, GroupReport, Invalid, Order, Status};
use crate::registry::Variant;
use crate::rows::of_variant;
use crate::stats::Verdict;
use crate::table::Row;
use crate::workload::hash::Fnv;

/// The columns that a variant, a scene and an order have before anything is measured.
pub fn blank(experiment: &str, variant: &Variant, scene: &Scene, order: Order) -> Row {
    let (axes, facts) = (&variant.axes, &scene.facts);
    Row {
        experiment: experiment.into(),
        workload: facts.workload.clone(),
        order: order.word().into(),
        density: facts.density,
        spread: facts.spread,
        triangles: Some(scene.triangles.len() as u64),
        rays: Some(scene.rays.len() as u64),
        tests: Some(scene.tests()),
        query: facts.query.into(),
        winding: facts.winding.into(),
        generator: facts.generator.into(),
        workload_hash: format!("{:016x}", facts.hash),
        seed: Some(facts.seed),
        priced: axes.priced.into(),
        ..of_variant(variant)
    }
}

/// Hash of what one pass over a job finds: equal bits, equal hash.
pub fn outputs_hash(job: &mut dyn Job) -> String {
    tally_hash(&job.run(Block::whole(job)))
}

/// Hash of what was found.
pub fn tally_hash(tally: &Tally) -> String {
    let mut hash = Fnv::default();
    for sum in std::iter::once(tally.hits).chain(tally.bits) {
        hash.bytes(&sum.to_le_bytes());
    }
    format!("{:016x}", hash.finish())
}

/// Puts in what was measured of a contestant in a group; `ok` is the status of figures that stand.
pub fn put_group(row: &mut Row, figures: &Figures, report: &GroupReport, ok: &str) {
    row.rounds = Some(figures.rounds as u64);
    row.dirty_rounds = Some(figures.dirty_rounds as u64);
    match &figures.status {
        Status::Ok => row.status = ok.into(),
        Status::Invalid(reason) => {
            let missing = matches!(reason, Invalid::NoRound | Invalid::Interrupted { .. });
            row.status = if missing { "not-measured" } else { "invalid" }.into();
            row.verdict = if missing { "" } else { "invalid" }.into();
            row.reason = reason.to_string();
            return;
        }
    }
    put_times(row, figures);
    put_ratios(row, figures);
    // Without copies of the reference nobody knows what a difference is.
    if report.placebo_floor.is_some() {
        put_verdict(row, figures);
        row.noise_floor = figures.ratio_to_reference.map(|_| report.noise_floor);
    }
    row.ratio_placebo = report.placebo_floor.map(f64::exp);
    row.empty_loop_share = figures.empty_loop_ratio;
    row.crowded_share = Some(report.crowded_share);
}

fn put_times(row: &mut Row, figures: &Figures) {
    row.ns_per_test = figures.ns_per_test;
    row.ns_low = figures.ns_low;
    row.ns_high = figures.ns_high;
    row.min_ns = figures.min_ns;
    row.mtests_per_s = figures.ns_per_test.map(|ns| 1e3 / ns);
    row.cycles_per_test = figures.cycles_per_test;
    row.cycles_low = figures.cycles_interval.map(|interval| interval.low);
    row.cycles_high = figures.cycles_interval.map(|interval| interval.high);
    row.cycles_first_half = figures.cycles_first_half;
    row.cycles_second_half = figures.cycles_second_half;
    if figures.cycles_per_test.is_some() {
        row.cycles_source = figures.cycles_source.word().into();
    }
    row.instructions_per_test = figures.instructions_per_test;
    row.mispredicts_per_test = figures.mispredicts_per_test;
    row.solo_ratio = figures.solo_ratio;
}

fn put_ratios(row: &mut Row, figures: &Figures) {
    if let Some(ratio) = &figures.ratio_to_reference {
        row.ratio_to_reference = Some(ratio.estimate);
        row.ratio_low = Some(ratio.low);
        row.ratio_high = Some(ratio.high);
    }
    row.ratio_first_half = figures.ratio_first_half.as_ref().map(|ratio| ratio.estimate);
    row.ratio_second_half = figures.ratio_second_half.as_ref().map(|ratio| ratio.estimate);
}

fn put_verdict(row: &mut Row, figures: &Figures) {
    if let Some(decision) = &figures.decision {
        row.verdict = decision.verdict.word().into();
        row.p_value = Some(decision.p_value);
        if let Verdict::Unresolved { more_rounds } = decision.verdict {
            row.more_rounds = more_rounds;
        }
    }
}

/// Says of a row that its turn had not come when the run was interrupted.
pub fn put_interrupted(row: &mut Row) {
    row.status = "not-measured".into();
    row.reason = "interrupted before its turn".into();
}

/// The thesis's column: how much slower the mean of a kernel's row over the densities is than the
/// smallest such mean, within each order, in percent. A row with a density missing has none.
pub fn put_percent_slower(rows: &mut [Row]) {
    let means = means(rows, |row| row.ns_per_test);
    for row in rows.iter_mut() {
        let of_order = means.iter().filter(|((order, ..), _)| *order == row.order);
        let smallest = of_order.map(|(_, mean)| *mean).fold(f64::INFINITY, f64::min);
        row.percent_slower = own(&means, row).map(|mean| (mean / smallest - 1.0) * 100.0);
    }
}

/// The mean of a kernel's seconds over the densities, within each order. A row with a density
/// missing has none.
pub(super) fn put_seconds_mean(rows: &mut [Row]) {
    let means = means(rows, |row| row.seconds);
    for row in rows.iter_mut() {
        row.seconds_mean = own(&means, row);
    }
}

/// Order, id and kernel: what has a row over the densities.
type Line = (String, String, String);

fn line(row: &Row) -> Line {
    (row.order.clone(), row.id.clone(), row.kernel.clone())
}

fn own(means: &[(Line, f64)], row: &Row) -> Option<f64> {
    let own = line(row);
    means.iter().find(|(line, _)| *line == own).map(|(_, mean)| *mean)
}

/// The mean of a figure over the densities of its order, for each line that has it at all of them.
fn means(rows: &[Row], figure: fn(&Row) -> Option<f64>) -> Vec<(Line, f64)> {
    let densities = |order: &str| {
        let mut bits: Vec<u64> = Vec::new();
        for row in rows.iter().filter(|row| row.order == order) {
            let density = row.density.map_or(0, f64::to_bits);
            if !bits.contains(&density) {
                bits.push(density);
            }
        }
        bits.len()
    };
    let mut means: Vec<(Line, f64)> = Vec::new();
    for row in rows.iter().filter(|row| row.price.is_none()) {
        let of = line(row);
        if means.iter().any(|(other, _)| *other == of) {
            continue;
        }
        let same = |other: &&Row| other.price.is_none() && line(other) == of;
        let own: Vec<f64> = rows.iter().filter(same).filter_map(figure).collect();
        if own.len() == densities(&row.order) {
            means.push((of, own.iter().sum::<f64>() / own.len() as f64));
        }
    }
    means
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(order: &str, kernel: &str, density: f64, seconds: Option<f64>) -> Row {
        Row {
            order: order.into(),
            kernel: kernel.into(),
            density: Some(density),
            seconds,
            ns_per_test: seconds.map(|seconds| seconds * 2.0),
            ..Row::default()
        }
    }

    #[test]
    fn means_are_over_all_densities_of_an_order_or_none() {
        let mut rows = vec![
            row("literal", "a", 0.0, Some(1.0)),
            row("literal", "a", 1.0, Some(3.0)),
            row("literal", "b", 0.0, Some(3.0)),
            row("literal", "b", 1.0, Some(3.0)),
            row("literal", "c", 0.0, Some(1.0)),
            row("literal", "c", 1.0, None),
            row("fixed", "a", 0.5, Some(7.0)),
        ];
        put_seconds_mean(&mut rows);
        put_percent_slower(&mut rows);
        let means: Vec<_> = rows.iter().map(|row| row.seconds_mean).collect();
        let (a, b) = (Some(2.0), Some(3.0));
        assert_eq!(means, [a, a, b, b, None, None, Some(7.0)]);
        let slower: Vec<_> = rows.iter().map(|row| row.percent_slower).collect();
        assert_eq!(slower, [Some(0.0), Some(0.0), Some(50.0), Some(50.0), None, None, Some(0.0)]);
    }
}

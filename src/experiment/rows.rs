//! Rows from what was measured and judged.

use super::scene::Scene;
use crate::accuracy::Accuracy;
use crate::job::{Block, Job};
use crate::measure::{BuildInfo, Figures, GroupReport, Invalid, Order, Status};
use crate::registry::{Axes, Variant};
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

/// The columns of a variant alone.
pub fn of_variant(variant: &Variant) -> Row {
    let bytes_per_triangle = Some(variant.bytes_per_triangle as u64);
    Row { bytes_per_triangle, ..of_axes(&variant.axes) }
}

/// The columns of a place on all axes.
pub fn of_axes(axes: &Axes) -> Row {
    Row {
        id: axes.id(),
        kernel: axes.kernel.into(),
        precision: axes.precision.into(),
        drive: axes.drive.clone(),
        level: axes.level.into(),
        exit: axes.exit.into(),
        division: axes.division.into(),
        rounding: axes.rounding.into(),
        output: axes.output.into(),
        layout: axes.layout.into(),
        stored: axes.stored.into(),
        cull: axes.cull.into(),
        tests_form: axes.tests.into(),
        leading: axes.leading.into(),
        edges: axes.edges.into(),
        subnormals: axes.subnormals.into(),
        build: BuildInfo::of_this_program().label(),
        ..Row::default()
    }
}

/// Puts in what the comparison with the exact answers found.
pub fn put_accuracy(row: &mut Row, accuracy: &Accuracy) {
    row.false_hits = Some(accuracy.false_hits);
    row.false_misses = Some(accuracy.false_misses);
    row.deep_false_hits = Some(accuracy.deep_false_hits);
    row.deep_false_misses = Some(accuracy.deep_false_misses);
    row.inexcusable = Some(accuracy.inexcusable);
    row.boundary_cases = Some(accuracy.boundary_cases);
    row.worst_depth = accuracy.worst_depth;
    row.nan_outputs = Some(accuracy.non_finite);
    row.err_cases = Some(accuracy.compared);
    put_errors(row, accuracy);
}

fn put_errors(row: &mut Row, accuracy: &Accuracy) {
    row.err_t_mean_rel = accuracy.t_mean_relative;
    row.err_u_mean_rel = accuracy.u_mean_relative;
    row.err_v_mean_rel = accuracy.v_mean_relative;
    row.err_tuv_mean_rel = accuracy.mean_relative;
    row.err_max_rel = accuracy.max_relative;
    row.t_bits_lost_mean = accuracy.t_bits_lost_mean;
    row.t_bits_lost_max = accuracy.t_bits_lost_max;
    row.uv_bits_lost_mean = accuracy.uv_bits_lost_mean;
    row.uv_bits_lost_max = accuracy.uv_bits_lost_max;
    row.err_t_p50_ulp = accuracy.t_ulp.p50;
    row.err_t_p99_ulp = accuracy.t_ulp.p99;
    row.err_t_p999_ulp = accuracy.t_ulp.p999;
    row.err_t_max_ulp = accuracy.t_ulp.max;
    row.err_u_max_abs = accuracy.u_max;
    row.err_v_max_abs = accuracy.v_max;
    row.err_b_p50 = accuracy.barycentric.p50;
    row.err_b_p99 = accuracy.barycentric.p99;
    row.err_b_p999 = accuracy.barycentric.p999;
    row.err_b_max = accuracy.barycentric.max;
    row.backward_p50_u = accuracy.backward.p50;
    row.backward_p99_u = accuracy.backward.p99;
    row.backward_max_u = accuracy.backward.max;
    row.t_excess_max = accuracy.t_excess_max;
    row.b_excess_max = accuracy.barycentric_excess_max;
}

/// Hash of what one pass over a job finds: equal bits, equal hash.
pub fn outputs_hash(job: &mut dyn Job) -> String {
    let tally = job.run(Block::whole(job));
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
    let densities = |rows: &[Row], order: &str| {
        let mut bits: Vec<u64> = Vec::new();
        for row in rows.iter().filter(|row| row.order == order) {
            let density = row.density.map_or(0, f64::to_bits);
            if !bits.contains(&density) {
                bits.push(density);
            }
        }
        bits.len()
    };
    let key = |row: &Row| (row.order.clone(), row.id.clone(), row.kernel.clone());
    let mut means: Vec<((String, String, String), f64)> = Vec::new();
    for row in rows.iter().filter(|row| row.price.is_none()) {
        if means.iter().any(|(of, _)| *of == key(row)) {
            continue;
        }
        let same = |other: &&Row| other.price.is_none() && key(other) == key(row);
        let own: Vec<f64> =
            rows.iter().filter(same).filter_map(|other| other.ns_per_test).collect();
        if own.len() == densities(rows, &row.order) {
            means.push((key(row), own.iter().sum::<f64>() / own.len() as f64));
        }
    }
    for row in rows.iter_mut() {
        let of_order = means.iter().filter(|((order, ..), _)| *order == row.order);
        let smallest = of_order.clone().map(|(_, mean)| *mean).fold(f64::INFINITY, f64::min);
        let own = of_order.clone().find(|(of, _)| *of == key(row));
        row.percent_slower = own.map(|(_, mean)| (mean / smallest - 1.0) * 100.0);
    }
}

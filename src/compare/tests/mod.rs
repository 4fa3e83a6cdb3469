//! Made-up runs: no registry, no clock.

mod exactness;
mod refusals;
mod sides;
mod time;

use super::*;
use crate::table::{Row, RunFile, SCHEMA_VERSION};
use std::path::PathBuf;

/// The kernel that tests make slower.
pub(super) const SUBJECT: &str = "wald/f32/single/sse2/early/last/plain/t";
/// The kernel that all ratios refer to.
const REFERENCE: &str = "moller1/f32/single/sse2/early/last/plain/t";

/// A row as measured: `ratio` times the reference's 20 cycles, with a narrow interval.
fn row(id: &str, order: &str, ratio: f64) -> Row {
    let reference = ratio == 1.0;
    let wide = |factor: f64| if reference { 1.0 } else { ratio * factor };
    let cycles = 20.0 * ratio;
    Row {
        experiment: "b-4.2".into(),
        id: id.into(),
        kernel: id.split('/').next().unwrap_or("").into(),
        level: "sse2".into(),
        workload: "pairs-line".into(),
        order: order.into(),
        density: Some(0.5),
        generator: "pcg".into(),
        seed: Some(1),
        status: "ok".into(),
        hits: Some(500),
        false_hits: Some(0),
        false_misses: Some(2),
        nan_outputs: Some(0),
        err_t_mean_rel: Some(1e-7),
        err_t_p999_ulp: Some(3.0),
        err_t_max_ulp: Some(9.0),
        err_u_max_abs: Some(1e-6),
        err_v_max_abs: Some(1e-6),
        outputs_hash: "feed".into(),
        workload_hash: "f00d".into(),
        ns_per_test: Some(cycles / 4.0),
        cycles_per_test: Some(cycles),
        cycles_low: Some(cycles * 0.998),
        cycles_high: Some(cycles * 1.003),
        cycles_first_half: Some(cycles * 0.999),
        cycles_second_half: Some(cycles * 1.001),
        ratio_to_reference: Some(ratio),
        ratio_low: Some(wide(0.998)),
        ratio_high: Some(wide(1.003)),
        ratio_first_half: Some(wide(0.999)),
        ratio_second_half: Some(wide(1.001)),
        ratio_placebo: Some(1.004),
        ..Row::default()
    }
}

fn rows() -> Vec<Row> {
    let kernels =
        [(REFERENCE, 1.0), (SUBJECT, 0.8), ("plucker/f32/single/sse2/full/last/plain/t", 1.7)];
    let of = |order: &'static str| kernels.map(|(id, ratio)| row(id, order, ratio));
    ["fixed", "reshuffled"].into_iter().flat_map(of).collect()
}

/// A run of these rows.
pub(super) fn side(rows: Vec<Row>) -> Side {
    let run = RunFile {
        schema_version: SCHEMA_VERSION.into(),
        environment: serde_json::json!({
            "testbed_id": "here", "date": "today", "complete": true,
            "machine": { "processor": "Processor", "cpu_mhz": 3000 },
            "build": { "commit": "0123456789abcdef", "debug_assertions": false },
        }),
        seed: 1,
        workload_hash: "beef".into(),
        rows,
    };
    Side { sources: vec![Source { path: PathBuf::from("rows.json"), run }] }
}

/// The usual run.
pub(super) fn base() -> Side {
    side(rows())
}

/// The usual run with every row changed.
pub(super) fn with(change: impl FnMut(&mut Row)) -> Side {
    let mut rows = rows();
    rows.iter_mut().for_each(change);
    side(rows)
}

/// Makes the time of a row `factor` times as long, in all figures of it.
pub(super) fn slow(row: &mut Row, factor: f64) {
    scale_ratio(row, factor);
    scale_cycles(row, factor);
}

fn scale(figures: &mut [&mut Option<f64>], factor: f64) {
    for figure in figures {
        **figure = figure.map(|value| value * factor);
    }
}

fn scale_ratio(row: &mut Row, factor: f64) {
    let halves = [&mut row.ratio_first_half, &mut row.ratio_second_half];
    let [first, second] = halves;
    let figures = [&mut row.ratio_to_reference, &mut row.ratio_low, &mut row.ratio_high];
    let [ratio, low, high] = figures;
    scale(&mut [ratio, low, high, first, second], factor);
}

fn scale_cycles(row: &mut Row, factor: f64) {
    scale(
        &mut [
            &mut row.ns_per_test,
            &mut row.cycles_per_test,
            &mut row.cycles_low,
            &mut row.cycles_high,
            &mut row.cycles_first_half,
            &mut row.cycles_second_half,
        ],
        factor,
    );
}

/// Compares at 3 %.
pub(super) fn at_3_percent(base: &Side, new: &Side) -> Comparison {
    compare(base, new, "3%".parse().unwrap())
}

fn figures(findings: &[Finding]) -> Vec<(&str, &str)> {
    findings.iter().map(|found| (found.place.id.as_str(), found.change.figure)).collect()
}

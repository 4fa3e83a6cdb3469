//! The columns that say what was asked, and how exact its answers were: the same for what is timed
//! and for what is swept without a clock.

use crate::accuracy::Accuracy;
use crate::measure::BuildInfo;
use crate::registry::{Axes, Variant};
use crate::table::Row;

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
        reciprocal: axes.reciprocal.into(),
        leading: axes.leading.into(),
        edges: axes.edges.into(),
        projection: axes.projection.into(),
        subnormals: axes.subnormals.into(),
        cross: axes.cross.into(),
        dot: axes.dot.into(),
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

//! What got less exact. No clock is in these figures: equal programs give equal ones, so every
//! change is real and needs no threshold.

use super::finding::{Change, Judged};
use crate::table::Row;

/// Columns that should be small. Those that are made of others here (`err_tuv_mean_rel`) would only
/// say a change twice.
pub(super) const ERRORS: [&str; 38] = [
    "false_hits",
    "false_misses",
    "deep_false_hits",
    "deep_false_misses",
    "inexcusable",
    "worst_depth",
    "nan_outputs",
    "err_t_mean_rel",
    "err_u_mean_rel",
    "err_v_mean_rel",
    "err_max_rel",
    "t_bits_lost_mean",
    "t_bits_lost_max",
    "uv_bits_lost_mean",
    "uv_bits_lost_max",
    "err_t_p50_ulp",
    "err_t_p99_ulp",
    "err_t_p999_ulp",
    "err_t_max_ulp",
    "err_b_p50",
    "err_b_p99",
    "err_b_p999",
    "err_b_max",
    "err_u_max_abs",
    "err_v_max_abs",
    "backward_p50_u",
    "backward_p99_u",
    "backward_max_u",
    "t_excess_max",
    "b_excess_max",
    "err_t_p50_rel",
    "err_t_p99_rel",
    "hits_of_not_finite",
    "leaks",
    "double_hits",
    "spawned_hits",
    "metamorphic_decisions",
    "metamorphic_uv",
];

/// The changes of a cell.
pub(super) fn judge(base: &Row, new: &Row) -> Vec<Judged> {
    let errors = ERRORS.into_iter().filter_map(|column| error(column, base, new));
    let mut found: Vec<Judged> = status(base, new).into_iter().chain(errors).collect();
    // Whoever errs less has other hits and other bits; whoever has others for no such gain has
    // changed the answers.
    let gained =
        !found.is_empty() && found.iter().all(|judged| matches!(judged, Judged::Better(_)));
    if !gained {
        found.extend(hits(base, new));
        found.extend(outputs(base, new));
    }
    found
}

/// How far a status is from a checked answer; `None` where nothing was checked, as on a machine
/// without the level, in a run that was interrupted, or where a guard did not believe the clock.
fn rank(status: &str) -> Option<u8> {
    match status {
        "ok" => Some(0),
        "inexact" => Some(1),
        "wrong-result" => Some(2),
        _ => None,
    }
}

fn status(base: &Row, new: &Row) -> Option<Judged> {
    let change = Change::of("status", base, new);
    match (rank(&base.status)?, rank(&new.status)?) {
        (old, new) if new > old => Some(Judged::Worse(change)),
        (old, new) if new < old => Some(Judged::Better(change)),
        _ => None,
    }
}

/// The change of a column of numbers; `None` where it is missing on a side, or equal.
fn changed(column: &'static str, base: &Row, new: &Row) -> Option<(Change, f64, f64)> {
    let number = |row: &Row| row.cell(column).and_then(|cell| cell.number());
    let (old, now) = (number(base)?, number(new)?);
    let ratio = (old > 0.0 && now > 0.0).then(|| now / old);
    (old != now).then(|| (Change { ratio, ..Change::of(column, base, new) }, old, now))
}

fn error(column: &'static str, base: &Row, new: &Row) -> Option<Judged> {
    let (change, old, now) = changed(column, base, new)?;
    Some(if now > old { Judged::Worse(change) } else { Judged::Better(change) })
}

fn hits(base: &Row, new: &Row) -> Option<Judged> {
    changed("hits", base, new).map(|(change, ..)| Judged::Worse(change))
}

fn outputs(base: &Row, new: &Row) -> Option<Judged> {
    let known = !base.outputs_hash.is_empty() && !new.outputs_hash.is_empty();
    let differs = known && base.outputs_hash != new.outputs_hash;
    differs.then(|| Judged::Worse(Change::of("outputs_hash", base, new)))
}

//! The point and the normal of a hit against the exact ones.

use super::reported::Reported;
use crate::job::Answer;
use crate::oracle::{Exact, Query};
use glam::DVec3;

/// As for the other outputs: what rounding may do, times 64.
const ALLOWANCE: f64 = 64.0;

/// What is wrong with point or normal, beyond what rounding explains.
///
/// The point is o + t d: it may move by the error allowed to t along d, and by three roundings of
/// its own terms. The normal is a cross product of two edges, each rounded: its error is a few
/// roundings of |e1| |e2|, which is much beside |e1 x e2| for a sliver, and none of them turns it
/// to the other side. Its length is the kernel's own affair.
pub fn wrong(
    answer: &Answer,
    query: &Query,
    exact: &Exact,
    t_limit: f64,
    reported: Reported,
) -> Option<String> {
    let u = reported.unit_roundoff;
    let [o, d] = [query.origin, query.direction].map(DVec3::from_array);
    let along = d * exact.t;
    let limit = d.abs() * t_limit + (o.abs() + along.abs()) * (ALLOWANCE * u);
    let off = (DVec3::from_array(answer.point) - (o + along)).abs();
    if !off.cmple(limit).all() {
        return Some(format!("the point is off by {off}, rounding explains {limit}"));
    }
    let [a, b, c] = query.triangle.map(DVec3::from_array);
    let normal = (b - a).cross(c - a);
    let found = DVec3::from_array(answer.normal);
    let sine_limit = ALLOWANCE * u * (b - a).length() * (c - a).length() / normal.length();
    let size = found.length() * normal.length();
    let sine = found.cross(normal).length() / size;
    let same_side = found.dot(normal) > 0.0;
    // Asked this way round, NaN is wrong.
    let right = same_side && sine <= sine_limit;
    (!right).then(|| format!("the normal is turned by {sine:e}, rounding explains {sine_limit:e}"))
}

//! Decisions that are close: near an edge, near an end of the range of t.

use super::super::draw::Draw;
use super::super::family::{Family, Work};
use super::super::precision::power_of_ten;
use super::{digits, exponents};
use crate::oracle::{Query, solve};

pub(super) fn families() -> Vec<Family> {
    vec![
        Family {
            id: "near-edge",
            knob: "weight of the target: 10^-k/3 or -10^-k/3",
            knobs: digits,
            work: Work::Free(near_edge),
            passes: "wrong only within 16 condition numbers of rounding",
        },
        Family {
            id: "t-range",
            knob: "an end of the range off t by 10^-k/2 of it",
            knobs: |precision| exponents(precision, (9, 1), (17, 2)),
            work: Work::Free(t_range),
            passes: "wrong only within 16 condition numbers of rounding",
        },
    ]
}

/// A ray at a point whose smallest weight is 10^-k inside, or outside.
pub(in super::super) fn near_edge(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let triangle = draw.benign();
    let pose = draw.pose(triangle, hit);
    let way = draw.towards(pose.normal);
    // A third of it, so that k = 0 is a point in the middle.
    let small = (power_of_ten(-knob as i32) / 3.0) * if hit { 1.0 } else { -1.0 };
    let other = draw.between(0.1, 0.9) * (1.0 - small);
    let (u, v) = match draw.below(3) {
        0 => (small, other),
        1 => (other, small),
        _ => (other, 1.0 - small - other),
    };
    let point = super::super::draw::weighted(&pose.triangle, u, v);
    let reach = super::super::draw::REACH * pose.distance;
    draw.ray(point - way * pose.distance, way, pose.triangle, (0.0, reach))
}

/// A hit of the triangle whose t is just inside, or just outside, one end of the range.
fn t_range(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let triangle = draw.benign();
    let pose = draw.pose(triangle, true);
    let query = draw.shoot(&pose);
    let t = solve(&query).t;
    // Half of it, so that k = 0 leaves the range an end above 0.
    let gap = 0.5 * power_of_ten(-knob as i32) * t;
    let at_the_end = draw.chance(0.5);
    // Farther along for a hit within t_max and for a miss before t_min.
    let bound = draw.precision.round(if hit == at_the_end { t + gap } else { t - gap });
    match at_the_end {
        // A triangle that collapsed has no t.
        _ if bound.is_nan() => query,
        true => Query { t_max: bound, ..query },
        false => Query { t_min: bound, ..query },
    }
}

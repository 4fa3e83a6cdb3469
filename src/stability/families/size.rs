//! Everything very small or very large.

use super::super::draw::{Draw, REACH};
use super::super::family::{Family, aimed_family as aimed};
use super::super::precision::{Precision, power_of_ten};
use super::exponents;
use crate::oracle::Query;
use glam::DVec3;

const INVARIANT: &str =
    "the answers of k = 0, until something under- or overflows; no hit that is not finite";

pub(super) fn families() -> Vec<Family> {
    vec![
        aimed(
            "tiny",
            "size of triangle and distance: 10^-k",
            |precision| exponents(precision, (22, 2), (105, 15)),
            tiny,
            INVARIANT,
        ),
        aimed("subnormal", "size of triangle and distance: 10^-k", subnormal, tiny, INVARIANT),
        aimed(
            "huge",
            "size of triangle and distance: 10^k",
            |precision| exponents(precision, (20, 2), (105, 15)),
            huge,
            INVARIANT,
        ),
        aimed(
            "short-direction",
            "length of the direction: 10^-k",
            |precision| exponents(precision, (36, 4), (105, 15)),
            short_direction,
            INVARIANT,
        ),
        aimed(
            "long-direction",
            "length of the direction: 10^k",
            |precision| exponents(precision, (36, 4), (105, 15)),
            long_direction,
            INVARIANT,
        ),
        aimed(
            "random-exponents",
            "every coordinate's size between 10^-k and 10^k",
            |_| (0..=8).step_by(2).map(f64::from).collect(),
            random_exponents,
            "reported, no pass line",
        ),
    ]
}

/// Sizes at which the coordinates themselves are subnormal, from the last that are not.
fn subnormal(precision: Precision) -> Vec<f64> {
    let (first, last) = match precision {
        Precision::F32 => (37, 43),
        Precision::F64 => (307, 319),
    };
    let step = if precision == Precision::F32 { 2 } else { 4 };
    (first..=last).step_by(step).map(f64::from).collect()
}

fn sized(draw: &mut Draw, size: f64, hit: bool) -> Query {
    let triangle = draw.benign();
    // The normal of the triangle at its usual size: that of a tiny one underflows.
    let mut pose = draw.pose(triangle, hit);
    pose.triangle = triangle.map(|p| draw.round(p * size));
    pose.distance *= size;
    draw.shoot(&pose)
}

fn tiny(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    sized(draw, power_of_ten(-knob as i32), hit)
}

fn huge(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    sized(draw, power_of_ten(knob as i32), hit)
}

fn with_direction(draw: &mut Draw, length: f64, hit: bool) -> Query {
    let triangle = draw.benign();
    let pose = draw.pose(triangle, hit);
    let way = draw.towards(pose.normal);
    draw.shoot_along(&pose, way, way * length)
}

fn short_direction(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    with_direction(draw, power_of_ten(-knob as i32), hit)
}

fn long_direction(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    with_direction(draw, power_of_ten(knob as i32), hit)
}

/// After `pExp` of pbrt's tests of shapes: every coordinate with a size of its own, evenly between
/// the powers of two next to 10^-k and 10^k; the ray runs from such a point to a target. pbrt
/// draws the exponent as a real number, which needs a power function that differs between systems.
fn random_exponents(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let most = (knob * std::f64::consts::LOG2_10).round() as u64;
    let mut coordinate = || {
        let exponent = draw.whole(most) as i32;
        draw.sign() * draw.between(1.0, 2.0) * super::super::precision::power_of_two(exponent)
    };
    let mut point = || DVec3::new(coordinate(), coordinate(), coordinate());
    let (triangle, origin) = ([point(), point(), point()], point());
    let triangle = triangle.map(|p| draw.round(p));
    let origin = draw.round(origin);
    let (u, v) = draw.target(hit);
    let target = super::super::draw::weighted(&triangle, u, v);
    draw.ray(origin, target - origin, triangle, (0.0, REACH))
}

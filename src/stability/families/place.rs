//! Triangles, or origins, far from where the numbers are dense.

use super::super::draw::Draw;
use super::super::family::{Family, Work};
use super::super::precision::power_of_ten;
use super::{digits, exponents};
use crate::oracle::Query;

/// The equatorial radius of the earth in metres, roughly: where coordinates of maps are.
const EARTH: f64 = 6.4e6;

pub(super) fn families() -> Vec<Family> {
    vec![
        Family {
            id: "far",
            knob: "distance of triangle and origin from 0: 10^k",
            knobs: |precision| exponents(precision, (7, 1), (15, 2)),
            work: Work::Aimed(far),
            passes: "errors at most 16 roundings of differences from a vertex",
        },
        Family {
            id: "gis",
            knob: "triangles of 10^(4-k) m at 6.4e6 m from 0",
            knobs: |precision| exponents(precision, (6, 1), (12, 2)),
            work: Work::Aimed(gis),
            passes: "errors at most 16 condition numbers of rounding",
        },
        Family {
            id: "far-origin",
            knob: "distance of the origin from the triangle: 10^k",
            knobs: digits,
            work: Work::Aimed(far_origin),
            passes: "errors at most 16 condition numbers of rounding",
        },
        Family {
            id: "near-plane",
            knob: "height of the origin over the triangle's plane: 10^-k",
            knobs: digits,
            work: Work::Aimed(near_plane),
            passes: "error of t at most 16 absolute condition numbers of rounding",
        },
    ]
}

/// A benign triangle of that size, moved away from 0.
fn moved(draw: &mut Draw, size: f64, distance: f64, hit: bool) -> Query {
    let offset = draw.direction() * distance;
    let triangle = draw.benign().map(|p| p * size + offset);
    let mut pose = draw.pose(triangle, hit);
    pose.distance *= size;
    draw.shoot(&pose)
}

fn far(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    moved(draw, 1.0, power_of_ten(knob as i32), hit)
}

fn gis(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    moved(draw, power_of_ten(4 - knob as i32), EARTH, hit)
}

fn far_origin(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let triangle = draw.benign();
    let mut pose = draw.pose(triangle, hit);
    pose.distance *= power_of_ten(knob as i32);
    draw.shoot(&pose)
}

/// One ray in five starts behind the plane, which makes it a miss.
fn near_plane(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let triangle = draw.benign();
    let behind = !hit && draw.chance(0.4);
    let pose = draw.pose(triangle, hit || behind);
    let way = draw.towards(pose.normal);
    let height = power_of_ten(-knob as i32) / way.dot(pose.normal).abs();
    let (u, v) = draw.target(pose.inside);
    let point = super::super::draw::weighted(&pose.triangle, u, v);
    let origin = point - way * (if behind { -height } else { height });
    draw.ray(origin, way, pose.triangle, (0.0, super::super::draw::REACH))
}

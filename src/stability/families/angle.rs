//! Rays that run almost in the triangle's plane.

use super::super::draw::{Draw, Pose};
use super::super::family::{Family, Work};
use super::super::precision::power_of_ten;
use super::digits;
use super::shape::grazing;
use crate::oracle::Query;
use glam::DVec3;

const PASSES: &str =
    "errors at most 16 condition numbers of rounding, no decision wrong beyond that";

pub(super) fn families() -> Vec<Family> {
    let knob = "cosine of the angle to the normal: 10^-k";
    vec![
        Family { id: "grazing", knob, knobs: digits, work: Work::Aimed(generic), passes: PASSES },
        Family {
            id: "grazing-axis",
            knob,
            knobs: digits,
            work: Work::Aimed(axis_plane),
            passes: PASSES,
        },
    ]
}

/// Rounding the direction leaves a cosine of about the unit roundoff at the least.
fn generic(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let triangle = draw.benign();
    let pose = draw.pose(triangle, hit);
    let way = grazing(draw, pose.normal, power_of_ten(-knob as i32));
    draw.shoot_along(&pose, way, way)
}

/// A triangle in a plane across an axis: the cosine is a coordinate, and keeps its digits.
fn axis_plane(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let height = draw.between(-1.0, 1.0);
    let turn = draw.below(3) as usize;
    // The plane's axis is the last one, then turned.
    let turned = |p: DVec3| {
        let p = p.to_array();
        DVec3::new(p[turn % 3], p[(turn + 1) % 3], p[(turn + 2) % 3])
    };
    let triangle = loop {
        let corners = draw.benign().map(|p| DVec3::new(p.x, p.y, height));
        let doubled = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length();
        if doubled > 0.5 {
            break corners.map(turned);
        }
    };
    let normal = turned(DVec3::Z);
    let pose = Pose { normal, ..draw.pose(triangle, hit) };
    let way = grazing(draw, normal, power_of_ten(-knob as i32));
    draw.shoot_along(&pose, way, way)
}

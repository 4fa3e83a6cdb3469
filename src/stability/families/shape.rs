//! Triangles of bad shape.

use super::super::draw::{Draw, Pose};
use super::super::family::{Family, aimed_family as aimed};
use super::super::precision::power_of_ten;
use super::{digits, exponents, single};
use crate::oracle::Query;
use glam::DVec3;

const THIN: &str = "u, v as conditioned; t keeps its digits at every aspect";
const CONDITIONED: &str = "errors at most 16 condition numbers of rounding";

pub(super) fn families() -> Vec<Family> {
    let aspect = "aspect: 10^k";
    vec![
        aimed(
            "benign",
            "none",
            single,
            benign,
            "errors at most 16 condition numbers of rounding, no wrong decision",
        ),
        aimed("needle", aspect, digits, needle, THIN),
        aimed("cap", aspect, digits, cap, THIN),
        aimed(
            "sliver",
            aspect,
            |precision| exponents(precision, (7, 1), (15, 2)),
            sliver,
            "as needle; no hit of a triangle that collapsed in rounding",
        ),
        aimed("mixed-scale", "length of one edge: 10^k", digits, mixed_scale, CONDITIONED),
        aimed(
            "compound",
            "aspect, distance from 0 and 1/cos of the angle to the normal: 10^(k/2) each",
            |precision| exponents(precision, (10, 2), (20, 4)),
            compound,
            "no decision wrong beyond 16 condition numbers of rounding",
        ),
    ]
}

fn benign(draw: &mut Draw, _: f64, hit: bool) -> Query {
    let triangle = draw.benign();
    let pose = draw.pose(triangle, hit);
    draw.shoot(&pose)
}

/// A needle with its short edge at 0, where any length is representable; its normal; a frame.
fn thin(draw: &mut Draw, height: f64) -> ([DVec3; 3], DVec3) {
    let [along, across, normal] = draw.frame();
    ([along, across * (0.5 * height), across * (-0.5 * height)], normal)
}

fn needle(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let (triangle, normal) = thin(draw, power_of_ten(-knob as i32));
    let pose = Pose { normal, ..draw.pose(triangle, hit) };
    draw.shoot(&pose)
}

fn cap(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let [along, across, normal] = draw.frame();
    let triangle = [along * 0.5, along * -0.5, across * power_of_ten(-knob as i32)];
    let pose = Pose { normal, ..draw.pose(triangle, hit) };
    draw.shoot(&pose)
}

fn sliver(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let (triangle, normal) = thin(draw, power_of_ten(-knob as i32));
    let offset = draw.direction();
    let pose = Pose { normal, ..draw.pose(triangle.map(|p| p + offset), hit) };
    draw.shoot(&pose)
}

fn mixed_scale(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let [a, b, _] = draw.benign();
    let c = a + draw.direction() * power_of_ten(knob as i32);
    let pose = draw.pose([a, b, c], hit);
    draw.shoot(&pose)
}

fn compound(draw: &mut Draw, knob: f64, hit: bool) -> Query {
    let size = power_of_ten(knob as i32).sqrt();
    let (triangle, normal) = thin(draw, 1.0 / size);
    let offset = draw.direction() * size;
    let pose = Pose { normal, ..draw.pose(triangle.map(|p| p + offset), hit) };
    let way = grazing(draw, normal, 1.0 / size);
    draw.shoot_along(&pose, way, way)
}

/// A direction of length 1 whose angle to the normal has the given cosine, or its negative.
pub(super) fn grazing(draw: &mut Draw, normal: DVec3, cosine: f64) -> DVec3 {
    let tangent = loop {
        let other = draw.direction();
        let tangent = other - normal * normal.dot(other);
        if tangent.length_squared() > 0.1 {
            break tangent.normalize();
        }
    };
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    normal * (draw.sign() * cosine) + tangent * sine
}

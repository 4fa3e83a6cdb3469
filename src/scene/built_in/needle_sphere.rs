//! A sphere of long thin triangles: many meridians, few rings.

use super::shape::Shape;
use super::{BuiltIn, View};
use glam::Vec3;

pub(super) const NEEDLE_SPHERE: BuiltIn = BuiltIn {
    name: "needle-sphere",
    about: "a sphere of radius 1 whose triangles are needles, closed",
    size: "meridians in a quarter turn; 24 n triangles",
    usual: 256,
    sizes: [1, 1 << 16],
    build,
};

/// Quarters of a turn.
const QUARTERS: u32 = 4;
/// Rings of vertices between the poles: cosine and sine of their distance from one. 3-4-5 is a right
/// triangle.
const RINGS: [[f32; 2]; 3] = [[0.6, 0.8], [0.0, 1.0], [-0.6, 0.8]];

fn build(quarter: u32) -> (Shape, Option<View>) {
    let meridians = QUARTERS * quarter;
    let mut vertices = vec![Vec3::Z];
    for [height, radius] in RINGS {
        let on_circle = (0..meridians).map(|meridian| circle(meridian, quarter));
        vertices.extend(on_circle.map(|[x, y]| Vec3::new(radius * x, radius * y, height)));
    }
    let last = vertices.len() as u32;
    vertices.push(-Vec3::Z);
    let rings = RINGS.len() as u32;
    let at = |ring: u32, meridian: u32| 1 + ring * meridians + meridian % meridians;
    let mut triangles = Vec::new();
    for meridian in 0..meridians {
        let next = meridian + 1;
        triangles.push([0, at(0, meridian), at(0, next)]);
        for ring in 0..rings - 1 {
            let [a, b] = [at(ring, meridian), at(ring, next)];
            let [c, d] = [at(ring + 1, meridian), at(ring + 1, next)];
            triangles.extend([[a, c, d], [a, d, b]]);
        }
        triangles.push([last, at(rings - 1, next), at(rings - 1, meridian)]);
    }
    (Shape { vertices, triangles }, None)
}

/// A point of the unit circle by the tangent of half its angle, which needs no sine; steps differ
/// in length by a factor of up to 2.
fn circle(meridian: u32, quarter: u32) -> [f32; 2] {
    let tangent = (meridian % quarter) as f32 / quarter as f32;
    let square = tangent * tangent;
    let (x, y) = ((1.0 - square) / (1.0 + square), 2.0 * tangent / (1.0 + square));
    match meridian / quarter {
        0 => [x, y],
        1 => [-y, x],
        2 => [-x, -y],
        _ => [y, -x],
    }
}

//! Exact zeros, and inputs without a sensible answer.

use super::super::draw::{Draw, REACH, weighted};
use super::super::family::{Family, Work};
use super::super::precision::Precision;
use super::single;
use crate::oracle::Query;
use glam::DVec3;

pub(super) fn families() -> Vec<Family> {
    let family = |id, knob, knobs: fn(Precision) -> Vec<f64>, generator, passes| Family {
        id,
        knob,
        knobs,
        work: Work::Free(generator),
        passes,
    };
    vec![
        family(
            "axis-aligned",
            "none",
            single,
            axis_aligned,
            "no wrong decision off the edges; t off by 1 unit in the last place at most",
        ),
        family("t-zero", "none", single, t_zero, "all hits, or none, stated"),
        family("coplanar", "none", single, coplanar, "no hit"),
        family(
            "degenerate",
            "kind: 1 a=b, 2 b=c, 3 a=b=c, 4 on a line, 5 on a line but for rounding",
            |_| kinds(5),
            degenerate,
            "no hit where the area is exactly 0",
        ),
        family(
            "not-finite",
            "kind: one coordinate is 1 NaN, 2 infinity, 3 -infinity, 4 the largest number",
            |_| kinds(4),
            not_finite,
            "no hit of kinds 1 to 3; no output that is not finite",
        ),
    ]
}

fn kinds(count: u32) -> Vec<f64> {
    (1..=count).map(f64::from).collect()
}

/// Vertices on a lattice of 1/64, in a plane across an axis; the ray runs along that axis, its
/// other components 0 or -0. A tenth of the origins lies in the plane.
fn axis_aligned(draw: &mut Draw, _: f64, hit: bool) -> Query {
    let axis = draw.below(3) as usize;
    let lattice = |x: f64| (x * 64.0).round() / 64.0;
    let plane = lattice(draw.between(-1.0, 1.0));
    let in_plane = |p: DVec3| {
        let mut p = p.to_array().map(lattice);
        p[axis] = plane;
        DVec3::from_array(p)
    };
    let triangle = draw.benign().map(in_plane);
    let (u, v) = draw.target(hit);
    let mut origin = in_plane(weighted(&triangle, u, v)).to_array();
    let side = draw.sign();
    if !draw.chance(0.1) {
        origin[axis] = lattice(plane - side * draw.distance());
    }
    let mut direction = [0.0, 1.0, 2.0].map(|_| if draw.chance(0.5) { 0.0 } else { -0.0 });
    direction[axis] = side;
    let (origin, direction) = (DVec3::from_array(origin), DVec3::from_array(direction));
    draw.ray(origin, direction, triangle, (0.0, REACH))
}

/// The origin is exactly in the triangle: a/2 + b/4 + c/4 of vertices on a lattice of 1/4.
fn t_zero(draw: &mut Draw, _: f64, _: bool) -> Query {
    let triangle = loop {
        let mut vertex = || DVec3::new(draw.whole(8), draw.whole(8), draw.whole(8)) / 4.0;
        let [a, b, c] = [vertex(), vertex(), vertex()];
        if (b - a).cross(c - a) != DVec3::ZERO {
            break [a, b, c];
        }
    };
    let [a, b, c] = triangle;
    let pose = draw.pose(triangle, true);
    let way = draw.towards(pose.normal);
    draw.ray(a / 2.0 + b / 4.0 + c / 4.0, way, triangle, (0.0, REACH))
}

/// Whole numbers; the direction is a whole combination of the edges, the origin in the plane (for
/// `hit`) or one normal off it.
fn coplanar(draw: &mut Draw, _: f64, in_plane: bool) -> Query {
    loop {
        let a = DVec3::new(draw.whole(64), draw.whole(64), draw.whole(64));
        let mut edge = || DVec3::new(draw.whole(16), draw.whole(16), draw.whole(16));
        let (e1, e2) = (edge(), edge());
        let (i, j) = (draw.whole(3), draw.whole(3));
        let direction = e1 * i + e2 * j;
        let normal = e1.cross(e2);
        if normal == DVec3::ZERO || direction == DVec3::ZERO {
            continue;
        }
        let start = a + e1 * draw.whole(2) + e2 * draw.whole(2) - direction * 2.0;
        let origin = if in_plane { start } else { start + normal };
        return draw.ray(origin, direction, [a, a + e1, a + e2], (0.0, 100.0));
    }
}

fn degenerate(draw: &mut Draw, kind: f64, _: bool) -> Query {
    let [mut a, mut b, mut c] = draw.benign();
    match kind as u32 {
        1 => b = a,
        2 => c = b,
        3 => (b, c) = (a, a),
        4 => {
            // Lattice points, so that c is exactly on the line through a and b.
            (a, b) = ((a * 64.0).round() / 64.0, (b * 64.0).round() / 64.0);
            c = b * 2.0 - a;
        }
        _ => c = a + (b - a) * draw.between(0.2, 1.8),
    }
    let triangle = [a, b, c].map(|p| draw.round(p));
    let along = draw.between(0.0, 1.0);
    let point = weighted(&triangle, along, draw.between(0.0, 1.0) * (1.0 - along));
    let (way, distance) = (draw.direction(), draw.distance());
    draw.ray(point - way * distance, way, triangle, (0.0, REACH * distance))
}

/// A benign hit, one of whose 15 coordinates is replaced.
fn not_finite(draw: &mut Draw, kind: f64, _: bool) -> Query {
    let triangle = draw.benign();
    let pose = draw.pose(triangle, true);
    let mut query = draw.shoot(&pose);
    let value = match kind as u32 {
        1 => f64::NAN,
        2 => f64::INFINITY,
        3 => f64::NEG_INFINITY,
        _ => draw.precision.largest(),
    };
    let place = draw.below(15) as usize;
    let component = place % 3;
    match place / 3 {
        0 => query.origin[component] = value,
        1 => query.direction[component] = value,
        corner => query.triangle[corner - 2][component] = value,
    }
    query
}

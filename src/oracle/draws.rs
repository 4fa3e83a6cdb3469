//! Random queries of every kind, for tests.

use super::{Query, solve};
use crate::workload::Pcg;

/// Shape of the random queries of one test.
pub type Draw = fn(&mut Pcg) -> Query;

pub fn query(p: [[f64; 3]; 5], t_min: f64, t_max: f64) -> Query {
    let [origin, direction, a, b, c] = p;
    Query { origin, direction, end: None, triangle: [a, b, c], t_min, t_max }
}

pub fn coordinates(mut next: impl FnMut() -> f64) -> [[f64; 3]; 5] {
    std::array::from_fn(|_| std::array::from_fn(|_| next()))
}

/// Uniform in the cube of side 2: f64 coordinates.
pub fn cube(pcg: &mut Pcg) -> Query {
    let p = coordinates(|| 2.0 * pcg.unit_f64() - 1.0);
    query(p, 0.0, f64::INFINITY)
}

/// The same rounded to f32, for a line.
fn cube_f32(pcg: &mut Pcg) -> Query {
    let p = coordinates(|| f64::from((2.0 * pcg.unit_f64() - 1.0) as f32));
    query(p, f64::from(-f32::MAX), f64::from(f32::MAX))
}

/// Whole numbers from -2 to 2 and t from 0 to 2: every class is common.
pub fn lattice(pcg: &mut Pcg) -> Query {
    let p = coordinates(|| pcg.below(5) as f64 - 2.0);
    query(p, 0.0, 2.0)
}

/// A lattice whose axes are stretched by powers of two from 2^-1074 on: every class, and the whole
/// range of exponents down to the subnormals.
pub fn stretched_lattice(pcg: &mut Pcg) -> Query {
    let mut q = lattice(pcg);
    for axis in 0..3 {
        let power = pcg.below(2090) as i32 - 1074;
        let stretch = |x: &mut f64| *x = times_power(*x, power);
        stretch(&mut q.origin[axis]);
        stretch(&mut q.direction[axis]);
        for vertex in &mut q.triangle {
            stretch(&mut vertex[axis]);
        }
    }
    q
}

fn times_power(x: f64, power: i32) -> f64 {
    // Two exact steps for small whole x.
    x * 2f64.powi(power / 2) * 2f64.powi(power - power / 2)
}

/// Any bits that are finite, f64.
fn any(pcg: &mut Pcg) -> Query {
    let p = coordinates(|| finite(pcg));
    let mut bounds = [finite(pcg), finite(pcg)];
    bounds.sort_by(f64::total_cmp);
    query(p, bounds[0], bounds[1])
}

fn finite(pcg: &mut Pcg) -> f64 {
    loop {
        let x = f64::from_bits(pcg.bits());
        if x.is_finite() {
            return x;
        }
    }
}

/// Any bits that are finite, f32, widened.
fn any_f32(pcg: &mut Pcg) -> Query {
    let mut next = || loop {
        let x = f32::from_bits(pcg.bits() as u32);
        if x.is_finite() {
            return f64::from(x);
        }
    };
    query(coordinates(&mut next), next(), f64::from(f32::MAX))
}

/// Subnormal f64 only.
pub fn subnormal(pcg: &mut Pcg) -> Query {
    let p = coordinates(|| {
        let size = f64::from_bits(pcg.bits() >> (12 + pcg.below(50)));
        if pcg.below(2) == 0 { size } else { -size }
    });
    query(p, 0.0, f64::MAX)
}

/// Coordinates of magnitudes 10^-8 to 10^8.
fn mixed(pcg: &mut Pcg) -> Query {
    let p = coordinates(|| times_power(2.0 * pcg.unit_f64() - 1.0, pcg.below(54) as i32 - 27));
    query(p, 0.0, f64::MAX)
}

/// A lattice far from the origin, nudged by an ulp here and there: near-boundary cases.
fn nudged(pcg: &mut Pcg) -> Query {
    let mut q = lattice(pcg);
    let mut nudge = |x: &mut f64| match pcg.below(6) {
        0 => *x = x.next_up(),
        1 => *x = x.next_down(),
        _ => {}
    };
    q.origin.iter_mut().for_each(&mut nudge);
    q.direction.iter_mut().for_each(&mut nudge);
    q.triangle.iter_mut().flatten().for_each(&mut nudge);
    q
}

/// A segment between two random points of the f32 cube, at magnitudes that differ.
fn segment(pcg: &mut Pcg) -> Query {
    let far = times_power(1.0, pcg.below(60) as i32);
    let [origin, end, a, b, c] = coordinates(|| f64::from((2.0 * pcg.unit_f64() - 1.0) as f32));
    let end = [end[0] * far, end[1], end[2] / far];
    Query::segment(origin, end, [a, b, c])
}

/// A segment between lattice points.
pub fn lattice_segment(pcg: &mut Pcg) -> Query {
    let [origin, end, a, b, c] = coordinates(|| pcg.below(5) as f64 - 2.0);
    Query::segment(origin, end, [a, b, c])
}

pub const DRAWS: [(&str, Draw, usize); 14] = [
    ("cube", cube, 1000),
    ("cube_f32", cube_f32, 1000),
    ("lattice", lattice, 5000),
    ("stretched", stretched_lattice, 3000),
    ("any", any, 600),
    ("any_f32", any_f32, 600),
    ("subnormal", subnormal, 1000),
    ("mixed", mixed, 1000),
    ("nudged", nudged, 3000),
    ("segment", segment, 1000),
    ("lattice_segment", lattice_segment, 2000),
    ("far bounds", far_bounds, 3000),
    ("at bounds", at_bounds, 1500),
    ("grazing", grazing, 1500),
];

/// Bounds and distances beyond what the filter can multiply, and infinite bounds.
fn far_bounds(pcg: &mut Pcg) -> Query {
    let far = 2f64.powi(225);
    let bounds = [0.0, f64::MAX, -f64::MAX, f64::INFINITY, f64::NEG_INFINITY, far, -far];
    let mut query = cube(pcg);
    let mut pick = || bounds[pcg.below(7) as usize];
    (query.t_min, query.t_max) = (pick(), pick());
    let power = -180 - pcg.below(70) as i32;
    query.direction = query.direction.map(|x| times_power(x, power));
    query
}

/// Bounds at the rounded exact distance, or next to it.
fn at_bounds(pcg: &mut Pcg) -> Query {
    let query = cube(pcg);
    bounded_nearby(pcg, query)
}

/// A ray that starts next to a vertex and runs almost in the plane, with bounds at its distance:
/// the determinant cancels, the distance's numerator does not.
fn grazing(pcg: &mut Pcg) -> Query {
    let [b, c, up, ..] = coordinates(|| 2.0 * pcg.unit_f64() - 1.0);
    let height = 2f64.powi(-20);
    let origin = up.map(|x| -height * x);
    let direction = std::array::from_fn(|i| 0.3 * b[i] + 0.3 * c[i] + height * up[i]);
    bounded_nearby(pcg, query([origin, direction, [0.0; 3], b, c], 0.0, 2.0))
}

fn bounded_nearby(pcg: &mut Pcg, query: Query) -> Query {
    let t = solve(&query).t;
    let mut near = || match pcg.below(4) {
        0 => t,
        1 => t.next_up(),
        2 => t.next_down(),
        _ => f64::INFINITY,
    };
    let (t_min, t_max) = (near(), near());
    Query { t_min: if t_min.is_infinite() { -t_min } else { t_min }, t_max, ..query }
}

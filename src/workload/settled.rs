//! Whether rounding could decide a pair for any kernel, in f32 or better.
//!
//! A yardstick, not an oracle: f64 arithmetic on f32 inputs, a billion times finer than the
//! margins that are asked for.

use super::{Ray, Triangle};
use glam::Vec3;

/// Unit roundoff of f32.
const UNIT_ROUNDOFF: f64 = 1.0 / (1u32 << 24) as f64;
/// The published epsilon of Moeller and Trumbore is 1e-6; ten times that is kept clear of.
const SMALLEST_DET: f64 = 1e-5;
/// Badouel's epsilon is 1e-6 on the cosine; twice that is kept clear of.
const SMALLEST_COSINE: f64 = 2e-6;

/// Where a pair stands, and how far rounding can move it.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    /// Distance of the plane along the ray; not finite where the line is parallel.
    pub t: f64,
    /// How far rounding can move t.
    pub doubt: f64,
    /// e1 . (d x e2), positive where the ray sees a, b, c counter-clockwise.
    det: f64,
    det_is_clear: bool,
    /// Of u, v, w, t - t_min, t_max - t.
    margins: [Margin; 5],
}

/// How far a quantity is inside its bound, and how far rounding can move it.
#[derive(Clone, Copy, Debug)]
struct Margin {
    value: f64,
    doubt: f64,
}

impl Standing {
    /// Measures a pair. Rounding is taken to move a quantity by `allowance` times the unit roundoff
    /// times a condition number that is pessimistic in two ways, so that it bounds unstable
    /// kernels as well: products are taken by magnitude, as if nothing cancelled (grazing rays
    /// along an edge), and multiplied by the triangle's aspect (kernels that use the normal or the
    /// Gram determinant lose that much more than the condition number on slivers).
    pub fn of(ray: &Ray, triangle: &Triangle, allowance: f64) -> Self {
        let [o, d, a, b, c] =
            [ray.origin, ray.direction, triangle.a, triangle.b, triangle.c].map(wide);
        let (e1, e2, e3, s) = (minus(b, a), minus(c, a), minus(c, b), minus(o, a));
        let (p, q, n) = (cross(d, e2), cross(s, e1), cross(e1, e2));
        let det = dot(e1, p);
        let (t, u, v) = (dot(e2, q) / det, dot(s, p) / det, dot(d, q) / det);
        let w = 1.0 - u - v;
        let sums: [f64; 3] = std::array::from_fn(|i| {
            o[i].abs() + (t * d[i]).abs() + (w * a[i]).abs() + (u * b[i]).abs() + (v * c[i]).abs()
        });
        let scale = allowance * UNIT_ROUNDOFF * aspect(triangle).max(1.0) / det.abs();
        let doubt = |x, y| scale * dot(cross_of_magnitudes(x, y), sums);
        let doubt_t = doubt(e1, e2);
        let cosine_is_clear =
            dot(n, d) * dot(n, d) > SMALLEST_COSINE * SMALLEST_COSINE * dot(n, n) * dot(d, d);
        Standing {
            t,
            doubt: doubt_t,
            det,
            det_is_clear: det.abs() > SMALLEST_DET && cosine_is_clear,
            margins: [
                Margin { value: u, doubt: doubt(d, e2) },
                Margin { value: v, doubt: doubt(e1, d) },
                Margin { value: w, doubt: doubt(d, e3) },
                Margin { value: t - f64::from(ray.t_min), doubt: doubt_t },
                Margin { value: f64::from(ray.t_max) - t, doubt: doubt_t },
            ],
        }
    }

    /// Whether every quantity is clear of its bound, so that every test of every kernel has the
    /// same outcome. (NaN fails every comparison here and below.)
    pub fn is_settled(&self) -> bool {
        self.det_is_clear && self.margins.iter().all(|m| m.value.abs() > m.doubt)
    }

    /// Whether the ray sees the front. For a settled pair, f64 has the sign right.
    pub fn faces(&self) -> bool {
        self.det > 0.0
    }

    /// Whether every kernel finds a hit.
    pub fn is_hit(&self) -> bool {
        self.det_is_clear && self.margins.iter().all(|m| m.value > m.doubt)
    }

    /// Whether no kernel finds a hit.
    pub fn is_miss(&self) -> bool {
        self.margins.iter().any(|m| m.value < -m.doubt)
    }
}

/// Square of the longest edge over twice the area: 1.15 for an equilateral triangle; not finite
/// for one without area.
pub fn aspect(triangle: &Triangle) -> f64 {
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(wide);
    let (e1, e2, e3) = (minus(b, a), minus(c, a), minus(c, b));
    let n = cross(e1, e2);
    let longest = dot(e1, e1).max(dot(e2, e2)).max(dot(e3, e3));
    longest / dot(n, n).sqrt()
}

fn wide(p: Vec3) -> [f64; 3] {
    [f64::from(p.x), f64::from(p.y), f64::from(p.z)]
}

fn minus(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    [x[0] - y[0], x[1] - y[1], x[2] - y[2]]
}

fn dot(x: [f64; 3], y: [f64; 3]) -> f64 {
    x[0] * y[0] + x[1] * y[1] + x[2] * y[2]
}

fn cross(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
}

fn cross_of_magnitudes(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    let (x, y) = (x.map(f64::abs), y.map(f64::abs));
    [x[1] * y[2] + x[2] * y[1], x[2] * y[0] + x[0] * y[2], x[0] * y[1] + x[1] * y[0]]
}

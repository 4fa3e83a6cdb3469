//! What the oracle is asked: one ray (or segment) and one triangle, in f64.

use crate::workload::{Ray, Triangle};
use glam::Vec3;

/// One ray against one triangle.
///
/// Positions and direction are exact as they stand; f32 inputs are widened, which loses nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query {
    /// Where t = 0.
    pub origin: [f64; 3],
    /// Direction, of any length. With `end` given it is only the rounded difference, which the
    /// filter may look at.
    pub direction: [f64; 3],
    /// `Some` for the segment form: the direction is *exactly* `end - origin`, which need not be
    /// representable, and t = 1 is the end.
    pub end: Option<[f64; 3]>,
    /// Vertices a, b, c; u is the weight of b, v of c.
    pub triangle: [[f64; 3]; 3],
    /// Smallest t that counts (closed); may be minus infinity.
    pub t_min: f64,
    /// Largest t that counts (closed); may be infinity.
    pub t_max: f64,
}

impl Query {
    /// The question that kernels on (origin, direction) answer for this pair.
    pub fn of(ray: &Ray, triangle: &Triangle) -> Self {
        Query {
            origin: wide(ray.origin),
            direction: wide(ray.direction),
            end: None,
            triangle: vertices(triangle),
            t_min: f64::from(ray.t_min),
            t_max: f64::from(ray.t_max),
        }
    }

    /// The question that kernels on (origin, end) answer for this pair: t in [0, 1] of the exact
    /// difference `end - origin`.
    pub fn of_segment(ray: &Ray, triangle: &Triangle) -> Self {
        Query::segment(wide(ray.origin), wide(ray.end), vertices(triangle))
    }

    /// A segment against a triangle: t in [0, 1] of the exact difference `end - origin`.
    pub fn segment(origin: [f64; 3], end: [f64; 3], triangle: [[f64; 3]; 3]) -> Self {
        let direction = [end[0] - origin[0], end[1] - origin[1], end[2] - origin[2]];
        Query { origin, direction, end: Some(end), triangle, t_min: 0.0, t_max: 1.0 }
    }

    /// Whether every coordinate is finite and no bound is NaN. Anything else is a miss by rule
    /// ([`super::classify`] says `Outside`), and it is for the caller to name it.
    pub fn is_finite(&self) -> bool {
        let finite = |p: &[f64; 3]| p.iter().all(|x| x.is_finite());
        // The rounded difference of two finite ends may overflow; the exact one does not.
        let direction = self.end.as_ref().unwrap_or(&self.direction);
        finite(&self.origin)
            && finite(direction)
            && self.triangle.iter().all(finite)
            && !self.t_min.is_nan()
            && !self.t_max.is_nan()
    }
}

fn wide(p: Vec3) -> [f64; 3] {
    [f64::from(p.x), f64::from(p.y), f64::from(p.z)]
}

fn vertices(triangle: &Triangle) -> [[f64; 3]; 3] {
    [wide(triangle.a), wide(triangle.b), wide(triangle.c)]
}

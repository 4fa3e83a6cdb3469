//! A point just above the surface, where a next ray may start.

use crate::number::Precision;
use crate::workload::{Ray, Triangle};
use glam::{DVec3, Vec3};

/// How far off the surface, in unit roundoffs of f32 (2^-24) times the largest coordinate of the
/// triangle. The start is rounded to f32, which moves it by at most sqrt(3) of these; the rest is
/// for the next kernel's own rounding. The family `spawned-rays` of the stability sweep measures
/// what kernels need, at seven distances from the origin: 16 is the most that any kernel without an
/// epsilon of its own needs there. Four times that leaves room for slimmer triangles. The published
/// listings that compare t with an epsilon need thousands or more, and no offset in proportion to
/// rounding helps them.
pub const OFFSET: f64 = 64.0;

/// A point off a triangle, on the side that a ray came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Where a next ray starts.
    pub start: Vec3,
    /// Of length 1, towards the side that the ray came from.
    pub normal: DVec3,
    /// How far the start is off the surface, before rounding.
    pub offset: f64,
}

impl Spot {
    /// Where a ray meets the plane of a triangle, in f64, off it by [`OFFSET`]. `None` where it
    /// does not meet the plane in a point.
    pub fn of(ray: &Ray, triangle: &Triangle) -> Option<Self> {
        let (a, b, c) = (triangle.a.as_dvec3(), triangle.b.as_dvec3(), triangle.c.as_dvec3());
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let normal = (b - a).cross(c - a).try_normalize()?;
        let approach = normal.dot(direction);
        let point = origin + direction * (normal.dot(a - origin) / approach);
        let normal = if approach > 0.0 { -normal } else { normal };
        let offset = offset([triangle.a, triangle.b, triangle.c]);
        let start = (point + normal * offset).as_vec3();
        start.is_finite().then_some(Spot { start, normal, offset })
    }
}

/// [`OFFSET`] for these points, as a length.
pub(super) fn offset<const COUNT: usize>(points: [Vec3; COUNT]) -> f64 {
    let largest = points.map(|point| point.abs().max_element()).into_iter().fold(0.0, f32::max);
    OFFSET * Precision::F32.unit_roundoff() * f64::from(largest)
}

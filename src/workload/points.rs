//! Points of the planes of triangles, at an exact share of points that are inside.
//!
//! A point is p = a + u (b - a) + v (c - a), rounded to f32, so it lies beside the plane and not in
//! it. The right answer is that of its projection along the normal N: a point test is given the
//! triangle and p, and in exact arithmetic every formula by dot products with vectors in the plane
//! (Keidy's edges, the inner normals of half-spaces, N . (AB x AP) of signed areas) yields the same
//! for p and p + k N; none can tell them apart. Badouel's formula drops a coordinate instead, which
//! is a projection along an axis; how far the two can be apart is part of what follows.
//!
//! How far rounding p can move a weight. Vertices and weights are multiples of 2^-24 and the
//! weights are at most 3, so the sum is exact in f64 and p is one rounding away from it. Its
//! coordinates are at most 4 (the positive weights add up to no more), so each moves by at most
//! half of 2^-22, and p by |e| <= sqrt(3) 2^-23. Along an axis with |N_w| >= |N| / sqrt(3) the
//! projection adds at most sqrt(2) |e|. A weight falls from 1 to 0 over a height of the triangle;
//! the smallest is 2 area / longest = longest / aspect. So no weight moves by more than
//! (1 + sqrt(2)) sqrt(3) 2^-23 x 50 x 16 < 0.0004 for an aspect of at most 50 and a longest edge of
//! at least 1/16. The margin of 0.02 is fifty times that; the rest is for the kernels' own rounding.

use super::pairs::{interleaved, quota};
use super::random::Pcg;
use super::settled::{aspect, longest_squared, off_plane};
use super::thesis::point;
use super::{QueryKind, Ray, Triangle, Unit, WorkloadError, hash};
use glam::Vec3;

/// Every weight of every point is at least that far from 0.
const MARGIN: f64 = 0.02;
/// Triangles are no slimmer than this, see [`aspect`].
const MOST_ASPECT: f64 = 50.0;
/// Square of 1/16, the least length of a triangle's longest edge.
const LEAST_LONGEST_SQUARED: f64 = 1.0 / 256.0;
/// Origins keep this distance from the plane.
const LEAST_DISTANCE: f64 = 1.0 / 64.0;

/// What to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointSpec {
    /// Number of points, 1 to 2^24.
    pub count: usize,
    /// Share of points that are inside, 0 to 1; times `count` it is rounded half up.
    pub density: f64,
    /// Where the project's generator starts.
    pub seed: u64,
}

/// A set of points: the end of ray i is a point of triangle i's plane.
#[derive(Clone, Debug)]
pub struct PointSet {
    /// From an origin off the plane towards the point; [`Ray::end`] is the point.
    pub rays: Vec<Ray>,
    /// One a point.
    pub triangles: Vec<Triangle>,
    /// Number of points that are inside, spread as evenly as the hits of
    /// [`Pairs`](super::Pairs).
    pub hits: usize,
    /// [`hash::workload`] of the rays and triangles.
    pub hash: u64,
}

impl PointSet {
    /// Draws a set: first the points inside, then those outside, then the two are interleaved.
    ///
    /// Each attempt draws a, b, c, the origin, then the two numbers that become u and v: inside
    /// uniform in the unit square, outside in [-1, 2] x [-1, 2], in steps of 2^-24 and 3 x 2^-24.
    ///
    /// # Errors
    /// For a specification that is not allowed, or (which a sound generator will not see) a quota
    /// that 10 000 + 64 x count attempts did not fill.
    pub fn draw(spec: PointSpec) -> Result<Self, WorkloadError> {
        let hits_wanted = quota("number of points", spec.count, spec.density)?;
        let misses_wanted = spec.count - hits_wanted;
        let most_attempts = 10_000 + 64 * spec.count as u64;
        let mut source = Pcg::new(spec.seed);
        let (mut hits, mut misses) = (Vec::new(), Vec::new());
        for attempts in 0.. {
            let inside = hits.len() < hits_wanted;
            if !inside && misses.len() == misses_wanted {
                break;
            }
            if attempts == most_attempts {
                let (hits, misses) = (hits.len(), misses.len());
                return Err(WorkloadError::Quota {
                    attempts,
                    hits,
                    hits_wanted,
                    misses,
                    misses_wanted,
                });
            }
            if let Some(pair) = attempt(&mut source, inside) {
                if inside { hits.push(pair) } else { misses.push(pair) }
            }
        }
        let (rays, triangles): (Vec<Ray>, Vec<Triangle>) = interleaved(hits, misses).unzip();
        let hash = hash::workload(&rays, &triangles);
        Ok(PointSet { rays, triangles, hits: hits_wanted, hash })
    }

    /// Share of the points that are inside.
    pub fn density(&self) -> f64 {
        self.hits as f64 / self.rays.len() as f64
    }
}

/// One point, unless triangle, origin or weights are not as they should be.
fn attempt(source: &mut Pcg, inside: bool) -> Option<(Ray, Triangle)> {
    let a = point(source);
    let b = point(source);
    let c = point(source);
    let triangle = Triangle { a, b, c };
    let origin = point(source);
    let x = f64::from(source.unit());
    let y = f64::from(source.unit());
    let (u, v) = if inside { (x, y) } else { (3.0 * x - 1.0, 3.0 * y - 1.0) };
    let weights = [1.0 - u - v, u, v];
    let clear = if inside {
        weights.iter().all(|weight| *weight >= MARGIN)
    } else {
        // All weights keep the margin, so that no test of any kernel is left to rounding.
        weights.iter().all(|weight| weight.abs() >= MARGIN)
            && weights.iter().any(|weight| *weight <= -MARGIN)
    };
    // A NaN, as the aspect of three equal vertices is, fails every comparison.
    let sound = clear
        && aspect(&triangle) <= MOST_ASPECT
        && longest_squared(&triangle) >= LEAST_LONGEST_SQUARED
        && off_plane(origin, &triangle) >= LEAST_DISTANCE;
    sound.then(|| (QueryKind::Ray.ray(origin, weighted(&triangle, u, v)), triangle))
}

/// a + u (b - a) + v (c - a), exact in f64 and rounded once.
fn weighted(triangle: &Triangle, u: f64, v: f64) -> Vec3 {
    let Triangle { a, b, c } = triangle;
    let coordinate = |a: f32, b: f32, c: f32| {
        let (a, b, c) = (f64::from(a), f64::from(b), f64::from(c));
        (a + u * (b - a) + v * (c - a)) as f32
    };
    Vec3::new(coordinate(a.x, b.x, c.x), coordinate(a.y, b.y, c.y), coordinate(a.z, b.z, c.z))
}

#[cfg(test)]
#[path = "points_tests.rs"]
mod tests;

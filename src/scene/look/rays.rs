//! What rays look like, without following them.

use crate::number::Precision;
use crate::scene::bounds::Bounds;
use crate::workload::Ray;
use serde::Serialize;

/// Dividing a vector by its length in f32 leaves a length of 1 within so many unit roundoffs: the
/// squares and their sum round thrice, halved by the root, which rounds once more, as the division
/// does: 3.5 to first order.
const NORMALISED: f64 = 4.0;

/// Of all rays.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RayLooks {
    /// Number of rays.
    pub rays: u64,
    /// Rays that start elsewhere than the first.
    pub other_origins: u64,
    /// Whether all start at one point: `other_origins` is 0.
    pub common_origin: bool,
    /// Rays whose direction is not, bit for bit, that of the first.
    pub other_directions: u64,
    /// Whether all are parallel: `other_directions` is 0.
    pub parallel: bool,
    /// Rays whose direction is 0; they meet nothing.
    pub zero_directions: u64,
    /// How far the length of a direction is from 1 at most, in unit roundoffs of f32 (2^-24).
    pub length_error: f64,
    /// Whether directions have length 1, as near as f32 comes by dividing: `length_error` is at
    /// most 4.
    pub normalised: bool,
    /// Rays that end before the largest f32 number.
    pub finite_ends: u64,
    /// Rays whose range does not start at 0.
    pub moved_starts: u64,
    /// Whether every range is from 0 to infinity: `finite_ends` and `moved_starts` are 0.
    pub open_range: bool,
    /// Rays that start outside the mesh's closed box.
    pub origins_outside: u64,
    /// Whether none starts within a closed mesh, since all start outside its box:
    /// `origins_outside` is the number of rays.
    pub all_outside: bool,
    /// Share of rays that meet the box around the mesh within their range, 0 to 1; by f64, so that
    /// a ray that only touches it may be counted or not.
    pub box_share: f64,
}

impl RayLooks {
    /// Of rays and the box around a mesh.
    pub(super) fn of(rays: &[Ray], bounds: &Bounds) -> Self {
        let count = |is: &dyn Fn(&Ray) -> bool| rays.iter().filter(|ray| is(ray)).count() as u64;
        let first = rays.first();
        let other_origins = count(&|ray| first.is_some_and(|f| f.origin != ray.origin));
        let other_directions = count(&|ray| first.is_some_and(|f| f.direction != ray.direction));
        let length_error = |ray: &Ray| (ray.direction.as_dvec3().length() - 1.0).abs();
        let length_error =
            rays.iter().map(length_error).fold(0.0, f64::max) / Precision::F32.unit_roundoff();
        let finite_ends = count(&|ray| ray.t_max < f32::MAX);
        let moved_starts = count(&|ray| ray.t_min != 0.0);
        let origins_outside = count(&|ray| !bounds.holds(ray.origin));
        let box_hits = count(&|ray| meets(ray, bounds)) as f64;
        RayLooks {
            rays: rays.len() as u64,
            other_origins,
            common_origin: other_origins == 0,
            other_directions,
            parallel: other_directions == 0,
            zero_directions: count(&|ray| ray.direction == glam::Vec3::ZERO),
            length_error,
            normalised: length_error <= NORMALISED,
            finite_ends,
            moved_starts,
            open_range: finite_ends == 0 && moved_starts == 0,
            origins_outside,
            all_outside: origins_outside == rays.len() as u64,
            box_share: box_hits / (rays.len() as f64).max(1.0),
        }
    }
}

/// Whether some point of the ray is in the box.
fn meets(ray: &Ray, bounds: &Bounds) -> bool {
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (lowest, highest) = (bounds.lowest.as_dvec3(), bounds.highest.as_dvec3());
    let mut range = [f64::from(ray.t_min), f64::from(ray.t_max)];
    for axis in 0..3 {
        let ends = [lowest[axis] - origin[axis], highest[axis] - origin[axis]];
        if direction[axis] == 0.0 {
            // Between the two planes always, or never.
            if ends[0] > 0.0 || ends[1] < 0.0 {
                return false;
            }
            continue;
        }
        let [one, other] = ends.map(|end| end / direction[axis]);
        range = [range[0].max(one.min(other)), range[1].min(one.max(other))];
    }
    range[0] <= range[1]
}

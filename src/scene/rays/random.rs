//! Rays that have nothing to do with each other.

use super::reach;
use crate::scene::bounds::Bounds;
use crate::workload::{Pcg, Ray, normalised, on_sphere, ray};

/// From a random point of the ball's surface to another.
pub(super) fn chord(bounds: &Bounds, source: &mut Pcg) -> Ray {
    let (from, to) = (on_sphere(source), on_sphere(source));
    let origin = (bounds.centre() + from.as_dvec3() * bounds.radius()).as_vec3();
    ray(origin, normalised(to - from), reach(origin, bounds))
}

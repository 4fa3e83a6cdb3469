//! Rays over the half of all directions that a surface sees.

use super::{Rays, Spots, reach};
use crate::scene::bounds::Bounds;
use crate::workload::{Pcg, on_sphere, ray};

/// Sums shorter than this have lost their direction to rounding, and are drawn again.
const SHORTEST: f64 = 1.0 / 1024.0;

/// So many rays from each spot, a direction the likelier the nearer it is to the normal (by its
/// cosine): the normal plus a random point of the unit sphere, normalised.
pub(super) fn over(spots: &Spots, per_point: u32, bounds: &Bounds, source: &mut Pcg) -> Rays {
    let mut rays = Vec::with_capacity(spots.spots.len() * per_point as usize);
    for spot in &spots.spots {
        for _ in 0..per_point {
            let direction = loop {
                let sum = spot.normal + on_sphere(source).as_dvec3();
                if sum.length() >= SHORTEST {
                    break sum.normalize().as_vec3();
                }
            };
            rays.push(ray(spot.start, direction, reach(spot.start, bounds)));
        }
    }
    Rays { rays, unseen: spots.unseen, dark: spots.dark, light: None }
}

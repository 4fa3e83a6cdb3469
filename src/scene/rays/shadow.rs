//! Rays that ask whether something is before a light.

use super::spot::offset;
use super::{Rays, Spot, Spots};
use crate::workload::Ray;
use glam::Vec3;

/// A ray from each spot that faces the light.
pub(super) fn towards(light: Vec3, spots: &Spots) -> Rays {
    let rays: Vec<Ray> = spots.spots.iter().filter_map(|spot| ray(spot, light)).collect();
    let dark = spots.dark + (spots.spots.len() - rays.len()) as u64;
    Rays { rays, unseen: spots.unseen, dark, light: Some(light) }
}

/// A ray from a spot to a light, `None` where the spot faces away or is nearer than rounding.
///
/// It ends as far before the light as it starts off the surface, so that a lamp's own surface
/// through the light's point is not met. The direction is rounded: at the light, the ray misses it
/// by less than sqrt(3) unit roundoffs of the distance, which is part of the same margin.
pub fn ray(spot: &Spot, light: Vec3) -> Option<Ray> {
    let way = light.as_dvec3() - spot.start.as_dvec3();
    let distance = way.length();
    let t_max = (distance - offset([light, spot.start])) as f32;
    (spot.normal.dot(way) > 0.0 && t_max > 0.0).then(|| Ray {
        origin: spot.start,
        direction: (way / distance).as_vec3(),
        end: light,
        t_min: 0.0,
        t_max,
    })
}

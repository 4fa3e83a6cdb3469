//! bvh: a bounding-volume hierarchy with a ray-triangle test beside it.

use bvh::ray::Ray;
use nalgebra::{Point3, Vector3};

use super::{Peer, finite_t_max};
use crate::kernels::About;
use crate::workload;

/// See the module's text.
pub struct Bvh;

fn point(v: glam::Vec3) -> Point3<f32> {
    Point3::from(v.to_array())
}

impl Peer for Bvh {
    const ABOUT: About = About {
        id: "peer-bvh",
        name: "bvh 0.13.0",
        year: 1997,
        source: "crate bvh 0.13.0, Ray::intersects_triangle; front faces only, det >= f32::EPSILON, \
                 t > f32::EPSILON",
        setup: "none",
        stored: "vertices",
        watertight: false,
        codes: &[],
    };
    const CULL: &'static str = "on";
    const DIVISION: &'static str = "first";
    const LEADING: &'static str = "inside";
    /// With the largest t.
    type Ray = (Ray<f32, 3>, f32);
    type Triangle = [Point3<f32>; 3];

    /// Its constructor normalises the direction, as ours are when they are drawn. The fields are
    /// filled as they are, so that t has the same unit as everywhere.
    fn ray(ray: &workload::Ray) -> Self::Ray {
        let direction = Vector3::from(ray.direction.to_array());
        let inv_direction = direction.map(f32::recip);
        (Ray { origin: point(ray.origin), direction, inv_direction }, finite_t_max(ray))
    }

    fn triangle(triangle: &workload::Triangle) -> [Point3<f32>; 3] {
        [point(triangle.a), point(triangle.b), point(triangle.c)]
    }

    #[inline(always)]
    fn test<const UV: bool>(
        (ray, t_max): &Self::Ray,
        [a, b, c]: &Self::Triangle,
    ) -> Option<[f32; 3]> {
        let found = ray.intersects_triangle(a, b, c);
        (found.distance <= *t_max).then_some([found.distance, found.u, found.v])
    }
}

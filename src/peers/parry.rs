//! parry3d: the collision library of the Rapier physics engine.

use parry3d::math::Vector;
use parry3d::query::{Ray, details::local_ray_intersection_with_triangle};
use parry3d::shape::Triangle;

use super::{Peer, finite_t_max};
use crate::kernels::About;
use crate::workload;

/// See the module's text.
pub struct Parry;

fn vector(v: glam::Vec3) -> Vector {
    Vector::from_array(v.to_array())
}

impl Peer for Parry {
    const ABOUT: About = About {
        id: "peer-parry",
        name: "parry3d 0.31.1",
        year: 2005,
        source: "crate parry3d 0.31.1, query::details::local_ray_intersection_with_triangle (after \
                 Ericson, Real-Time Collision Detection, 5.3.6); t >= 0, two-sided, no epsilon; \
                 the bound of t as in its RayCast",
        setup: "none",
        stored: "vertices",
        watertight: false,
        codes: &[],
    };
    const DIVISION: &'static str = "last";
    const LEADING: &'static str = "distance";
    /// With the largest t.
    type Ray = (Ray, f32);
    type Triangle = Triangle;

    fn ray(ray: &workload::Ray) -> (Ray, f32) {
        (Ray::new(vector(ray.origin), vector(ray.direction)), finite_t_max(ray))
    }

    fn triangle(triangle: &workload::Triangle) -> Triangle {
        Triangle::new(vector(triangle.a), vector(triangle.b), vector(triangle.c))
    }

    /// The function behind its `RayCast`, which leaves the weights away.
    #[inline(always)]
    fn test<const UV: bool>((ray, t_max): &(Ray, f32), triangle: &Triangle) -> Option<[f32; 3]> {
        let Triangle { a, b, c } = *triangle;
        let (hit, weights) = local_ray_intersection_with_triangle(a, b, c, ray)?;
        let t = hit.time_of_impact;
        (t <= *t_max).then_some([t, weights.y, weights.z])
    }
}

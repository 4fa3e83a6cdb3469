//! Möller and Trumbore's test as those write it who take it from the encyclopaedia, on glam's vectors.
//!
//! It is typed here and not one of our kernels, because it stands for code that is not ours.

use glam::Vec3;

use super::{Peer, finite_t_max};
use crate::kernels::About;
use crate::workload::{self, Triangle};

/// See the module's text.
pub struct Glam;

impl Peer for Glam {
    const ABOUT: About = About {
        id: "peer-glam",
        name: "Möller-Trumbore on glam",
        year: 1997,
        source: "the Rust listing of the English Wikipedia's article on the Möller-Trumbore \
                 intersection algorithm, on glam::Vec3; two-sided, |det| >= f32::EPSILON, \
                 t > f32::EPSILON",
        setup: "none",
        stored: "vertices",
        watertight: false,
        codes: &[],
    };
    const DIVISION: &'static str = "first";
    const LEADING: &'static str = "inside";
    /// Origin, direction and the largest t.
    type Ray = (Vec3, Vec3, f32);
    type Triangle = Triangle;

    fn ray(ray: &workload::Ray) -> (Vec3, Vec3, f32) {
        (ray.origin, ray.direction, finite_t_max(ray))
    }

    fn triangle(triangle: &Triangle) -> Triangle {
        *triangle
    }

    #[inline(always)]
    fn test<const UV: bool>(
        (origin, direction, t_max): &Self::Ray,
        triangle: &Triangle,
    ) -> Option<[f32; 3]> {
        let e1 = triangle.b - triangle.a;
        let e2 = triangle.c - triangle.a;
        let ray_cross_e2 = direction.cross(e2);
        let det = e1.dot(ray_cross_e2);
        if det > -f32::EPSILON && det < f32::EPSILON {
            return None;
        }
        let inv_det = 1.0 / det;
        let s = *origin - triangle.a;
        let u = inv_det * s.dot(ray_cross_e2);
        if !(0.0..=1.0).contains(&u) {
            return None;
        }
        let s_cross_e1 = s.cross(e1);
        let v = inv_det * direction.dot(s_cross_e1);
        if v < 0.0 || u + v > 1.0 {
            return None;
        }
        let t = inv_det * e2.dot(s_cross_e1);
        (t > f32::EPSILON && t <= *t_max).then_some([t, u, v])
    }
}

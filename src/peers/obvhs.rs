//! obvhs: bounding-volume hierarchies, with three triangles: plain, prepared, and compressed.

use glam::Vec3A;
use obvhs::ray::Ray;
use obvhs::rt_triangle::{RtCompressedTriangle, RtTriangle};
use obvhs::triangle::Triangle;

use super::{Peer, finite_t_max};
use crate::kernels::About;
use crate::workload;

/// Its plain triangle: three corners, each padded to a register.
pub struct Obvhs;
/// Its triangle for processors: a corner, two edges and the normal, each padded to a register.
pub struct ObvhsPrepared;
/// Its triangle for graphics cards: a corner, and two edges in half precision.
pub struct ObvhsCompressed;

const PLAIN: About = About {
    id: "peer-obvhs",
    name: "obvhs 0.4.0",
    year: 1997,
    source: "crate obvhs 0.4.0, triangle::Triangle::intersect, and its compute_barycentric for u and \
             v, which divides by the unit normal: what it yields are weights times the double area; \
             signs are tested by their bits, so hits with a weight of -0 are lost; 1/det must not be 0",
    setup: "none",
    stored: "vertices",
    watertight: false,
    codes: &[],
};
const PREPARED: About = About {
    source: "crate obvhs 0.4.0, rt_triangle::RtTriangle::intersect, and its compute_barycentric for \
             u and v; signs as in its plain triangle",
    setup: "edges and normal",
    stored: "precomputed",
    ..PLAIN
};
const COMPRESSED: About = About {
    id: "peer-obvhs-compressed",
    name: "obvhs 0.4.0, compressed",
    source: "crate obvhs 0.4.0, rt_triangle::RtCompressedTriangle::intersect, and its \
             compute_barycentric for u and v; edges of eleven bits, so another triangle than was \
             asked about; signs as in its plain triangle",
    setup: "edges in half precision",
    stored: "compressed",
    ..PLAIN
};

fn ray(ray: &workload::Ray) -> Ray {
    let [origin, direction] = [ray.origin, ray.direction].map(Vec3A::from);
    let inv_direction = direction.recip();
    Ray { origin, direction, inv_direction, tmin: ray.t_min, tmax: finite_t_max(ray) }
}

fn corners(triangle: &workload::Triangle) -> [Vec3A; 3] {
    [triangle.a, triangle.b, triangle.c].map(Vec3A::from)
}

/// A peer of one of the three triangles: they have the same functions, but no trait for them.
macro_rules! triangle {
    ($peer:ident, $about:ident, $triangle:ty, $native:literal, $of:expr) => {
        impl Peer for $peer {
            const ABOUT: About = $about;
            const DIVISION: &'static str = "first";
            const LEADING: &'static str = "inside";
            const TESTS: &'static str = "sign-bits";
            const STORED_IS_NATIVE: bool = $native;
            type Ray = Ray;
            type Triangle = $triangle;

            fn ray(drawn: &workload::Ray) -> Ray {
                ray(drawn)
            }

            fn triangle(drawn: &workload::Triangle) -> $triangle {
                let of: fn([Vec3A; 3]) -> $triangle = $of;
                of(corners(drawn))
            }

            #[inline(always)]
            fn test<const UV: bool>(ray: &Ray, triangle: &$triangle) -> Option<[f32; 3]> {
                let t = triangle.intersect(ray);
                if t > ray.tmax {
                    return None;
                }
                let weights = if UV { triangle.compute_barycentric(ray) } else { glam::Vec2::ZERO };
                Some([t, weights.x, weights.y])
            }
        }
    };
}

triangle!(Obvhs, PLAIN, Triangle, true, |[v0, v1, v2]| Triangle { v0, v1, v2 });
triangle!(ObvhsPrepared, PREPARED, RtTriangle, false, |[a, b, c]| RtTriangle::new(a, b, c));
triangle!(ObvhsCompressed, COMPRESSED, RtCompressedTriangle, true, |[a, b, c]| {
    RtCompressedTriangle::new(a, b, c)
});

//! rayx: Baldwin and Weber's test.

use nalgebra_of_rayx::{Matrix3, Vector3};
use rayx::intersect::{compute_baldwin_weber_transform, intersect_baldwin_weber};

use super::{Peer, finite_t_max};
use crate::kernels::About;
use crate::workload;

/// See the module's text.
pub struct Rayx;

fn vector(v: glam::Vec3) -> Vector3<f32> {
    Vector3::from(v.to_array())
}

impl Peer for Rayx {
    const ABOUT: About = About {
        id: "peer-rayx",
        name: "rayx 0.2.0",
        year: 2016,
        source: "crate rayx 0.2.0, intersect_baldwin_weber; misses triangles that it is nearly \
                 parallel to (|d.z| < f32::EPSILON after the transformation) and such of which the \
                 square of the double area is below 1e-20",
        setup: "transformation to a unit triangle",
        stored: "precomputed",
        watertight: false,
        codes: &[],
    };
    const DIVISION: &'static str = "first";
    const LEADING: &'static str = "distance";
    /// With the bounds of t.
    type Ray = (rayx::Ray<f32>, [f32; 2]);
    /// The fields of its `Triangle`, of which there is none for what it calls degenerate: of zeros
    /// here, which no ray hits.
    type Triangle = (Matrix3<f32>, Vector3<f32>);

    fn ray(ray: &workload::Ray) -> Self::Ray {
        let its = rayx::Ray::new(vector(ray.origin), vector(ray.direction));
        (its, [ray.t_min, finite_t_max(ray)])
    }

    fn triangle(triangle: &workload::Triangle) -> Self::Triangle {
        let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(vector);
        compute_baldwin_weber_transform(a, b, c).map_or_else(
            |_| (Matrix3::zeros(), Vector3::zeros()),
            |rows| (rows.fixed_view::<3, 3>(0, 0).into(), rows.column(3).into()),
        )
    }

    #[inline(always)]
    fn test<const UV: bool>(
        (ray, [t_min, t_max]): &Self::Ray,
        (rows, offset): &Self::Triangle,
    ) -> Option<[f32; 3]> {
        let hit = intersect_baldwin_weber(rows, offset, *ray, *t_min, *t_max)?;
        Some([hit.t, hit.u, hit.v])
    }
}

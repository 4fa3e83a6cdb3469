//! parry3d: a mesh of triangles.

use parry3d::math::Vector;
use parry3d::query::Ray;
use parry3d::shape::{CompositeShapeRef, TriMesh};

use super::Tree;
use crate::peers::finite_t_max;
use crate::workload::{self, Triangle};

/// Its mesh, in which no vertex is shared.
pub struct Mesh(TriMesh);

impl Tree for Mesh {
    /// With the largest t.
    type Ray = (Ray, f32);

    fn build(triangles: &[Triangle]) -> Self {
        let vector = |v: glam::Vec3| Vector::from_array(v.to_array());
        let vertices = triangles.iter().flat_map(|one| [one.a, one.b, one.c].map(vector)).collect();
        let corners = |index: u32| [3 * index, 3 * index + 1, 3 * index + 2];
        let indices = (0..triangles.len() as u32).map(corners).collect();
        match TriMesh::new(vertices, indices) {
            Ok(mesh) => Mesh(mesh),
            Err(error) => panic!("parry3d refuses a mesh that is not empty: {error}"),
        }
    }

    fn ray(ray: &workload::Ray) -> (Ray, f32) {
        let vector = |v: glam::Vec3| Vector::from_array(v.to_array());
        (Ray::new(vector(ray.origin), vector(ray.direction)), finite_t_max(ray))
    }

    fn nearest(&self, (ray, t_max): &(Ray, f32)) -> Option<(u32, f32)> {
        let (triangle, t) = CompositeShapeRef(&self.0).cast_local_ray(ray, *t_max, true)?;
        Some((triangle, t))
    }
}

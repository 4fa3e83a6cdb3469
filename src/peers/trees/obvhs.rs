//! obvhs: a binary hierarchy, and one of eight compressed children.

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray, RayHit};
use obvhs::rt_triangle::RtTriangle;
use std::time::Duration;

use super::Tree;
use crate::peers::finite_t_max;
use crate::workload::{self, Triangle};

/// Two children to a node.
pub struct Two {
    tree: Bvh2,
    triangles: Vec<RtTriangle>,
}

/// Eight compressed children to a node.
pub struct Eight {
    tree: CwBvh,
    triangles: Vec<RtTriangle>,
}

fn its(triangles: &[Triangle]) -> Vec<obvhs::triangle::Triangle> {
    let one = |one: &Triangle| {
        let [v0, v1, v2] = [one.a, one.b, one.c].map(Vec3A::from);
        obvhs::triangle::Triangle { v0, v1, v2 }
    };
    triangles.iter().map(one).collect()
}

/// As its documentation advises: triangles in the order of the tree.
fn in_order(triangles: &[obvhs::triangle::Triangle], indices: &[u32]) -> Vec<RtTriangle> {
    indices.iter().map(|index| (&triangles[*index as usize]).into()).collect()
}

fn ray(ray: &workload::Ray) -> Ray {
    Ray::new(ray.origin.into(), ray.direction.into(), ray.t_min.max(0.0), finite_t_max(ray))
}

/// Its walks do not say whether there was a hit; the index does.
fn found(hit: &RayHit, indices: &[u32]) -> Option<(u32, f32)> {
    indices.get(hit.primitive_id as usize).map(|index| (*index, hit.t))
}

impl Tree for Two {
    type Ray = Ray;

    fn build(triangles: &[Triangle]) -> Self {
        let its = its(triangles);
        let tree =
            build_bvh2_from_tris(&its, BvhBuildParams::medium_build(), &mut Duration::default());
        Two { triangles: in_order(&its, &tree.primitive_indices), tree }
    }

    fn ray(drawn: &workload::Ray) -> Ray {
        ray(drawn)
    }

    fn nearest(&self, ray: &Ray) -> Option<(u32, f32)> {
        let mut hit = RayHit::none();
        self.tree.ray_traverse(*ray, &mut hit, |ray, place| self.triangles[place].intersect(ray));
        found(&hit, &self.tree.primitive_indices)
    }
}

impl Tree for Eight {
    type Ray = Ray;

    fn build(triangles: &[Triangle]) -> Self {
        let its = its(triangles);
        let wanted = BvhBuildParams::medium_build();
        let tree = build_cwbvh_from_tris(&its, wanted, &mut Duration::default());
        Eight { triangles: in_order(&its, &tree.primitive_indices), tree }
    }

    fn ray(drawn: &workload::Ray) -> Ray {
        ray(drawn)
    }

    fn nearest(&self, ray: &Ray) -> Option<(u32, f32)> {
        let mut hit = RayHit::none();
        self.tree.ray_traverse(*ray, &mut hit, |ray, place| self.triangles[place].intersect(ray));
        found(&hit, &self.tree.primitive_indices)
    }
}

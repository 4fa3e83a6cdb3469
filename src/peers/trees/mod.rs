//! The hierarchies of other crates, each searched by the crate's own walk with its own test: what our fast
//! path is measured against. One file a crate.

mod bvh;
mod obvhs;
mod parry;
mod tree_job;

pub use tree_job::TreeJob;

use crate::job::Job;
use crate::workload::{Ray, Triangle};

/// A hierarchy of another crate.
pub trait Tree: 'static {
    /// Its ray, with the bounds of t that it takes.
    type Ray: Copy + 'static;
    /// Over triangles, of which there is at least one; all are finite.
    fn build(triangles: &[Triangle]) -> Self;
    /// Its ray from a drawn one.
    fn ray(ray: &Ray) -> Self::Ray;
    /// Index and distance of the nearest triangle that the ray hits.
    fn nearest(&self, ray: &Self::Ray) -> Option<(u32, f32)>;
}

/// A hierarchy of another crate, to be timed.
#[derive(Clone, Copy, Debug)]
pub struct TreeForm {
    /// Its name in columns.
    pub id: &'static str,
    /// What is called, and where its conventions differ from ours.
    pub source: &'static str,
    /// Makes a job of the nearest hits of rays among triangles.
    pub bind: fn(&[Triangle], &[Ray]) -> Box<dyn Job>,
}

/// All of them.
pub const TREES: [TreeForm; 4] = [
    TreeForm {
        id: "peer-obvhs-bvh2",
        source: "crate obvhs 0.4.0, medium_build; Bvh2::ray_traverse with RtTriangle::intersect, in the \
                 order of the tree",
        bind: bind::<obvhs::Two>,
    },
    TreeForm {
        id: "peer-obvhs-cwbvh",
        source: "crate obvhs 0.4.0, medium_build; CwBvh::ray_traverse with RtTriangle::intersect, in the \
                 order of the tree; boxes nearer than 0.0001 are left out",
        bind: bind::<obvhs::Eight>,
    },
    TreeForm {
        id: "peer-bvh",
        source: "crate bvh 0.13.0, Bvh::nearest_traverse_iterator until a box begins behind the best hit of \
                 Ray::intersects_triangle; front faces only",
        bind: bind::<bvh::Binary>,
    },
    TreeForm {
        id: "peer-parry",
        source: "crate parry3d 0.31.1, CompositeShapeRef::cast_local_ray of a TriMesh",
        bind: bind::<parry::Mesh>,
    },
];

fn bind<T: Tree>(triangles: &[Triangle], rays: &[Ray]) -> Box<dyn Job> {
    Box::new(TreeJob::<T>::new(triangles, rays))
}

//! A hierarchy that the crate `obvhs` builds: by merging neighbours (PLOC; Meister and Bittner, "Parallel
//! Locally-Ordered Clustering", 2018), bettered by reinsertion.

use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::builder::build_bvh2;
use std::time::Duration;

use super::placed::{Placed, placed};
use super::topology::{Branch, Topology};
use super::volume::Bounds;
use crate::workload::Triangle;

/// The same box.
pub fn aabb(bounds: &Bounds) -> Aabb {
    Aabb::new(bounds.low.into(), bounds.high.into())
}

/// A binary tree with one triangle to a leaf: merging them is for those to decide who know what a test
/// costs.
pub fn from_obvhs(triangles: &[Triangle]) -> Topology {
    let placed: Vec<Placed> = placed(triangles);
    let boxes: Vec<Aabb> = placed.iter().map(|one| aabb(&one.bounds)).collect();
    if boxes.is_empty() {
        return Topology::default();
    }
    let wanted = BvhBuildParams { max_prims_per_leaf: 1, ..BvhBuildParams::medium_build() };
    let tree = build_bvh2(&boxes, wanted, &mut Duration::default());
    let branch = |node: &obvhs::bvh2::node::Bvh2Node| {
        let (first, count) = (node.first_index as usize, node.prim_count as usize);
        if node.is_leaf() {
            let indices = &tree.primitive_indices[first..first + count];
            Branch::Leaf(indices.iter().map(|index| placed[*index as usize].triangle).collect())
        } else {
            Branch::Inner(vec![first, first + 1])
        }
    };
    Topology::new(tree.nodes.iter().map(branch).collect(), 0)
}

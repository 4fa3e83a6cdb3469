//! A hierarchy that the crate `obvhs` builds: by merging neighbours (PLOC; Meister and Bittner, "Parallel
//! Locally-Ordered Clustering", 2018), bettered by reinsertion.

use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;

use super::placed::{Placed, around, placed};
use super::topology::{Branch, Topology};
use super::volume::Bounds;
use crate::workload::Triangle;

/// A binary tree with one triangle to a leaf: merging them is for those to decide who know what a test
/// costs.
pub fn from_obvhs(triangles: &[Triangle]) -> Topology {
    let placed: Vec<Placed> = placed(triangles);
    if placed.is_empty() {
        return Topology::default();
    }
    let tree = built(&placed, scale(&around(&placed)));
    let branch = |node: &Bvh2Node| {
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

/// The power of two that makes the largest coordinate a number between 1/2 and 2: the crate works with
/// surfaces in f32, which overflow beyond 10^19 and are zero below 10^-23.
pub fn scale(bounds: &Bounds) -> f64 {
    let largest =
        bounds.low.iter().chain(&bounds.high).fold(0.0, |largest: f32, x| largest.max(x.abs()));
    if largest == 0.0 {
        return 1.0;
    }
    // The exponent is between -149 and 127.
    (-f64::from(largest).log2().floor()).exp2()
}

/// The crate's tree over boxes of that scale, as its `medium_build` makes it; of at least one.
pub fn built(placed: &[Placed], scale: f64) -> Bvh2 {
    let boxes: Vec<Aabb> = placed.iter().map(|one| scaled(&one.bounds, scale)).collect();
    let indices = (0..boxes.len() as u32).collect();
    let wanted = BvhBuildParams::medium_build();
    let mut tree = PlocBuilder::with_capacity(boxes.len()).build(
        wanted.ploc_search_distance,
        &boxes,
        indices,
        wanted.sort_precision,
        wanted.search_depth_threshold,
    );
    ReinsertionOptimizer::default().run(&mut tree, wanted.reinsertion_batch_ratio, None);
    tree
}

/// The box of that scale, rounded outwards where a number becomes subnormal.
fn scaled(bounds: &Bounds, scale: f64) -> Aabb {
    let moved = |x: f32, outwards: fn(f32) -> f32| {
        let exact = f64::from(x) * scale;
        let rounded = exact as f32;
        if f64::from(rounded) == exact { rounded } else { outwards(rounded) }
    };
    let low = bounds.low.map(|x| moved(x, f32::next_down));
    let high = bounds.high.map(|x| moved(x, f32::next_up));
    Aabb::new(low.into(), high.into())
}

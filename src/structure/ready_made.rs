//! A hierarchy that the crate `obvhs` builds: by merging neighbours (PLOC; Meister and Bittner, "Parallel
//! Locally-Ordered Clustering", 2018), bettered by reinsertion.

use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;

use super::placed::{Placed, around, placed};
use super::topology::{Branch, Topology};
use super::volume::Bounds;
use crate::workload::Triangle;

/// A binary tree with one triangle to a leaf, or some of those that share a box: merging them is for those
/// to decide who know what a test costs.
pub fn from_obvhs(triangles: &[Triangle]) -> Topology {
    let placed: Vec<Placed> = placed(triangles);
    if placed.is_empty() {
        return Topology::default();
    }
    let distinct = Distinct::of(&placed, scale(&around(&placed)));
    let tree = distinct.tree();
    let (mut nodes, mut more) = (Vec::with_capacity(tree.nodes.len()), Vec::new());
    for node in &tree.nodes {
        let first = node.first_index as usize;
        nodes.push(if node.is_leaf() {
            let together = distinct.triangles(tree.primitive_indices[first] as usize);
            halved(together, tree.nodes.len(), &mut more)
        } else {
            Branch::Inner(vec![first, first + 1])
        });
    }
    nodes.append(&mut more);
    Topology::new(nodes, 0)
}

/// A leaf, or a tree of leaves of a few triangles, whose nodes come behind `begin` others.
fn halved(triangles: &[u32], begin: usize, more: &mut Vec<Branch>) -> Branch {
    if triangles.len() <= TOGETHER {
        return Branch::Leaf(triangles.to_vec());
    }
    let halves = triangles.split_at(triangles.len() / 2);
    let children = [halves.0, halves.1].map(|half| {
        let branch = halved(half, begin, more);
        more.push(branch);
        begin + more.len() - 1
    });
    Branch::Inner(children.to_vec())
}

/// Triangles of a leaf that share a box.
const TOGETHER: usize = 4;

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

/// Boxes as the crate takes them, each once. It merges two when each is the other's best neighbour, so that
/// many copies of a box, all equally good, would make a chain, in quadratic time. So would boxes without a
/// surface: all are made a little larger.
pub struct Distinct {
    boxes: Vec<Aabb>,
    /// Where the triangles of a box begin; one more than there are boxes.
    starts: Vec<usize>,
    triangles: Vec<u32>,
}

/// How much larger, in the units of the scale.
const PADDING: f64 = 1.0 / (1u64 << 20) as f64;

impl Distinct {
    /// Of that scale.
    pub fn of(placed: &[Placed], scale: f64) -> Self {
        let key = |one: &Placed| {
            let low = one.bounds.low.map(|x| (f64::from(x) * scale - PADDING) as f32);
            let high = one.bounds.high.map(|x| (f64::from(x) * scale + PADDING) as f32);
            ([low, high].map(|corner| corner.map(f32::to_bits)), one.triangle)
        };
        let mut keys: Vec<_> = placed.iter().map(key).collect();
        keys.sort_unstable();
        let mut distinct =
            Distinct { boxes: Vec::new(), starts: Vec::new(), triangles: Vec::new() };
        let mut last = None;
        for (corners, triangle) in keys {
            if last != Some(corners) {
                last = Some(corners);
                let [low, high] = corners.map(|corner| corner.map(f32::from_bits));
                distinct.boxes.push(Aabb::new(low.into(), high.into()));
                distinct.starts.push(distinct.triangles.len());
            }
            distinct.triangles.push(triangle);
        }
        distinct.starts.push(distinct.triangles.len());
        distinct
    }

    /// The triangles of a box.
    pub fn triangles(&self, index: usize) -> &[u32] {
        &self.triangles[self.starts[index]..self.starts[index + 1]]
    }

    /// The crate's tree, as its `medium_build` makes it; of at least one box. One box to a leaf.
    pub fn tree(&self) -> Bvh2 {
        let indices = (0..self.boxes.len() as u32).collect();
        let wanted = BvhBuildParams::medium_build();
        let mut tree = PlocBuilder::with_capacity(self.boxes.len()).build(
            wanted.ploc_search_distance,
            &self.boxes,
            indices,
            wanted.sort_precision,
            wanted.search_depth_threshold,
        );
        ReinsertionOptimizer::default().run(&mut tree, wanted.reinsertion_batch_ratio, None);
        tree
    }
}

//! Building by insertion, one object after the other ("Inkrementalni konstrukce" of the lecture; Goldsmith
//! and Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing", 1987). An object that has come
//! to a volume stays there on its own, or shares a new volume with one that does, or goes on into a volume
//! that is there already: whichever adds least to the expected number of tests. The tree depends on the
//! order of insertion.

use super::placed::{Placed, placed};
use super::topology::{Branch, Topology};
use super::volume::Bounds;
use crate::workload::Triangle;

/// Children of a volume, at most. Without it, objects of no extent, which add nothing, would all be
/// children of one volume.
const MOST_CHILDREN: usize = 8;

/// A tree with one triangle to a leaf. `order` holds the indices in the order of insertion; triangles that
/// are not in it are left out.
pub fn inserted(triangles: &[Triangle], order: &[u32]) -> Topology {
    let mut place: Vec<Option<Placed>> = vec![None; triangles.len()];
    for one in placed(triangles) {
        place[one.triangle as usize] = Some(one);
    }
    let mut tree = Tree { nodes: Vec::new() };
    for one in order.iter().filter_map(|index| place.get(*index as usize).copied().flatten()) {
        tree.insert(one);
    }
    let branch = |node: Node| match node.triangle {
        Some(triangle) => Branch::Leaf(vec![triangle]),
        None => Branch::Inner(node.children),
    };
    Topology::new(tree.nodes.into_iter().map(branch).collect(), 0)
}

struct Node {
    bounds: Bounds,
    children: Vec<usize>,
    triangle: Option<u32>,
}

/// The root is the first node, and never a leaf.
struct Tree {
    nodes: Vec<Node>,
}

/// What becomes of an object in a volume.
#[derive(Clone, Copy)]
enum Choice {
    Alone,
    With(usize),
    Into(usize),
}

impl Tree {
    fn insert(&mut self, one: Placed) {
        if self.nodes.is_empty() {
            self.nodes.push(Node { bounds: one.bounds, children: Vec::new(), triangle: None });
        }
        let mut node = 0;
        loop {
            let bounds = self.nodes[node].bounds.joined(&one.bounds);
            self.nodes[node].bounds = bounds;
            match self.choice(node, &one.bounds) {
                Choice::Alone => {
                    let leaf = self.leaf(one);
                    self.nodes[node].children.push(leaf);
                    return;
                }
                Choice::With(child) => {
                    let leaf = self.leaf(one);
                    let other = self.nodes[node].children[child];
                    let bounds = self.nodes[other].bounds.joined(&one.bounds);
                    self.nodes[node].children[child] = self.nodes.len();
                    self.nodes.push(Node { bounds, children: vec![other, leaf], triangle: None });
                    return;
                }
                Choice::Into(child) => node = self.nodes[node].children[child],
            }
        }
    }

    fn leaf(&mut self, one: Placed) -> usize {
        let Placed { triangle, bounds } = one;
        self.nodes.push(Node { bounds, children: Vec::new(), triangle: Some(triangle) });
        self.nodes.len() - 1
    }

    /// The expected number of tests is the sum over volumes of their surface times their number of
    /// children. On its own, an object adds its volume's surface; with another, a volume of two. Going
    /// into a volume adds its growth for each child in it, and at the least what two objects of the size
    /// of this one would. Of choices that cost the same, the first is taken.
    fn choice(&self, node: usize, bounds: &Bounds) -> Choice {
        let Node { bounds: own, children, .. } = &self.nodes[node];
        let least = 2.0 * bounds.area();
        let may_stay = children.len() < MOST_CHILDREN;
        let mut best = (if may_stay { own.area() } else { f64::INFINITY }, Choice::Alone);
        for (place, child) in children.iter().map(|child| &self.nodes[*child]).enumerate() {
            let area = child.bounds.joined(bounds).area();
            let (cost, choice) = match child.triangle {
                Some(_) => (2.0 * area, Choice::With(place)),
                None => {
                    let growth = area - child.bounds.area();
                    (growth * child.children.len() as f64 + least, Choice::Into(place))
                }
            };
            if cost < best.0 {
                best = (cost, choice);
            }
        }
        best.1
    }
}

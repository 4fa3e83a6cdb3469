//! From a binary tree to a wide one.

use super::tree::{LEAF, NOBODY, Node, Wide};
use crate::structure::placed::{around, placed};
use crate::structure::topology::{Branch, Topology};
use crate::structure::volume::Bounds;
use crate::workload::Triangle;

/// How far planes are moved outwards, in parts of the scene: see the module's text.
const OUTWARDS: f64 = 1.0 / 32_768.0;

/// A binary tree with what is known of each node.
struct Measured<'a> {
    topology: &'a Topology,
    bounds: Vec<Bounds>,
    counts: Vec<usize>,
}

impl<'a> Measured<'a> {
    fn of(topology: &'a Topology, triangles: &[Triangle]) -> Self {
        let nodes = topology.len();
        let mut measured =
            Measured { topology, bounds: vec![Bounds::NOTHING; nodes], counts: vec![0; nodes] };
        for node in topology.children_first() {
            match topology.branch(node) {
                Branch::Leaf(indices) => {
                    let boxes = indices.iter().filter_map(|i| Bounds::of(&triangles[*i as usize]));
                    measured.bounds[node] =
                        boxes.fold(Bounds::NOTHING, |bounds, one| bounds.joined(&one));
                    measured.counts[node] = indices.len();
                }
                Branch::Inner(children) => {
                    for child in children {
                        let bounds = measured.bounds[node].joined(&measured.bounds[*child]);
                        measured.bounds[node] = bounds;
                        measured.counts[node] += measured.counts[*child];
                    }
                }
            }
        }
        measured
    }

    /// The children of a wide node: the largest that is no leaf is replaced by its own children, while
    /// there are places.
    fn opened<const W: usize>(&self, node: usize) -> Vec<usize> {
        let mut open = vec![node];
        loop {
            let may_open = |child: &&usize| self.counts[**child] > W;
            let largest = open.iter().filter(may_open).max_by(|a, b| {
                self.bounds[**a].area().total_cmp(&self.bounds[**b].area()).then(b.cmp(a))
            });
            let Some(&largest) = largest else { return open };
            let Branch::Inner(children) = self.topology.branch(largest) else { return open };
            if open.len() - 1 + children.len() > W {
                return open;
            }
            open.retain(|child| *child != largest);
            open.extend(children);
        }
    }

    /// The triangles below a node.
    fn below<const W: usize>(&self, node: usize) -> [u32; W] {
        let mut group = [NOBODY; W];
        let leaves = self.topology.leaves_below(node);
        for (place, index) in group.iter_mut().zip(leaves.into_iter().flatten()) {
            *place = *index;
        }
        group
    }
}

impl<const W: usize> Wide<W> {
    /// Of a tree whose leaves have no more than `W` triangles, and whose nodes have two children.
    pub fn new(triangles: &[Triangle], topology: &Topology) -> Self {
        let bounds = around(&placed(triangles));
        let mut wide = Wide { nodes: Vec::new(), groups: Vec::new(), middle: [0.0; 3], reach: 0.0 };
        let Some(root) = topology.root() else { return wide };
        wide.middle = [0, 1, 2].map(|axis| (0.5 * bounds.doubled_middle(axis)) as f32);
        let reach = |axis: usize| {
            let away = |place: f32| (f64::from(place) - f64::from(wide.middle[axis])).abs();
            away(bounds.low[axis]).max(away(bounds.high[axis]))
        };
        let reach = reach(0).max(reach(1)).max(reach(2));
        // Moved outwards and rounded twice, they reach a little farther.
        wide.reach = (reach * (1.0 + 2.0 * OUTWARDS)) as f32;
        let measured = Measured::of(topology, triangles);
        wide.nodes.push(Node::EMPTY);
        let mut stack = vec![(root, 0)];
        while let Some((branch, node)) = stack.pop() {
            let children = measured.opened::<W>(branch);
            for (place, child) in children.into_iter().enumerate() {
                let is_leaf = measured.counts[child] <= W;
                let index = if is_leaf { wide.groups.len() } else { wide.nodes.len() };
                if is_leaf {
                    wide.groups.push(measured.below::<W>(child));
                } else {
                    wide.nodes.push(Node::EMPTY);
                    stack.push((child, index));
                }
                let code = index as u32 | if is_leaf { LEAF } else { 0 };
                wide.put(node, place, &measured.bounds[child], reach, code);
            }
        }
        wide
    }

    /// Writes a child into a node.
    fn put(&mut self, node: usize, place: usize, bounds: &Bounds, reach: f64, code: u32) {
        let node = &mut self.nodes[node];
        node.children[place] = code;
        for axis in 0..3 {
            let moved = |plane: f32, by: f64| {
                (f64::from(plane) - f64::from(self.middle[axis]) + by * OUTWARDS * reach) as f32
            };
            // Rounding to the nearest is less than a step.
            node.planes[2 * axis][place] = moved(bounds.low[axis], -1.0).next_down();
            node.planes[2 * axis + 1][place] = moved(bounds.high[axis], 1.0).next_up();
        }
    }
}

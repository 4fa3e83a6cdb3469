//! A hierarchy of volumes: whoever misses a volume misses what is in it. One walk for all builders and
//! volumes, so that they differ in nothing else.

use super::placed::points;
use super::search::{Visit, farthest_first};
use super::topology::{Branch, Topology};
use super::volume::Volume;
use super::{Beam, Search, Structure};
use crate::workload::Triangle;

/// A tree of volumes; the root is the first node.
#[derive(Clone, Debug)]
pub struct Hierarchy<V> {
    nodes: Vec<Node<V>>,
    indices: Vec<u32>,
}

/// Children, or triangles, lie in a row.
#[derive(Clone, Copy, Debug)]
struct Node<V> {
    volume: V,
    first: u32,
    count: u32,
    is_leaf: bool,
}

/// How often lines met a volume and one in it: to compare with their surfaces, where volumes lie within
/// their parents, as boxes do.
#[derive(Clone, Copy, Debug)]
pub struct Chance<V> {
    /// Around it.
    pub parent: V,
    /// In it.
    pub child: V,
    /// Lines that met the parent.
    pub parent_met: u64,
    /// Those of them that met the child.
    pub child_met: u64,
}

/// A node without its volume.
struct Shape {
    first: u32,
    count: u32,
    is_leaf: bool,
    /// Of its triangles.
    range: [usize; 2],
}

/// Lays nodes out so that children lie in a row behind their parent, and triangles of a subtree in a row.
fn laid_out(topology: &Topology) -> (Vec<Shape>, Vec<u32>) {
    let mut shapes: Vec<Shape> = Vec::new();
    let mut indices = Vec::new();
    let place = || Shape { first: 0, count: 0, is_leaf: false, range: [usize::MAX, 0] };
    let mut stack: Vec<(usize, usize)> =
        topology.root().map(|root| (root, 0)).into_iter().collect();
    shapes.extend(stack.iter().map(|_| place()));
    while let Some((branch, slot)) = stack.pop() {
        match topology.branch(branch) {
            Branch::Leaf(triangles) => {
                let (first, count) = (indices.len(), triangles.len());
                indices.extend_from_slice(triangles);
                let range = [first, first + count];
                let (first, count) = (first as u32, count as u32);
                shapes[slot] = Shape { first, count, is_leaf: true, range };
            }
            Branch::Inner(children) => {
                let (first, count) = (shapes.len(), children.len());
                shapes.extend(children.iter().map(|_| place()));
                stack.extend(children.iter().copied().zip(first..first + count).rev());
                shapes[slot].first = first as u32;
                shapes[slot].count = count as u32;
            }
        }
    }
    for slot in (0..shapes.len()).rev() {
        if !shapes[slot].is_leaf {
            let (first, count) = (shapes[slot].first as usize, shapes[slot].count as usize);
            let children = &shapes[first..first + count];
            let low = children.iter().map(|child| child.range[0]).min();
            let high = children.iter().map(|child| child.range[1]).max();
            shapes[slot].range = [low.unwrap_or(0), high.unwrap_or(0)];
        }
    }
    (shapes, indices)
}

impl<V: Volume> Hierarchy<V> {
    /// A volume around what is below each node.
    pub fn new(triangles: &[Triangle], topology: &Topology) -> Self {
        let (shapes, indices) = laid_out(topology);
        let node = |shape: &Shape| {
            let below = &indices[shape.range[0]..shape.range[1]];
            let volume = V::around(&points(triangles, below));
            Node { volume, first: shape.first, count: shape.count, is_leaf: shape.is_leaf }
        };
        let nodes = shapes.iter().map(node).collect();
        Hierarchy { nodes, indices }
    }

    /// How often the rays meet each volume, whatever they hit, and the volume around it.
    pub fn chances(&self, beams: &[Beam]) -> Vec<Chance<V>> {
        let mut met = vec![0u64; self.nodes.len()];
        let mut stack = Vec::new();
        for beam in beams {
            let aim = V::aim(beam);
            stack.extend((!self.nodes.is_empty()).then_some(0));
            while let Some(index) = stack.pop() {
                let node: &Node<V> = &self.nodes[index];
                if node.volume.crossing(beam, &aim).is_some() {
                    met[index] += 1;
                    if !node.is_leaf {
                        stack.extend(node.first as usize..(node.first + node.count) as usize);
                    }
                }
            }
        }
        let mut chances = Vec::new();
        for (parent, parent_met) in self.nodes.iter().zip(&met).filter(|(node, _)| !node.is_leaf) {
            let children = parent.first as usize..(parent.first + parent.count) as usize;
            for (child, child_met) in self.nodes[children.clone()].iter().zip(&met[children]) {
                chances.push(Chance {
                    parent: parent.volume,
                    child: child.volume,
                    parent_met: *parent_met,
                    child_met: *child_met,
                });
            }
        }
        chances
    }
}

impl<V: Volume> Structure for Hierarchy<V> {
    fn walk(&self, beam: &Beam, search: &mut Search) {
        let Some(root) = self.nodes.first() else { return };
        let aim = V::aim(beam);
        let mut stack = search.take_stack();
        let near = search.enter(&root.volume, beam, &aim);
        stack.extend(near.map(|near| Visit { near, far: 0.0, node: 0 }));
        while let Some(Visit { near, node, .. }) = stack.pop() {
            if near > search.bound() {
                continue;
            }
            search.open();
            let node = &self.nodes[node as usize];
            let (first, count) = (node.first as usize, node.count as usize);
            if node.is_leaf {
                if search.test(&self.indices[first..first + count]) {
                    break;
                }
                continue;
            }
            let begin = stack.len();
            for (node, child) in (node.first..).zip(&self.nodes[first..first + count]) {
                if let Some(near) = search.enter(&child.volume, beam, &aim) {
                    stack.push(Visit { near, far: 0.0, node });
                }
            }
            farthest_first(&mut stack[begin..]);
        }
        search.give_back(stack);
    }

    fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.indices.as_slice())
    }
}

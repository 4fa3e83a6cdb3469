//! The compressed wide hierarchy of the crate `obvhs` (CWBVH: Ylitie, Karras, Laine, "Efficient Incoherent
//! Ray Traversal on GPUs Through Compressed Wide BVHs", 2017): eight children to a node, their boxes in
//! steps of a power of two, a byte a plane. Walked by us: the crate's own walk skips what is nearer than
//! 0.0001, and replaces small components of a direction.

use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::bvh2_to_cwbvh::bvh2_to_cwbvh;
use obvhs::cwbvh::node::CwBvhNode;

use super::beam::WIDER;
use super::placed::{Placed, around, placed};
use super::ready_made::{Distinct, scale};
use super::search::{Search, Visit, farthest_first};
use super::{Beam, Structure};
use crate::workload::Triangle;

/// A node's boxes are taken so much larger on every side, in steps. The crate rounds them outwards, but
/// from differences in f32, which err by 2^-24 of up to 256 steps; and the step is found by a logarithm in
/// f32, below 128 in magnitude and with at most two units in the last place, 2^-16, of error, so that what
/// lies behind the last step is cut off by up to 255 * 2^-16 * ln 2 = 0.003 steps.
const MARGIN: f64 = 1.0 / 64.0;

/// Nodes of eight, and the triangle at every place.
pub struct Compressed {
    nodes: Vec<CwBvhNode>,
    /// Where the triangles of each place of a leaf begin.
    starts: Vec<u32>,
    indices: Vec<u32>,
    /// A power of two: boxes are of this scale.
    scale: f64,
}

/// Boxes of a leaf, at most.
const MOST_BOXES: u32 = 3;

impl Compressed {
    /// Of leaves with up to three boxes, as the format allows; a triangle has one, or shares it.
    pub fn new(triangles: &[Triangle]) -> Self {
        let placed: Vec<Placed> = placed(triangles);
        let mut compressed =
            Compressed { nodes: Vec::new(), starts: Vec::new(), indices: Vec::new(), scale: 1.0 };
        if placed.is_empty() {
            return compressed;
        }
        compressed.scale = scale(&around(&placed));
        let distinct = Distinct::of(&placed, compressed.scale);
        let CwBvh { nodes, primitive_indices, .. } =
            bvh2_to_cwbvh(&distinct.tree(), MOST_BOXES, true, false);
        compressed.nodes = nodes;
        for index in primitive_indices {
            compressed.starts.push(compressed.indices.len() as u32);
            compressed.indices.extend(distinct.triangles(index as usize));
        }
        compressed.starts.push(compressed.indices.len() as u32);
        compressed
    }
}

/// A node as a ray sees it: where planes of steps are met is linear in the step.
struct Steps<'a> {
    /// Lower and upper steps of the children, by axis, the one that the ray meets first in front.
    planes: [[&'a [u8; 8]; 2]; 3],
    place: [f64; 3],
    step: [f64; 3],
    /// Outwards, of the planes that are met first.
    out: [f64; 3],
}

impl<'a> Steps<'a> {
    fn of(node: &'a CwBvhNode, beam: &Beam) -> Self {
        let planes = [
            [&node.child_min_x, &node.child_max_x],
            [&node.child_min_y, &node.child_max_y],
            [&node.child_min_z, &node.child_max_z],
        ];
        let mut steps = Steps {
            planes,
            place: node.p.to_array().map(f64::from),
            step: node.compute_extent().to_array().map(f64::from),
            out: [-MARGIN; 3],
        };
        for axis in 0..3 {
            if beam.is_backward[axis] {
                steps.planes[axis].reverse();
                steps.out[axis] = MARGIN;
            }
        }
        steps
    }

    /// As the test of [`super::volume::Bounds`].
    fn enter(&self, beam: &Beam, child: usize, bound: f64) -> Option<f64> {
        let (mut near, mut far) = (beam.t_min, beam.t_max.min(bound));
        for axis in 0..3 {
            let [first, last] = self.planes[axis].map(|steps| f64::from(steps[child]));
            let at = |steps: f64| beam.at(axis, self.place[axis] + steps * self.step[axis]);
            let (enters, leaves) = (at(first + self.out[axis]), at(last - self.out[axis]));
            near = if enters > near { enters } else { near };
            far = if leaves < far { leaves } else { far };
        }
        let near = near * (1.0 - WIDER);
        (near <= far * (1.0 + WIDER)).then_some(near)
    }
}

impl Structure for Compressed {
    fn walk(&self, beam: &Beam, search: &mut Search) {
        if self.nodes.is_empty() {
            return;
        }
        let beam = &beam.scaled(self.scale);
        let mut stack = search.take_stack();
        // Of a leaf: `node` is its first place, `far` the number of its places.
        stack.push(Visit { near: beam.t_min, far: 0.0, node: 0 });
        while let Some(Visit { near, far, node }) = stack.pop() {
            if near > search.bound() {
                continue;
            }
            if far > 0.0 {
                let places = node as usize..node as usize + far as usize;
                let (first, end) = (self.starts[places.start], self.starts[places.end]);
                if search.test(&self.indices[first as usize..end as usize]) {
                    break;
                }
                continue;
            }
            search.open();
            let node = &self.nodes[node as usize];
            let steps = Steps::of(node, beam);
            let begin = stack.len();
            for child in (0..8).filter(|child| !node.is_child_empty(*child)) {
                let met = search.enter_by(|bound| steps.enter(beam, child, bound));
                let Some(near) = met else { continue };
                stack.push(if node.is_leaf(child) {
                    let (first, count) = node.child_primitives(child);
                    Visit { near, far: f64::from(count), node: first }
                } else {
                    Visit { near, far: 0.0, node: node.child_node_index(child) }
                });
            }
            farthest_first(&mut stack[begin..]);
        }
        search.give_back(stack);
    }

    fn bytes(&self) -> usize {
        let lists = self.starts.len() + self.indices.len();
        size_of_val(self.nodes.as_slice()) + lists * size_of::<u32>()
    }
}

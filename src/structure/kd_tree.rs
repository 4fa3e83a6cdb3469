//! The kd-tree: space is halved by planes across the axes, where surface times number of triangles is
//! least (MacDonald and Booth, 1990). A triangle lies in every cell that its box touches.
//!
//! A walk keeps the part of the ray that is in a cell and cuts it where the ray meets the plane, each part
//! a little longer than it is by [`WIDER`]: a point of the ray in a closed cell is in the cell's part.

use super::beam::WIDER;
use super::placed::{Placed, around, placed};
use super::search::{Search, Visit};
use super::volume::{Bounds, Volume};
use super::{Beam, Structure};
use crate::workload::Triangle;

/// Triangles of a cell that is not worth splitting.
const CELL: usize = 4;
/// Planes that are tried along each axis.
const PLANES: usize = 16;
/// What crossing a plane costs, in tests of a triangle.
const OPENING: f64 = 1.0;

/// A tree of planes; the root is the first node.
#[derive(Clone, Debug)]
pub struct KdTree {
    bounds: Bounds,
    nodes: Vec<Node>,
    indices: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
enum Node {
    /// Below the plane is child `first`, above it the next.
    Plane {
        axis: usize,
        place: f32,
        first: u32,
    },
    Cell {
        first: u32,
        count: u32,
    },
}

impl KdTree {
    /// As deep as 8 + 1.3 log2 of the number of triangles (Pharr and Humphreys), at most.
    pub fn new(triangles: &[Triangle]) -> Self {
        let placed = placed(triangles);
        let bounds = around(&placed);
        let deepest = 8 + (1.3 * (placed.len().max(1) as f64).log2()) as u32;
        let mut tree = KdTree { bounds, nodes: Vec::new(), indices: Vec::new() };
        if placed.is_empty() {
            return tree;
        }
        tree.nodes.push(Node::Cell { first: 0, count: 0 });
        let mut stack = vec![(0, bounds, placed, 0)];
        while let Some((node, bounds, placed, depth)) = stack.pop() {
            let plane = if depth < deepest { best_plane(&placed, &bounds) } else { None };
            let Some((axis, place)) = plane else {
                let (first, count) = (tree.indices.len() as u32, placed.len() as u32);
                tree.indices.extend(placed.iter().map(|one| one.triangle));
                tree.nodes[node] = Node::Cell { first, count };
                continue;
            };
            let first = tree.nodes.len();
            tree.nodes[node] = Node::Plane { axis, place, first: first as u32 };
            tree.nodes.extend([Node::Cell { first: 0, count: 0 }; 2]);
            let below = placed.iter().filter(|one| one.bounds.low[axis] <= place);
            let above = placed.iter().filter(|one| one.bounds.high[axis] >= place);
            let (below, above) = (below.copied().collect(), above.copied().collect());
            let (mut low, mut high) = (bounds, bounds);
            low.high[axis] = place;
            high.low[axis] = place;
            stack.push((first + 1, high, above, depth + 1));
            stack.push((first, low, below, depth + 1));
        }
        tree
    }
}

/// The plane that makes the least cost, if it is less than that of no plane.
fn best_plane(placed: &[Placed], bounds: &Bounds) -> Option<(usize, f32)> {
    if placed.len() <= CELL {
        return None;
    }
    let unsplit = placed.len() as f64 * bounds.area();
    let mut best: Option<(f64, usize, f32)> = None;
    for axis in 0..3 {
        for (place, below, above) in planes(placed, bounds, axis) {
            let (mut low, mut high) = (*bounds, *bounds);
            low.high[axis] = place;
            high.low[axis] = place;
            let cost = OPENING * bounds.area()
                + low.area() * f64::from(below)
                + high.area() * f64::from(above);
            if cost < best.map_or(unsplit, |best| best.0) {
                best = Some((cost, axis, place));
            }
        }
    }
    best.map(|(_, axis, place)| (axis, place))
}

/// Planes inside the cell, evenly apart, and how many triangles touch each side.
fn planes(placed: &[Placed], bounds: &Bounds, axis: usize) -> Vec<(f32, u32, u32)> {
    let (low, extent) = (f64::from(bounds.low[axis]), bounds.extent(axis));
    let place = |plane: usize| (low + extent * plane as f64 / PLANES as f64) as f32;
    let places: Vec<f32> = (1..PLANES).map(place).collect();
    // Those that begin or end between two planes: a place is never above the next.
    let (mut begins, mut ends) = ([0u32; PLANES], [0u32; PLANES]);
    for one in placed {
        begins[places.partition_point(|place| *place < one.bounds.low[axis])] += 1;
        ends[places.partition_point(|place| *place <= one.bounds.high[axis])] += 1;
    }
    let inside = |place: &f32| bounds.low[axis] < *place && *place < bounds.high[axis];
    let mut sides = Vec::new();
    let (mut below, mut ended) = (0, 0);
    for (plane, place) in places.iter().enumerate() {
        below += begins[plane];
        ended += ends[plane];
        if inside(place) {
            sides.push((*place, below, placed.len() as u32 - ended));
        }
    }
    sides
}

impl Structure for KdTree {
    fn walk(&self, beam: &Beam, search: &mut Search) {
        let Some(part) = self.bounds.crossing(beam, &()) else { return };
        let mut stack = search.take_stack();
        if !self.nodes.is_empty() {
            stack.push(Visit { near: part.near, far: part.far, node: 0 });
        }
        while let Some(Visit { mut near, mut far, node }) = stack.pop() {
            let mut node = node as usize;
            // Down to a cell, the nearer side first.
            let cell = loop {
                if near > search.bound() {
                    break None;
                }
                match self.nodes[node] {
                    Node::Cell { first, count } => {
                        break Some(first as usize..(first + count) as usize);
                    }
                    Node::Plane { axis, place, first } => {
                        search.open();
                        match Sides::of(beam, axis, place, first).parts(near, far) {
                            [Some(one), Some(other)] => {
                                stack.push(other);
                                (node, near, far) = (one.node as usize, one.near, one.far);
                            }
                            [Some(one), None] | [None, Some(one)] => {
                                (node, near, far) = (one.node as usize, one.near, one.far);
                            }
                            [None, None] => break None,
                        }
                    }
                }
            };
            if let Some(cell) = cell
                && search.test_once(&self.indices[cell])
            {
                break;
            }
        }
        search.give_back(stack);
    }

    fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.indices.as_slice())
    }
}

/// Both sides of a plane, in the order in which the ray sees them.
struct Sides {
    nodes: [u32; 2],
    /// Where the first side ends at the latest, and where the second begins at the earliest.
    cut: [f64; 2],
}

impl Sides {
    #[inline(always)]
    fn of(beam: &Beam, axis: usize, place: f32, first: u32) -> Self {
        let away = f64::from(place) - beam.origin[axis];
        if beam.direction[axis] == 0.0 {
            // On one side for ever; in the plane, either: what touches it is on both.
            let nodes = if away >= 0.0 { [first, first + 1] } else { [first + 1, first] };
            return Sides { nodes, cut: NEVER };
        }
        let t = beam.at(axis, place.into());
        let back = u32::from(beam.is_backward[axis]);
        // The sign of t is exact: behind the origin nothing is cut off but the first side.
        let slack = t.abs() * WIDER;
        Sides { nodes: [first + back, first + 1 - back], cut: [t + slack, t - slack] }
    }

    /// The parts of both sides that are not empty.
    #[inline(always)]
    fn parts(&self, near: f64, far: f64) -> [Option<Visit>; 2] {
        let (one_far, other_near) = (far.min(self.cut[0]), near.max(self.cut[1]));
        let one = Visit { near, far: one_far, node: self.nodes[0] };
        let other = Visit { near: other_near, far, node: self.nodes[1] };
        [(near <= one_far).then_some(one), (other_near <= far).then_some(other)]
    }
}

/// The second side is never reached.
const NEVER: [f64; 2] = [f64::INFINITY, f64::INFINITY];

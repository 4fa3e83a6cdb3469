//! The octree: a cell with many triangles is halved along all three axes (Glassner, "Space Subdivision for
//! Fast Ray Tracing", 1984). A triangle lies in every cell that its box touches. Cells are found by
//! descending, nearest child first, as the lecture's recursive walk does; Glassner's own way, to look for
//! the cell of a point in a hash table from the root at every step, visits the same cells.

use std::collections::VecDeque;

use super::placed::{Placed, around, placed};
use super::search::{Search, Visit, farthest_first};
use super::volume::{Bounds, Volume};
use super::{Beam, Structure};
use crate::workload::Triangle;

/// Triangles of a cell that is not worth splitting.
const CELL: usize = 8;
/// Levels beyond those that a full tree over a surface of as many triangles has.
const MORE_LEVELS: u32 = 4;
/// How often a triangle may be in a list, on average.
const MOST_COPIES: usize = 16;

/// A tree of cells; the root is the first node.
#[derive(Clone, Debug)]
pub struct Octree {
    bounds: Bounds,
    nodes: Vec<Node>,
    indices: Vec<u32>,
}

/// Of an inner node, eight children from `first` on; of a cell, its triangles.
#[derive(Clone, Copy, Debug)]
struct Node {
    first: u32,
    count: u32,
    is_cell: bool,
}

const EMPTY: Node = Node { first: 0, count: 0, is_cell: true };

/// A cube around a box, so that cells are cubes.
fn cube(bounds: &Bounds) -> Bounds {
    let longest = (0..3).map(|axis| bounds.extent(axis)).fold(0.0, f64::max);
    let mut cube = *bounds;
    for axis in 0..3 {
        let (middle, half) = (0.5 * bounds.doubled_middle(axis), 0.5 * longest);
        // Rounding must not cut off what is there, nor reach infinity.
        cube.low[axis] = cube.low[axis].min((middle - half) as f32).max(-f32::MAX);
        cube.high[axis] = cube.high[axis].max((middle + half) as f32).min(f32::MAX);
    }
    cube
}

/// The eighth `child` of a cell: bit `axis` says which half along an axis. Halves share their middle, so
/// that nothing is between them.
#[inline(always)]
fn eighth(bounds: &Bounds, child: u32) -> Bounds {
    let mut part = *bounds;
    for axis in 0..3 {
        let middle = (0.5 * bounds.doubled_middle(axis)) as f32;
        if child >> axis & 1 == 0 {
            part.high[axis] = middle;
        } else {
            part.low[axis] = middle;
        }
    }
    part
}

impl Octree {
    /// Cells are split in the order of their size (the lecture's queue of candidates), until the lists
    /// are `MOST_COPIES` times as long as that of all triangles. Four times as many triangles are one
    /// level more, as of a surface.
    pub fn new(triangles: &[Triangle]) -> Self {
        let placed = placed(triangles);
        let bounds = cube(&around(&placed));
        let deepest = MORE_LEVELS + placed.len().max(1).ilog2().div_ceil(2);
        let (most, mut held) = (MOST_COPIES * placed.len(), placed.len());
        let mut tree = Octree { bounds, nodes: Vec::new(), indices: Vec::new() };
        if placed.is_empty() {
            return tree;
        }
        tree.nodes.push(EMPTY);
        let mut queue = VecDeque::from([(0, bounds, placed, 0)]);
        while let Some((node, bounds, placed, depth)) = queue.pop_front() {
            let may_split = placed.len() > CELL && depth < deepest;
            let parts = if may_split { split(&placed, &bounds, most - held) } else { None };
            let Some(parts) = parts else {
                let (first, count) = (tree.indices.len() as u32, placed.len() as u32);
                tree.indices.extend(placed.iter().map(|one| one.triangle));
                tree.nodes[node] = Node { first, count, is_cell: true };
                continue;
            };
            held += parts.iter().map(Vec::len).sum::<usize>() - placed.len();
            let first = tree.nodes.len();
            tree.nodes.extend([EMPTY; 8]);
            tree.nodes[node] = Node { first: first as u32, count: 8, is_cell: false };
            for (child, part) in (0u32..).zip(parts) {
                queue.push_back((first + child as usize, eighth(&bounds, child), part, depth + 1));
            }
        }
        tree
    }
}

/// The triangles of each eighth; `None` where halving helps none of them, and where it makes more than
/// `spare` copies.
fn split(placed: &[Placed], bounds: &Bounds, spare: usize) -> Option<[Vec<Placed>; 8]> {
    let parts = [0, 1, 2, 3, 4, 5, 6, 7].map(|child| {
        let part = eighth(bounds, child);
        let touched = placed.iter().filter(|one| part.touches(&one.bounds));
        touched.copied().collect::<Vec<_>>()
    });
    let helps = parts.iter().any(|part| part.len() < placed.len());
    // Each is in one of them at least.
    let copies = parts.iter().map(Vec::len).sum::<usize>() - placed.len();
    // Where each is in most of the eighths, as around a vertex of many, another level only makes copies.
    (helps && copies <= spare && copies < 4 * placed.len()).then_some(parts)
}

/// A node on the stack, with its box, which is not stored.
#[derive(Clone, Copy)]
struct Cell {
    visit: Visit,
    bounds: Bounds,
}

impl Structure for Octree {
    fn walk(&self, beam: &Beam, search: &mut Search) {
        let Some(part) = self.bounds.crossing(beam, &()) else { return };
        if self.nodes.is_empty() {
            return;
        }
        let visit = Visit { near: part.near, far: part.far, node: 0 };
        let mut stack = vec![Cell { visit, bounds: self.bounds }];
        while let Some(Cell { visit, bounds }) = stack.pop() {
            if visit.near > search.bound() {
                continue;
            }
            let node = self.nodes[visit.node as usize];
            let (first, count) = (node.first as usize, node.count as usize);
            if node.is_cell {
                if search.test_once(&self.indices[first..first + count]) {
                    break;
                }
                continue;
            }
            search.open();
            push_children(beam, &bounds, node.first, &mut stack);
        }
    }

    fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.indices.as_slice())
    }
}

/// Those that the ray meets, the nearest last.
fn push_children(beam: &Beam, bounds: &Bounds, first: u32, stack: &mut Vec<Cell>) {
    let (mut met, mut count) = ([Visit { near: 0.0, far: 0.0, node: 0 }; 8], 0);
    for child in 0..8 {
        if let Some(part) = eighth(bounds, child).crossing(beam, &()) {
            met[count] = Visit { near: part.near, far: part.far, node: first + child };
            count += 1;
        }
    }
    farthest_first(&mut met[..count]);
    stack.extend(
        met[..count]
            .iter()
            .map(|visit| Cell { visit: *visit, bounds: eighth(bounds, visit.node - first) }),
    );
}

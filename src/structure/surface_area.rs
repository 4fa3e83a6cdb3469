//! Building from the top by surface area (Goldsmith and Salmon, 1987; MacDonald and Booth, 1990): a set is
//! split where surface times number of triangles, summed over both halves, is least, since a random line
//! that meets a convex volume meets one inside it with the ratio of their surfaces. Splits are looked for
//! between bins (Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", 2007).

use super::placed::{Placed, around, placed};
use super::topology::{Branch, Topology};
use super::volume::Bounds;
use crate::workload::Triangle;

/// Bins per axis.
const BINS: usize = 16;
/// Triangles of a leaf, at most.
const LEAF: usize = 4;
/// What opening a node costs, in tests of a triangle.
const OPENING: f64 = 1.0;

/// A tree whose leaves have at most four triangles.
pub fn by_surface_area(triangles: &[Triangle]) -> Topology {
    by_surface_area_of(placed(triangles), LEAF)
}

/// A tree whose leaves have at most `most` triangles.
pub fn by_surface_area_of(mut placed: Vec<Placed>, most: usize) -> Topology {
    if placed.is_empty() {
        return Topology::default();
    }
    let mut nodes = vec![Branch::Leaf(Vec::new())];
    let mut stack = vec![(0, 0, placed.len())];
    while let Some((node, begin, end)) = stack.pop() {
        let part = &mut placed[begin..end];
        match split(part, most) {
            Some(middle) => {
                let children = vec![nodes.len(), nodes.len() + 1];
                stack.push((children[1], begin + middle, end));
                stack.push((children[0], begin, begin + middle));
                nodes.extend([Branch::Leaf(Vec::new()), Branch::Leaf(Vec::new())]);
                nodes[node] = Branch::Inner(children);
            }
            None => nodes[node] = Branch::Leaf(part.iter().map(|one| one.triangle).collect()),
        }
    }
    Topology::new(nodes, 0)
}

/// Where a set is split: along an axis, below a bin.
struct Split {
    cost: f64,
    axis: usize,
    bin: usize,
}

/// Sorts the set into two and tells where the second begins; `None` where a leaf is cheaper.
fn split(part: &mut [Placed], most: usize) -> Option<usize> {
    let count = part.len();
    if count < 2 {
        return None;
    }
    let whole = around(part).area();
    let middles = Middles::of(part);
    let best = (0..3).filter_map(|axis| cheapest(part, &middles, axis));
    let best = best.min_by(|a, b| a.cost.total_cmp(&b.cost));
    let Some(best) = best else {
        // All middles are in one point.
        return (count > most).then_some(count / 2);
    };
    if count <= most && OPENING * whole + best.cost >= count as f64 * whole {
        return None;
    }
    let is_below = |one: &Placed| middles.bin(one, best.axis) < best.bin;
    // Stable, so that the tree is the same whatever sorts it.
    part.sort_by_key(|one| !is_below(one));
    Some(part.iter().filter(|one| is_below(one)).count())
}

/// Where the (doubled) middles of a set lie.
struct Middles {
    low: [f64; 3],
    high: [f64; 3],
}

impl Middles {
    fn of(part: &[Placed]) -> Self {
        let mut middles = Middles { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };
        for one in part {
            for axis in 0..3 {
                let middle = one.bounds.doubled_middle(axis);
                middles.low[axis] = middles.low[axis].min(middle);
                middles.high[axis] = middles.high[axis].max(middle);
            }
        }
        middles
    }

    #[inline(always)]
    fn bin(&self, one: &Placed, axis: usize) -> usize {
        let scale = BINS as f64 / (self.high[axis] - self.low[axis]);
        let place = (one.bounds.doubled_middle(axis) - self.low[axis]) * scale;
        (place as usize).min(BINS - 1)
    }
}

/// The cheapest split along an axis; `None` where all middles are at one place of it.
fn cheapest(part: &[Placed], middles: &Middles, axis: usize) -> Option<Split> {
    if middles.low[axis] >= middles.high[axis] {
        return None;
    }
    let mut bins = [(Bounds::NOTHING, 0u32); BINS];
    for one in part {
        let (bounds, count) = &mut bins[middles.bin(one, axis)];
        *bounds = bounds.joined(&one.bounds);
        *count += 1;
    }
    // Costs of everything from a bin on.
    let mut above = [(0.0, 0u32); BINS];
    let (mut bounds, mut count) = (Bounds::NOTHING, 0);
    for bin in (0..BINS).rev() {
        bounds = bounds.joined(&bins[bin].0);
        count += bins[bin].1;
        above[bin] = (bounds.area() * f64::from(count), count);
    }
    let (mut bounds, mut count) = (Bounds::NOTHING, 0);
    let mut best: Option<Split> = None;
    for bin in 1..BINS {
        bounds = bounds.joined(&bins[bin - 1].0);
        count += bins[bin - 1].1;
        let cost = bounds.area() * f64::from(count) + above[bin].0;
        if count > 0 && above[bin].1 > 0 && best.as_ref().is_none_or(|best| cost < best.cost) {
            best = Some(Split { cost, axis, bin });
        }
    }
    best
}

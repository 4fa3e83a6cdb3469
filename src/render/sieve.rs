//! Which triangles a ray is tested against: all, or those in boxes that it meets.

use crate::scene::bounds::Bounds;
use crate::workload::{Ray, Triangle};

/// A ray, or a segment, as boxes see it: in f64, its numbers those of the f32 ray, exactly (of a segment
/// the direction is rounded once).
#[derive(Clone, Copy, Debug)]
pub struct Line {
    origin: [f64; 3],
    inverse: [f64; 3],
    range: [f64; 2],
}

impl Line {
    /// Of a ray in its range, or of the segment from its origin to its end, t from 0 to 1.
    pub fn new(ray: &Ray, is_segment: bool) -> Self {
        let [origin, end] = [ray.origin, ray.end].map(|point| point.as_dvec3());
        let direction = if is_segment { end - origin } else { ray.direction.as_dvec3() };
        let range = if is_segment { [0.0, 1.0] } else { [ray.t_min, ray.t_max].map(f64::from) };
        let inverse = direction.to_array().map(|x| 1.0 / x);
        Line { origin: origin.to_array(), inverse, range }
    }

    /// Where it enters a closed box, at the latest; `None` only if the exact line misses it in its
    /// range.
    ///
    /// Slabs: (plane - origin) / direction, in which at most four operations round; the widening by 16
    /// roundings covers that. Where the direction is 0 the inverse is infinite: a slab beside the line
    /// is entered at infinity, one around it from minus infinity to infinity, and a plane that holds the
    /// line gives 0 * infinity = NaN, which fails the comparisons and bounds nothing.
    fn enters(&self, bounds: &Bounds) -> Option<f64> {
        const WIDER: f64 = 8.0 * f64::EPSILON;
        let [mut near, mut far] = self.range;
        for axis in 0..3 {
            let at = |place: f32| (f64::from(place) - self.origin[axis]) * self.inverse[axis];
            let (low, high) = (at(bounds.lowest[axis]), at(bounds.highest[axis]));
            let is_backward = self.inverse[axis].is_sign_negative();
            let (enters, leaves) = if is_backward { (high, low) } else { (low, high) };
            near = if enters > near { enters } else { near };
            far = if leaves < far { leaves } else { far };
        }
        (near * (1.0 - WIDER) <= far * (1.0 + WIDER)).then_some(near * (1.0 - WIDER))
    }
}

/// A binary tree of boxes, cut in the middle of its longer side, so that triangles that no ray is near
/// are not tested. Small and conservative, not fast.
#[derive(Clone, Debug, Default)]
pub struct Boxes {
    nodes: Vec<Node>,
    /// Triangles, those of a node in a row.
    order: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    /// In `order`.
    range: [usize; 2],
    /// The first of two; 0 for leaves.
    children: usize,
}

/// Triangles in a leaf.
const LEAF: usize = 4;

impl Boxes {
    /// Around all triangles.
    pub fn new(triangles: &[Triangle]) -> Self {
        let corners = |one: &Triangle| [one.a, one.b, one.c];
        let middle = |one: u32, axis: usize| {
            let three = corners(&triangles[one as usize]);
            three.iter().map(|corner| f64::from(corner[axis])).sum::<f64>()
        };
        let mut order: Vec<u32> = (0..triangles.len() as u32).collect();
        let around = |some: &[u32]| {
            Bounds::of(some.iter().flat_map(|one| corners(&triangles[*one as usize])))
        };
        let node = |range: [usize; 2], order: &[u32]| Node {
            bounds: around(&order[range[0]..range[1]]),
            range,
            children: 0,
        };
        let mut nodes = vec![node([0, order.len()], &order)];
        let mut next = 0;
        while next < nodes.len() {
            let Node { bounds, range: [begin, end], .. } = nodes[next];
            if end - begin > LEAF {
                let sides = (bounds.highest.as_dvec3() - bounds.lowest.as_dvec3()).to_array();
                let axis = (1..3).fold(0, |most, i| if sides[i] > sides[most] { i } else { most });
                // Stable, so that the tree is the same whatever sorts it.
                order[begin..end].sort_by(|a, b| middle(*a, axis).total_cmp(&middle(*b, axis)));
                let half = begin + (end - begin) / 2;
                nodes[next].children = nodes.len();
                nodes.extend([node([begin, half], &order), node([half, end], &order)]);
            }
            next += 1;
        }
        Boxes { nodes, order }
    }

    /// Shows the triangles of every box that the line meets, in some order. `visit` tells the t beyond
    /// which nothing is wanted any more.
    pub fn walk(&self, line: &Line, visit: &mut dyn FnMut(u32) -> f64) {
        let mut bound = f64::INFINITY;
        let mut stack = vec![(f64::NEG_INFINITY, 0)];
        while let Some((near, index)) = stack.pop() {
            let node = &self.nodes[index];
            if near > bound {
                continue;
            }
            if node.children == 0 {
                for one in &self.order[node.range[0]..node.range[1]] {
                    bound = visit(*one);
                }
                continue;
            }
            let entered =
                [0, 1].map(|i| (line.enters(&self.nodes[node.children + i].bounds), node.children + i));
            let mut met: Vec<(f64, usize)> =
                entered.into_iter().filter_map(|(near, child)| Some((near?, child))).collect();
            met.sort_by(|a, b| b.0.total_cmp(&a.0));
            stack.extend(met);
        }
    }
}

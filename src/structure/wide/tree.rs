//! The tree of the fast path.

/// A tree of nodes with `W` children, and leaves with up to `W` triangles.
#[derive(Clone, Debug)]
pub struct Wide<const W: usize> {
    /// The root is the first.
    pub nodes: Vec<Node<W>>,
    /// The triangles of each leaf; `NOBODY` where a leaf is not full.
    pub groups: Vec<[u32; W]>,
    /// What planes are relative to.
    pub middle: [f32; 3],
    /// The largest magnitude of a plane.
    pub reach: f32,
}

/// A place without a triangle.
pub const NOBODY: u32 = u32::MAX;
/// Set in a child that is a leaf; the rest is the index of its group.
pub const LEAF: u32 = 1 << 31;

/// Boxes of the children, number by number, and what they are. A place without a child has a box that
/// nothing meets.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Node<const W: usize> {
    /// Low and high planes across x, across y, across z.
    pub planes: [[f32; W]; 6],
    /// Indices of nodes, or of groups.
    pub children: [u32; W],
}

impl<const W: usize> Node<W> {
    /// Without children.
    pub const EMPTY: Self = {
        let far = f32::MAX * 0.5;
        Node {
            planes: [[far; W], [-far; W], [far; W], [-far; W], [far; W], [-far; W]],
            children: [0; W],
        }
    };
}

impl<const W: usize> Wide<W> {
    /// Bytes of memory, that of the triangles excluded.
    pub fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.groups.as_slice())
    }

    /// Triangles of a leaf, on average; 0 without leaves.
    pub fn triangles_per_leaf(&self) -> f64 {
        let held = self.groups.iter().flatten().filter(|one| **one != NOBODY).count();
        held as f64 / self.groups.len().max(1) as f64
    }
}

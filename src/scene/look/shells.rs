//! The parts of a mesh that hang together, and what they enclose.

use crate::number::Precision;
use glam::DVec3;

/// A part whose triangles hang together by their vertices.
pub(super) struct Shell {
    /// Six times the volume that it encloses if it is closed: above 0 with normals outwards.
    pub(super) volume: f64,
    /// The volume's rounding error is at most that.
    pub(super) error: f64,
    /// What volumes are measured from, so that a far place costs no digits.
    from: DVec3,
    /// Sum of the magnitudes of all products.
    permanent: f64,
    terms: f64,
}

/// The shells, in the order of their first triangles. `at` is where the vertices are.
pub(super) fn shells(triangles: &[[u32; 3]], at: &[DVec3]) -> Vec<Shell> {
    let mut parent: Vec<u32> = (0..at.len() as u32).collect();
    for [a, b, c] in triangles {
        join(&mut parent, *a, *b);
        join(&mut parent, *a, *c);
    }
    let mut index = vec![usize::MAX; at.len()];
    let mut shells: Vec<Shell> = Vec::new();
    for corners in triangles {
        let root = root(&mut parent, corners[0]) as usize;
        if index[root] == usize::MAX {
            index[root] = shells.len();
            let from = at[corners[0] as usize];
            shells.push(Shell { volume: 0.0, error: 0.0, from, permanent: 0.0, terms: 0.0 });
        }
        shells[index[root]].add(corners.map(|corner| at[corner as usize]));
    }
    for shell in &mut shells {
        // Each of the six products of a triangle rounds at most 3 + 2 + 1 + 2 times (as the oracle's
        // filter says of a determinant), and is summed over all triangles.
        let unit_roundoff = Precision::F64.unit_roundoff();
        shell.error = (8.0 + shell.terms) * unit_roundoff * shell.permanent;
    }
    shells
}

impl Shell {
    fn add(&mut self, corners: [DVec3; 3]) {
        let [a, b, c] = corners.map(|corner| corner - self.from);
        self.volume += a.dot(b.cross(c));
        let [a, b, c] = [a, b, c].map(DVec3::abs);
        let minors =
            DVec3::new(b.y * c.z + b.z * c.y, b.z * c.x + b.x * c.z, b.x * c.y + b.y * c.x);
        self.permanent += a.dot(minors);
        self.terms += 1.0;
    }
}

/// The vertex that stands for a set; paths are halved on the way.
fn root(parent: &mut [u32], mut vertex: u32) -> u32 {
    while parent[vertex as usize] != vertex {
        let above = parent[parent[vertex as usize] as usize];
        parent[vertex as usize] = above;
        vertex = above;
    }
    vertex
}

fn join(parent: &mut [u32], one: u32, other: u32) {
    let (one, other) = (root(parent, one), root(parent, other));
    // The lower index stands for both, whatever the order.
    parent[one.max(other) as usize] = one.min(other);
}

//! Which edges triangles share.

use super::shells::{Shell, shells};
use crate::scene::mesh::Mesh;
use crate::scene::weld::Weld;
use serde::Serialize;

/// By place: vertices at the same place are one. Triangles with two corners at one place have no
/// edges here.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Edges {
    /// Edges of one triangle.
    pub boundary: u64,
    /// Edges of two triangles.
    pub manifold: u64,
    /// Edges of three or more.
    pub non_manifold: u64,
    /// Edges of two triangles that run along them in the same sense: one of the two is turned over.
    pub turned: u64,
    /// Whether every edge has two triangles: `boundary` and `non_manifold` are 0.
    pub closed: bool,
    /// Whether neighbours face the same side: `turned` and `non_manifold` are 0.
    pub consistent: bool,
    /// Parts that share no vertex.
    pub shells: u64,
    /// Closed, consistent shells around which normals point outwards: their signed volume is above
    /// 0 by more than its rounding error.
    pub outward: u64,
    /// The same with normals inwards, as of a room.
    pub inward: u64,
}

/// The edge between two places, the lower first, and whether the triangle goes from low to high.
type Use = ([u32; 2], bool);

impl Edges {
    /// Of a mesh.
    pub(super) fn of(mesh: &Mesh) -> Self {
        let places = Weld::of(&mesh.vertices);
        let welded = mesh.triangles.iter().map(|t| t.map(|corner| places[corner as usize]));
        // By place, with the vertices' own indices left out of it from here on.
        let triangles: Vec<[u32; 3]> =
            welded.filter(|[a, b, c]| a != b && b != c && c != a).collect();
        let mut uses: Vec<Use> = triangles.iter().flat_map(sides).collect();
        uses.sort_unstable();
        let mut edges = Edges {
            boundary: 0,
            manifold: 0,
            non_manifold: 0,
            turned: 0,
            closed: false,
            consistent: false,
            shells: 0,
            outward: 0,
            inward: 0,
        };
        for users in uses.chunk_by(|one, other| one.0 == other.0) {
            match users {
                [_] => edges.boundary += 1,
                [one, other] => {
                    edges.manifold += 1;
                    edges.turned += u64::from(one.1 == other.1);
                }
                _ => edges.non_manifold += 1,
            }
        }
        edges.closed = edges.boundary == 0 && edges.non_manifold == 0 && !triangles.is_empty();
        edges.consistent = edges.turned == 0 && edges.non_manifold == 0;
        let mut at = vec![glam::DVec3::ZERO; mesh.vertices.len()];
        for (place, vertex) in places.iter().zip(&mesh.vertices) {
            at[*place as usize] = vertex.as_dvec3();
        }
        edges.count(&shells(&triangles, &at));
        edges
    }

    fn count(&mut self, shells: &[Shell]) {
        self.shells = shells.len() as u64;
        if self.closed && self.consistent {
            let outward = shells.iter().filter(|shell| shell.volume > shell.error);
            let inward = shells.iter().filter(|shell| shell.volume < -shell.error);
            (self.outward, self.inward) = (outward.count() as u64, inward.count() as u64);
        }
    }
}

fn sides([a, b, c]: &[u32; 3]) -> [Use; 3] {
    [[*a, *b], [*b, *c], [*c, *a]].map(|[from, to]| ([from.min(to), from.max(to)], from < to))
}

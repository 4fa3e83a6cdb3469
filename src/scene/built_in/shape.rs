//! Parts of a built-in scene.

use crate::scene::weld::Weld;
use glam::Vec3;

/// Vertices, and triangles by them.
#[derive(Clone, Default)]
pub(super) struct Shape {
    pub(super) vertices: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Shape {
    /// Two triangles; a, b, c, d run counter-clockwise seen from the front.
    pub(super) fn quad(&mut self, corners: [Vec3; 4]) {
        let first = self.vertices.len() as u32;
        self.vertices.extend(corners);
        self.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }

    /// Adds another shape's triangles.
    pub(super) fn add(&mut self, other: &Shape) {
        let first = self.vertices.len() as u32;
        self.vertices.extend(&other.vertices);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|corner| corner + first)));
    }

    /// The same with every vertex moved.
    pub(super) fn moved(mut self, to: impl Fn(Vec3) -> Vec3) -> Self {
        self.vertices.iter_mut().for_each(|vertex| *vertex = to(*vertex));
        self
    }

    /// The same with one vertex a place.
    pub(super) fn welded(self) -> Self {
        let mut weld = Weld::default();
        let mut vertices = Vec::new();
        let mut indices = Vec::with_capacity(self.vertices.len());
        for vertex in self.vertices {
            let (index, is_new) = weld.index(vertex);
            if is_new {
                vertices.push(vertex);
            }
            indices.push(index);
        }
        let welded = |corner: u32| indices[corner as usize];
        Shape { vertices, triangles: self.triangles.iter().map(|t| t.map(welded)).collect() }
    }
}

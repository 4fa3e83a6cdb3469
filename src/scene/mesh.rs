//! Triangles that share vertices, from a file or built in.

mod build;
mod load;
mod obj;
mod ply;
mod sieve;
mod stl;
mod stl_lines;
#[cfg(test)]
mod tests;

pub use load::{Format, load, read};

use super::bounds::Bounds;
use crate::workload::Triangle;
use glam::Vec3;
use serde::Serialize;

/// A mesh. Every index is that of a vertex, every coordinate is finite, and there is a triangle.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// File or built-in scene, as the user wrote it.
    pub name: String,
    /// Positions, at the file's own place: nothing is moved or scaled.
    pub vertices: Vec<Vec3>,
    /// By their vertices a, b, c, in the file's order.
    pub triangles: Vec<[u32; 3]>,
    /// What became of the file's faces and numbers on the way.
    pub dropped: Dropped,
    /// From where to look at it; built-in rooms say so, files do not.
    pub view: Option<View>,
}

/// What a file holds and the mesh does not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Dropped {
    /// Faces of more than three corners. Each was cut into a fan around its first corner, which is
    /// right for convex ones.
    pub polygons: u64,
    /// Faces of fewer than three corners: left out.
    pub faces: u64,
    /// Vertices that no face of an OBJ file refers to: left out.
    pub vertices: u64,
    /// Coordinates that are no f32: each was rounded to the nearest, once. (A decimal number is
    /// read as f64 first, except where a PLY file declares it as `float`.)
    pub coordinates_rounded: u64,
    /// How far the farthest of them was moved, in units of the mesh.
    pub largest_rounding: f64,
}

impl Dropped {
    /// Counts a coordinate that no f32 has exactly.
    fn rounds(&mut self, coordinate: f64) {
        let error = (f64::from(coordinate as f32) - coordinate).abs();
        if error > 0.0 {
            self.coordinates_rounded += 1;
            self.largest_rounding = self.largest_rounding.max(error);
        }
    }
}

/// Where a picture is taken from, and lit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The pinhole.
    pub eye: Vec3,
    /// What is in the middle of the picture.
    pub target: Vec3,
    /// Which way is up; not parallel to the line of sight.
    pub up: Vec3,
    /// A point that light comes from.
    pub light: Vec3,
}

impl Mesh {
    /// The corners of a triangle; `index` must be below the number of triangles.
    pub fn triangle(&self, index: usize) -> Triangle {
        let [a, b, c] = self.triangles[index].map(|vertex| self.vertices[vertex as usize]);
        Triangle { a, b, c }
    }

    /// All triangles, as workloads hold them.
    pub fn list(&self) -> Vec<Triangle> {
        (0..self.triangles.len()).map(|index| self.triangle(index)).collect()
    }

    /// The smallest box around the vertices that triangles use.
    pub fn bounds(&self) -> Bounds {
        let corners = self.triangles.iter().flatten();
        Bounds::of(corners.map(|vertex| self.vertices[*vertex as usize]))
    }
}

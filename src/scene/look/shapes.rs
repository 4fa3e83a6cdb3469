//! What the triangles of a mesh look like, one by one.

use super::direction::Direction;
use super::quantiles::Quantiles;
use crate::scene::mesh::Mesh;
use crate::scene::weld::Weld;
use crate::workload::{Triangle, aspect};
use serde::Serialize;
use std::collections::HashSet;

/// Lengths in units of the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Shapes {
    /// Number of triangles.
    pub triangles: u64,
    /// Number of vertices.
    pub vertices: u64,
    /// Vertices at the place of an earlier one.
    pub duplicate_vertices: u64,
    /// Triangles with the three places of an earlier one, whatever their order.
    pub duplicate_triangles: u64,
    /// Triangles without area, exactly; they are in none of the quantiles below.
    pub zero_area: u64,
    /// Square of the longest edge over twice the area: 1.15 for an equilateral triangle.
    pub aspect: Quantiles,
    /// Smallest height of each triangle: twice the area over the longest edge.
    pub height: Quantiles,
    /// Length of the edges of all triangles; of an edge between two, twice.
    pub edge: Quantiles,
    /// Triangles in a plane across the x, y, z axis: their corners have equal coordinates there.
    /// One without area may be in more than one.
    pub across_axis: [u64; 3],
    /// Share of triangles that are across some axis, 0 to 1.
    pub axis_aligned_share: f64,
}

impl Shapes {
    /// Of a mesh; `directions` are those of its triangles.
    pub(super) fn of(mesh: &Mesh, directions: &[Direction]) -> Self {
        let places = Weld::of(&mesh.vertices);
        let (mut heights, mut aspects, mut edges) = (Vec::new(), Vec::new(), Vec::new());
        let mut seen = HashSet::new();
        let (mut across_axis, mut aligned, mut duplicates, mut zero_area) = ([0; 3], 0, 0, 0);
        for ((triangle, direction), corners) in
            mesh.list().iter().zip(directions).zip(&mesh.triangles)
        {
            let mut key = corners.map(|corner| places[corner as usize]);
            key.sort_unstable();
            duplicates += u64::from(!seen.insert(key));
            let across = across(triangle);
            aligned += u64::from(across.contains(&true));
            (0..3).for_each(|axis| across_axis[axis] += u64::from(across[axis]));
            if direction.is_degenerate() {
                zero_area += 1;
                continue;
            }
            let lengths = lengths(triangle);
            heights.push(direction.length() / lengths.into_iter().fold(0.0, f64::max));
            aspects.push(aspect(triangle));
            edges.extend(lengths);
        }
        let triangles = mesh.triangles.len() as u64;
        let distinct = places.iter().max().map_or(0, |last| u64::from(*last) + 1);
        Shapes {
            triangles,
            vertices: mesh.vertices.len() as u64,
            duplicate_vertices: mesh.vertices.len() as u64 - distinct,
            duplicate_triangles: duplicates,
            zero_area,
            aspect: Quantiles::of(aspects),
            height: Quantiles::of(heights),
            edge: Quantiles::of(edges),
            across_axis,
            axis_aligned_share: aligned as f64 / triangles as f64,
        }
    }
}

fn across(triangle: &Triangle) -> [bool; 3] {
    let Triangle { a, b, c } = triangle;
    [0, 1, 2].map(|axis| a[axis] == b[axis] && a[axis] == c[axis])
}

fn lengths(triangle: &Triangle) -> [f64; 3] {
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| corner.as_dvec3());
    [b - a, c - b, a - c].map(|edge| edge.length())
}

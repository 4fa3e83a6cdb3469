//! A sphere of nearly equal triangles: closed, seen from outside.

use super::shape::Shape;
use super::{BuiltIn, View};
use crate::workload::normalised;
use glam::Vec3;
use std::collections::HashMap;

pub(super) const ICOSPHERE: BuiltIn = BuiltIn {
    name: "icosphere",
    about: "a sphere of radius 1, triangles of nearly equal size, closed",
    size: "times that an icosahedron's triangles are divided; 20 x 4^n triangles",
    usual: 4,
    sizes: [0, 8],
    build,
};

fn build(divisions: u32) -> (Shape, Option<View>) {
    (sphere(divisions), None)
}

/// Radius 1 around 0.
pub(super) fn sphere(divisions: u32) -> Shape {
    let mut shape = icosahedron();
    shape = shape.moved(normalised);
    for _ in 0..divisions {
        shape = divided(shape);
    }
    shape
}

/// The corners of three golden rectangles; the edges have length 2, and no two other corners are
/// as near.
fn icosahedron() -> Shape {
    let golden = (1.0 + 5.0f32.sqrt()) / 2.0;
    let mut vertices = Vec::new();
    for (one, other) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        for corner in [[one, other, 0.0], [0.0, one, other], [other, 0.0, one]] {
            vertices.push(Vec3::from(corner));
        }
    }
    // Squared, an edge is 4 and the next distance more than 10.
    let near = |a: usize, b: usize| vertices[a].distance_squared(vertices[b]) < 5.0;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in (a + 1..12).filter(|b| near(a, *b)) {
            for c in (b + 1..12).filter(|c| near(a, *c) && near(b, *c)) {
                let is_front = vertices[a].dot(vertices[b].cross(vertices[c])) > 0.0;
                let [b, c] = if is_front { [b, c] } else { [c, b] };
                triangles.push([a, b, c].map(|corner| corner as u32));
            }
        }
    }
    Shape { vertices, triangles }
}

/// Every triangle cut into four, the new vertices on the sphere.
fn divided(shape: Shape) -> Shape {
    let Shape { mut vertices, triangles } = shape;
    let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            vertices.push(normalised(vertices[a as usize] + vertices[b as usize]));
            vertices.len() as u32 - 1
        })
    };
    let mut finer = Vec::with_capacity(4 * triangles.len());
    for [a, b, c] in triangles {
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    Shape { vertices, triangles: finer }
}

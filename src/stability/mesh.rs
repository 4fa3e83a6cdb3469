//! Closed meshes that are star-shaped around their centre.

use super::family::MeshKind;
use super::precision::Precision;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Radius of the meshes; that of the spheres in Embree's test of watertightness.
const RADIUS: f64 = 2.0;
/// Where that test has them, as a direction from the coordinates' origin (not of length 1).
const FAR_AWAY: DVec3 = DVec3::new(148_376.0, 1_234.0, -223_423.0);
/// Radius of the lattice mesh, before its vertices are rounded to even numbers.
const LATTICE_RADIUS: f64 = 500.0;
/// Origins of rays lie within this share of the radius.
const INNER: f64 = 0.3;
const MERIDIANS: u32 = 1024;
const BANDS: u32 = 4;
const SQUASH: f64 = 1e-4;

/// An edge of a closed mesh, with the triangles on its sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Vertices.
    pub ends: [u32; 2],
    /// Triangles.
    pub sides: [u32; 2],
}

/// A closed mesh whose vertices are rounded to a precision.
pub struct Mesh {
    /// Vertices.
    pub vertices: Vec<DVec3>,
    /// Triangles by their vertices, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Edges.
    pub edges: Vec<Edge>,
    /// The triangles around each vertex.
    pub around: Vec<Vec<u32>>,
    /// The triangles across each triangle's edges.
    pub across: Vec<[u32; 3]>,
    /// Before rounding.
    pub centre: DVec3,
    /// Semi-axes of the ellipsoid of ray origins.
    pub inner: DVec3,
}

impl Mesh {
    /// The mesh of a kind, with its centre that far from the coordinates' origin.
    pub fn new(kind: MeshKind, offset: f64, precision: Precision) -> Self {
        let (points, triangles) = match kind {
            MeshKind::Needles => meridians(),
            _ => subdivided(),
        };
        let centre = FAR_AWAY.normalize() * offset;
        let scale = match kind {
            MeshKind::Lattice => DVec3::splat(LATTICE_RADIUS),
            MeshKind::Squashed => DVec3::new(RADIUS, RADIUS, RADIUS * SQUASH),
            _ => DVec3::splat(RADIUS),
        };
        let rounded = |point: &DVec3| {
            let point = centre + *point * scale;
            DVec3::from_array(point.to_array().map(|x| match kind {
                MeshKind::Lattice => 2.0 * (x / 2.0).round(),
                _ => precision.round(x),
            }))
        };
        let vertices = points.iter().map(rounded).collect();
        let inner = scale * INNER;
        Mesh::connected(vertices, triangles, centre, inner)
    }

    fn connected(
        vertices: Vec<DVec3>,
        triangles: Vec<[u32; 3]>,
        centre: DVec3,
        inner: DVec3,
    ) -> Self {
        let mut around = vec![Vec::new(); vertices.len()];
        let mut sides: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        for (index, corners) in (0u32..).zip(&triangles) {
            for corner in 0..3 {
                around[corners[corner] as usize].push(index);
                sides.entry(ends(corners, corner)).or_default().push(index);
            }
        }
        let edge = |(ends, sides): (&[u32; 2], &Vec<u32>)| match sides.as_slice() {
            &[one, other] => Some(Edge { ends: *ends, sides: [one, other] }),
            // A mesh that is not closed has no such edge.
            _ => None,
        };
        let edges: Vec<Edge> = sides.iter().filter_map(edge).collect();
        let other_side = |triangle: u32, ends: [u32; 2]| {
            let both = &sides[&ends];
            both.iter().copied().find(|side| *side != triangle).unwrap_or(triangle)
        };
        let across = (0u32..).zip(&triangles);
        let across = across
            .map(|(index, corners)| [0, 1, 2].map(|i| other_side(index, ends(corners, i))))
            .collect();
        Mesh { vertices, triangles, edges, around, across, centre, inner }
    }

    /// Vertices of a triangle.
    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles[triangle as usize].map(|vertex| self.vertices[vertex as usize])
    }
}

/// The edge behind a corner, the lower vertex first.
fn ends(corners: &[u32; 3], corner: usize) -> [u32; 2] {
    let (one, other) = (corners[corner], corners[(corner + 1) % 3]);
    [one.min(other), one.max(other)]
}

/// An icosahedron whose triangles are divided into four, three times: 1280 triangles, 642 vertices
/// at distance 1.
fn subdivided() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let mut points = Vec::new();
    for (one, other) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        points.push(DVec3::new(one, other, 0.0).normalize());
    }
    for (one, other) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        points.push(DVec3::new(0.0, one, other).normalize());
    }
    for (one, other) in [(golden, -1.0), (golden, 1.0), (-golden, -1.0), (-golden, 1.0)] {
        points.push(DVec3::new(one, 0.0, other).normalize());
    }
    let mut triangles = ICOSAHEDRON.to_vec();
    for _ in 0..3 {
        let mut middles: BTreeMap<[u32; 2], u32> = BTreeMap::new();
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for corners in &triangles {
            let [ab, bc, ca] = [0, 1, 2].map(|corner| {
                let ends = ends(corners, corner);
                *middles.entry(ends).or_insert_with(|| {
                    let [one, other] = ends.map(|end| points[end as usize]);
                    points.push((one + other).normalize());
                    points.len() as u32 - 1
                })
            });
            let [a, b, c] = *corners;
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    (points, triangles)
}

/// Counter-clockwise from outside.
const ICOSAHEDRON: [[u32; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];

/// A sphere of meridians and bands: rings of vertices between two poles. Sines come from a library
/// that computes them the same on every machine.
fn meridians() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let mut points = vec![DVec3::Z];
    for ring in 1..BANDS {
        let polar = PI * f64::from(ring) / f64::from(BANDS);
        for meridian in 0..MERIDIANS {
            let turn = 2.0 * PI * f64::from(meridian) / f64::from(MERIDIANS);
            let radius = libm::sin(polar);
            let (x, y) = (radius * libm::cos(turn), radius * libm::sin(turn));
            points.push(DVec3::new(x, y, libm::cos(polar)));
        }
    }
    let last = points.len() as u32;
    points.push(-DVec3::Z);
    let mut triangles = Vec::new();
    let at = |ring: u32, meridian: u32| 1 + ring * MERIDIANS + meridian % MERIDIANS;
    for meridian in 0..MERIDIANS {
        let next = meridian + 1;
        triangles.push([0, at(0, meridian), at(0, next)]);
        for ring in 0..BANDS - 2 {
            let [a, b] = [at(ring, meridian), at(ring, next)];
            let [c, d] = [at(ring + 1, meridian), at(ring + 1, next)];
            triangles.extend([[a, c, d], [a, d, b]]);
        }
        triangles.push([last, at(BANDS - 2, next), at(BANDS - 2, meridian)]);
    }
    (points, triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_are_closed_and_seen_from_inside() {
        for kind in [MeshKind::Lattice, MeshKind::Sphere, MeshKind::Needles, MeshKind::Squashed] {
            let mesh = Mesh::new(kind, 0.0, Precision::F32);
            // Euler: V - E + F = 2, with every edge between two triangles.
            assert_eq!(2 * mesh.edges.len(), 3 * mesh.triangles.len());
            assert_eq!(mesh.vertices.len() + mesh.triangles.len(), mesh.edges.len() + 2);
            for triangle in 0..mesh.triangles.len() as u32 {
                let [a, b, c] = mesh.corners(triangle);
                assert!(a.dot(b.cross(c)) > 0.0, "{kind:?} {triangle}");
                for other in mesh.across[triangle as usize] {
                    assert!(mesh.across[other as usize].contains(&triangle));
                }
            }
        }
    }

    #[test]
    fn lattice_vertices_are_even_whole_numbers() {
        let mesh = Mesh::new(MeshKind::Lattice, 0.0, Precision::F32);
        let even = |point: &DVec3| point.to_array().iter().all(|x| x % 2.0 == 0.0);
        assert!(mesh.vertices.iter().all(even));
    }

    #[test]
    fn needles_are_long() {
        let mesh = Mesh::new(MeshKind::Needles, 0.0, Precision::F64);
        let aspect = |triangle: u32| {
            let [a, b, c] = mesh.corners(triangle);
            let edges = [b - a, c - b, a - c].map(DVec3::length_squared);
            edges.into_iter().fold(0.0, f64::max) / (b - a).cross(c - a).length()
        };
        let least = (0..mesh.triangles.len() as u32).map(aspect).fold(f64::INFINITY, f64::min);
        assert!(least > 100.0, "{least}");
    }
}

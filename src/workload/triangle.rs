//! A triangle as it is drawn.

use glam::Vec3;

/// One triangle as drawn: u is the weight of `b`, v of `c`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Vertex a (w = 1 - u - v).
    pub a: Vec3,
    /// Vertex b (u).
    pub b: Vec3,
    /// Vertex c (v).
    pub c: Vec3,
}

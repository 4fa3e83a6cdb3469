//! Which components of a triangle's normal are zero, exactly.

use crate::oracle::{Class, Query, classify};
use crate::workload::Triangle;

/// Rounding error of a component of the normal, over its permanent (the sum of the magnitudes of
/// its two products). With u = 2^-53: each factor is a difference, which rounds once, each product
/// rounds, and so does their difference: 2 + 1 + 1 roundings, 4 u to first order. 8 u is twice that.
/// Differences of f32 numbers are 0 or at least 2^-149, and below 2^129: in f64 nothing underflows
/// or overflows.
const BOUND: f64 = 8.0 * (f64::EPSILON / 2.0);

/// The normal (b - a) x (c - a) of one triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Components in f64, 0 where they are exactly 0.
    pub components: [f64; 3],
    /// Whether the sign of each is certain.
    pub certain: [bool; 3],
}

impl Direction {
    /// Of a triangle with finite corners.
    pub fn of(triangle: &Triangle) -> Self {
        let (a, b, c) = (triangle.a.as_dvec3(), triangle.b.as_dvec3(), triangle.c.as_dvec3());
        let (e1, e2) = (b - a, c - a);
        let mut direction = Direction { components: [0.0; 3], certain: [true; 3] };
        for axis in 0..3 {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let (plus, minus) = (e1[i] * e2[j], e1[j] * e2[i]);
            let (value, permanent) = (plus - minus, plus.abs() + minus.abs());
            // Where the permanent is 0, so is the component: nothing was rounded.
            let is_certain = permanent == 0.0 || value.abs() > BOUND * permanent;
            if is_certain {
                direction.components[axis] = value;
            } else if !is_zero(triangle, axis) {
                // The sign stays open, the size is at most twice the bound, and it is not 0.
                let bound = BOUND * permanent;
                direction.components[axis] = if value == 0.0 { bound } else { value };
                direction.certain[axis] = false;
            }
        }
        direction
    }

    /// Whether the triangle has no area, exactly.
    pub fn is_degenerate(&self) -> bool {
        self.certain == [true; 3] && self.components == [0.0; 3]
    }

    /// Twice the area.
    pub fn length(&self) -> f64 {
        self.components.iter().map(|x| x * x).sum::<f64>().sqrt()
    }
}

/// Whether a component is exactly 0: a line along that axis through vertex a meets the triangle
/// there, unless it lies in the plane or there is no plane.
fn is_zero(triangle: &Triangle, axis: usize) -> bool {
    let corner = |p: glam::Vec3| p.as_dvec3().to_array();
    let mut direction = [0.0; 3];
    direction[axis] = 1.0;
    let class = classify(&Query {
        origin: corner(triangle.a),
        direction,
        end: None,
        triangle: [triangle.a, triangle.b, triangle.c].map(corner),
        t_min: 0.0,
        t_max: 0.0,
    });
    matches!(class, Class::Coplanar | Class::Degenerate)
}

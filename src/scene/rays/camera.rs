//! The rays of a picture.

use super::reach;
use crate::scene::bounds::Bounds;
use crate::scene::mesh::View;
use crate::workload::{Ray, ray};
use glam::{DVec3, Vec3};

/// Tangent of half the angle that the shorter side of a picture covers, which is 53 degrees.
const TANGENT: f64 = 0.5;
/// From where a mesh is looked at: along no axis, so that nothing in it lines up with pixels.
const FROM: DVec3 = DVec3::new(3.0, 2.0, 5.0);

/// A pinhole, and the picture before it.
pub struct Camera {
    eye: Vec3,
    forward: DVec3,
    /// To the right edge of the picture at distance 1 from the pinhole; up likewise.
    right: DVec3,
    up: DVec3,
    width: u32,
    height: u32,
}

impl Camera {
    /// Of a view; a picture without pixels has no rays.
    pub fn new(view: &View, width: u32, height: u32) -> Self {
        let forward = (view.target.as_dvec3() - view.eye.as_dvec3()).normalize_or(DVec3::NEG_Z);
        // A view that is straight up or down is turned to be upright by another axis.
        let sideways = forward.cross(view.up.as_dvec3());
        let right = sideways.try_normalize().unwrap_or_else(|| forward.any_orthonormal_vector());
        let shorter = f64::from(width.min(height).max(1));
        let (along, across) = (f64::from(width) / shorter, f64::from(height) / shorter);
        Camera {
            eye: view.eye,
            forward,
            right: right * (TANGENT * along),
            up: right.cross(forward) * (TANGENT * across),
            width,
            height,
        }
    }

    /// The ray through the middle of a pixel, counted from the top left.
    pub fn ray(&self, column: u32, row: u32, bounds: &Bounds) -> Ray {
        let place = |pixel: u32, pixels: u32| (2.0 * f64::from(pixel) + 1.0) / f64::from(pixels);
        let (x, y) = (place(column, self.width) - 1.0, 1.0 - place(row, self.height));
        let direction = (self.forward + self.right * x + self.up * y).normalize();
        ray(self.eye, direction.as_vec3(), reach(self.eye, bounds))
    }

    /// Whether a point is in the picture, its edges included.
    pub fn sees(&self, point: Vec3) -> bool {
        let way = point.as_dvec3() - self.eye.as_dvec3();
        let depth = way.dot(self.forward);
        let within = |side: DVec3| way.dot(side).abs() <= depth * side.length_squared();
        depth > 0.0 && within(self.right) && within(self.up)
    }

    /// All of them, row by row.
    pub fn rays(&self, bounds: &Bounds) -> Vec<Ray> {
        let pixels = (0..self.height).flat_map(|row| (0..self.width).map(move |c| (c, row)));
        pixels.map(|(column, row)| self.ray(column, row, bounds)).collect()
    }
}

/// A view of the ball around the mesh, which touches the sides of the picture, y upwards, the light
/// behind the viewer's right shoulder, outside the ball.
pub(super) fn whole(bounds: &Bounds) -> View {
    let (centre, radius) = (bounds.centre(), bounds.radius());
    let from = FROM.normalize();
    // The ball seen under a half angle: its sine is radius over distance.
    let sine = TANGENT / (1.0 + TANGENT * TANGENT).sqrt();
    let right = DVec3::Y.cross(from).normalize();
    let light = centre + (from + right + DVec3::Y * 2.0) * radius;
    View {
        eye: (centre + from * (radius / sine)).as_vec3(),
        target: centre.as_vec3(),
        up: Vec3::Y,
        light: light.as_vec3(),
    }
}

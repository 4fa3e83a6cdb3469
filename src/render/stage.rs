//! A mesh made ready for pictures: its surfaces, its lights, its camera.

use super::material::Material;
use super::paint;
use crate::scene::bounds::Bounds;
use crate::scene::mesh::{Mesh, View};
use crate::scene::rays::{Camera, view};
use crate::workload::{Ray, Triangle};
use glam::Vec3;

/// A point that light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Its place.
    pub place: Vec3,
    /// Its strength, the same at every distance: pictures do not depend on a scene's size.
    pub strength: f64,
}

/// Everything that a picture shows.
pub struct Stage {
    /// The mesh's triangles, in its order.
    pub triangles: Vec<Triangle>,
    /// The material of each.
    pub surfaces: Vec<Material>,
    /// The lights.
    pub lights: Vec<Light>,
    /// Around the mesh.
    pub bounds: Bounds,
    view: View,
    size: [u32; 2],
    camera: Camera,
}

impl Stage {
    /// A mesh, seen in a picture of `size` (columns, rows), both above 0, from where primary rays of
    /// the mesh come from.
    pub fn new(mesh: &Mesh, size: [u32; 2]) -> Self {
        let view = view(mesh);
        let triangles = mesh.list();
        let bounds = mesh.bounds();
        Stage {
            surfaces: triangles.iter().map(|one| paint::surface(&mesh.name, one)).collect(),
            lights: lights(view.light, view.eye),
            camera: Camera::new(&view, size[0], size[1]),
            triangles,
            bounds,
            view,
            size,
        }
    }

    /// The same in a picture of another size.
    pub fn resized(&self, size: [u32; 2]) -> Self {
        Stage {
            triangles: self.triangles.clone(),
            surfaces: self.surfaces.clone(),
            lights: self.lights.clone(),
            camera: Camera::new(&self.view, size[0], size[1]),
            size,
            ..*self
        }
    }

    /// Columns and rows of the picture.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The ray through the middle of a pixel, counted from the top left.
    pub fn primary(&self, column: u32, row: u32) -> Ray {
        self.camera.ray(column, row, &self.bounds)
    }
}

/// The view's own light, and a weaker one halfway from the eye to it, so that shadows are not black:
/// inside every convex room that both are in.
fn lights(light: Vec3, eye: Vec3) -> Vec<Light> {
    vec![
        Light { place: light, strength: 0.65 },
        Light { place: eye.midpoint(light), strength: 0.35 },
    ]
}

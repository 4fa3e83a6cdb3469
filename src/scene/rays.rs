//! Rays for a mesh.

mod ambient;
mod camera;
mod file;
mod random;
mod shadow;
mod spot;
#[cfg(test)]
mod tests;

pub use camera::Camera;
pub use shadow::ray as towards_light;
pub use spot::{OFFSET, Spot};

use super::bounds::Bounds;
use super::mesh::{Mesh, View};
use crate::check::read::ReadError;
use crate::workload::{Pcg, Ray, ray};
use glam::{DVec3, Vec3};

/// Which rays.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Asked {
    /// One a pixel, from a camera that sees the whole mesh, or from where a built-in room says.
    Primary,
    /// From where primary rays meet the mesh towards a light.
    Shadow,
    /// From there, too, in random directions over the surface.
    Ambient,
    /// Chords of the ball around the mesh.
    Random,
    /// Those of a file.
    File(String),
}

impl Asked {
    /// The words for what is drawn; any other is the name of a file.
    pub const WORDS: [&'static str; 4] = ["primary", "shadow", "ambient", "random"];

    /// By a word, or the name of a file.
    pub fn of(text: &str) -> Self {
        match text {
            "primary" => Asked::Primary,
            "shadow" => Asked::Shadow,
            "ambient" => Asked::Ambient,
            "random" => Asked::Random,
            file => Asked::File(file.to_owned()),
        }
    }

    /// The word, or the file's name.
    pub fn word(&self) -> &str {
        match self {
            Asked::Primary => "primary",
            Asked::Shadow => "shadow",
            Asked::Ambient => "ambient",
            Asked::Random => "random",
            Asked::File(file) => file,
        }
    }
}

/// How many, and by which numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Pixels of a row; random rays are as many as pixels.
    pub width: u32,
    /// Rows, from the top.
    pub height: u32,
    /// Ambient rays from a point.
    pub per_point: u32,
    /// Where the generator starts, for ambient and random rays.
    pub seed: u64,
}

/// Rays of one kind.
#[derive(Clone, Debug)]
pub struct Rays {
    /// In the order of pixels, row by row from the top left, or of the file.
    pub rays: Vec<Ray>,
    /// Pixels whose primary ray met nothing, so that nothing starts there.
    pub unseen: u64,
    /// Points from which no shadow ray starts: they face away from the light, are nearer to it than
    /// rounding, or the primary ray lies in the triangle's plane.
    pub dark: u64,
    /// The light, for shadow rays.
    pub light: Option<Vec3>,
}

impl Rays {
    /// The rays that are asked for. `nearest` gives the index of the first triangle that a ray
    /// meets; only shadow and ambient rays need it.
    ///
    /// # Errors
    /// Of a file: what is wrong, where, and what is allowed.
    pub fn of(
        asked: &Asked,
        mesh: &Mesh,
        plan: Plan,
        nearest: impl FnMut(&Ray) -> Option<u32>,
    ) -> Result<Self, ReadError> {
        let bounds = mesh.bounds();
        let view = mesh.view.unwrap_or_else(|| camera::whole(&bounds));
        let primary = || Camera::new(&view, plan.width, plan.height).rays(&bounds);
        Ok(match asked {
            Asked::Primary => Rays::only(primary()),
            Asked::Shadow => {
                let spots = Spots::of(&primary(), mesh, nearest);
                shadow::towards(view.light, &spots)
            }
            Asked::Ambient => {
                let spots = Spots::of(&primary(), mesh, nearest);
                let mut source = Pcg::stream(plan.seed, AMBIENT);
                ambient::over(&spots, plan.per_point, &bounds, &mut source)
            }
            Asked::Random => {
                let count = plan.width as usize * plan.height as usize;
                let mut source = Pcg::stream(plan.seed, RANDOM);
                Rays::only((0..count).map(|_| random::chord(&bounds, &mut source)).collect())
            }
            Asked::File(file) => Rays::only(file::load(file, &bounds)?),
        })
    }

    fn only(rays: Vec<Ray>) -> Self {
        Rays { rays, unseen: 0, dark: 0, light: None }
    }
}

/// The view that primary rays of a mesh have: its own, or one of the whole mesh.
pub fn view(mesh: &Mesh) -> View {
    mesh.view.unwrap_or_else(|| camera::whole(&mesh.bounds()))
}

/// A ray that ends nowhere, and whose segment ends beyond the mesh; `direction` is of length 1.
pub fn beyond(origin: Vec3, direction: DVec3, bounds: &Bounds) -> Ray {
    ray(origin, direction.as_vec3(), reach(origin, bounds))
}

/// Purposes of the generator.
const AMBIENT: u64 = 1;
const RANDOM: u64 = 2;

/// Where primary rays meet the mesh.
struct Spots {
    spots: Vec<Spot>,
    unseen: u64,
    dark: u64,
}

impl Spots {
    fn of(rays: &[Ray], mesh: &Mesh, mut nearest: impl FnMut(&Ray) -> Option<u32>) -> Self {
        let mut spots = Spots { spots: Vec::new(), unseen: 0, dark: 0 };
        for ray in rays {
            match nearest(ray).map(|index| Spot::of(ray, &mesh.triangle(index as usize))) {
                Some(Some(spot)) => spots.spots.push(spot),
                Some(None) => spots.dark += 1,
                None => spots.unseen += 1,
            }
        }
        spots
    }
}

/// Length that takes a segment from `origin` out of the ball around the mesh, whatever its
/// direction: the distance to the far side, and half the radius more.
fn reach(origin: Vec3, bounds: &Bounds) -> f32 {
    (origin.as_dvec3().distance(bounds.centre()) + 1.5 * bounds.radius()) as f32
}

//! What a mesh and its rays are like. Every yes or no stands beside the number that decided it, and
//! none is decided by a tolerance: zeros are exact, by the filter and the oracle.

mod direction;
mod edges;
mod extent;
mod normals;
mod quantiles;
mod rays;
mod samples;
mod shapes;
mod shells;
#[cfg(test)]
mod tests;

pub use edges::Edges;
pub use extent::Extent;
pub use normals::Normals;
pub use quantiles::Quantiles;
pub use rays::RayLooks;
pub use samples::{MOST_SAMPLES, Samples};
pub use shapes::Shapes;

use super::mesh::Mesh;
use crate::workload::Ray;
use direction::Direction;
use serde::Serialize;

/// All that is looked at.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Looks {
    /// Size and place.
    pub extent: Extent,
    /// Edges, heights, aspects, zero areas, doubles.
    pub shapes: Shapes,
    /// Which edges triangles share, and whether the surface is closed.
    pub edges: Edges,
    /// Where normals point.
    pub normals: Normals,
    /// Origins, directions, ranges; `None` until rays were looked at.
    pub rays: Option<RayLooks>,
    /// Some rays followed to the triangle that they meet; `None` until then.
    pub samples: Option<Samples>,
}

impl Looks {
    /// Of a mesh; time and memory grow with the number of triangles.
    pub fn of(mesh: &Mesh) -> Self {
        let directions: Vec<Direction> = mesh.list().iter().map(Direction::of).collect();
        let shapes = Shapes::of(mesh, &directions);
        Looks {
            extent: Extent::of(mesh, &shapes),
            edges: Edges::of(mesh),
            normals: Normals::of(&directions),
            shapes,
            rays: None,
            samples: None,
        }
    }

    /// With what rays look like. `nearest` gives the index of the first triangle that a ray meets,
    /// by whichever way; it is asked of some of the rays only.
    pub fn with_rays(
        mut self,
        mesh: &Mesh,
        rays: &[Ray],
        nearest: impl FnMut(&Ray) -> Option<u32>,
    ) -> Self {
        self.rays = Some(RayLooks::of(rays, &mesh.bounds()));
        self.samples = Some(Samples::of(mesh, rays, nearest));
        self
    }

    /// Whether the first triangle that any of the rays meets shows its front, so that backs need not
    /// be tested: the surface is closed and consistent, every shell has its normals outwards, every
    /// ray starts outside the box around all, at t = 0. Where a ray meets an edge exactly, a back
    /// may be met at the same distance. `false` until rays were looked at, and wherever this is not
    /// known.
    pub fn hides_backs(&self) -> bool {
        let Edges { closed, consistent, shells, outward, .. } = self.edges;
        let faces_out = closed && consistent && outward == shells;
        faces_out
            && self.rays.as_ref().is_some_and(|rays| rays.all_outside && rays.moved_starts == 0)
    }
}

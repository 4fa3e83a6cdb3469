//! How large a mesh is and where.

use super::shapes::Shapes;
use crate::number::Precision;
use crate::scene::mesh::Mesh;
use serde::Serialize;

/// Size and place, in units of the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Extent {
    /// Smallest x, y, z.
    pub lowest: [f32; 3],
    /// Largest x, y, z.
    pub highest: [f32; 3],
    /// Length of the box's diagonal.
    pub diagonal: f64,
    /// Largest magnitude of a coordinate.
    pub farthest_coordinate: f64,
    /// Distance of the box's centre from the origin of coordinates.
    pub offset: f64,
    /// That over the diagonal; `None` where all vertices are at one place.
    pub offset_over_size: Option<f64>,
    /// Distance of neighbouring f32 numbers at the farthest coordinate.
    pub ulp: f64,
    /// That over the smallest edge of a triangle with area: at 1, an edge is as short as f32 allows
    /// there. `None` where no triangle has an area.
    pub ulp_over_smallest_edge: Option<f64>,
    /// Farthest coordinate over the smallest height: how many times the rounding of coordinates
    /// grows on its way into u and v, for kernels that use them as they are.
    pub coordinate_over_height: Option<f64>,
    /// Diagonal over the smallest height: the same for kernels that subtract a vertex first.
    pub size_over_height: Option<f64>,
}

impl Extent {
    /// Of a mesh with such triangles.
    pub(super) fn of(mesh: &Mesh, shapes: &Shapes) -> Self {
        let bounds = mesh.bounds();
        let (diagonal, farthest) = (bounds.diagonal(), bounds.largest_coordinate());
        let offset = bounds.centre().length();
        let ulp = Precision::F32.ulp(farthest, 0.0);
        let (edge, height) = (shapes.edge.smallest, shapes.height.smallest);
        Extent {
            lowest: bounds.lowest.to_array(),
            highest: bounds.highest.to_array(),
            diagonal,
            farthest_coordinate: farthest,
            offset,
            offset_over_size: (diagonal > 0.0).then(|| offset / diagonal),
            ulp,
            ulp_over_smallest_edge: edge.map(|edge| ulp / edge),
            coordinate_over_height: height.map(|height| farthest / height),
            size_over_height: height.map(|height| diagonal / height),
        }
    }
}

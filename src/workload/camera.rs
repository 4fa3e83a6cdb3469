//! Where the rays of a picture come from: a pinhole, or from infinitely far.

use super::nearest::{BEYOND, PACKET, ray};
use super::random::{Pcg, Unit};
use super::{Ray, thesis};
use glam::Vec3;

/// Side of the tile of pixels that one packet covers.
const TILE: usize = 4;
/// Distance of the camera from the centre of the scene.
const CAMERA: f32 = 3.0;
/// Where parallel rays go, not normalised: no component is 0 and no two are alike.
const DIRECTION: Vec3 = Vec3::new(1.0, -2.0, 4.0);

/// A pinhole on the negative z axis that looks at the square around the unit ball's equator.
pub(super) struct Camera {
    /// Tiles in a row of the picture.
    columns: usize,
    /// Rows of tiles.
    rows: usize,
}

impl Camera {
    /// As nearly square as tiles allow.
    pub(super) fn new(rays: usize) -> Self {
        let tiles = rays / PACKET;
        let columns = tiles.isqrt() + usize::from(tiles.isqrt().pow(2) < tiles);
        Camera { columns, rows: tiles.div_ceil(columns) }
    }

    /// A random point of pixel `index`, pixels counted tile by tile, in the square from -1 to 1.
    fn point(&self, index: usize, source: &mut Pcg) -> [f32; 2] {
        let (tile, pixel) = (index / PACKET, index % PACKET);
        let column = tile % self.columns * TILE + pixel % TILE;
        let row = tile / self.columns * TILE + pixel / TILE;
        let x = (column as f32 + source.unit()) / (self.columns * TILE) as f32;
        let y = (row as f32 + source.unit()) / (self.rows * TILE) as f32;
        [2.0 * x - 1.0, 2.0 * y - 1.0]
    }

    /// A ray through a random point of pixel `index`.
    pub(super) fn ray(&self, index: usize, source: &mut Pcg) -> Ray {
        let [x, y] = self.point(index, source);
        let origin = Vec3::new(0.0, 0.0, -CAMERA);
        let target = Vec3::new(x, y, 0.0);
        ray(origin, thesis::normalised(target - origin), CAMERA + 1.0 + BEYOND)
    }

    /// A ray along [`DIRECTION`] through a random point of pixel `index`, in the plane across it.
    pub(super) fn parallel_ray(&self, index: usize, source: &mut Pcg) -> Ray {
        let [x, y] = self.point(index, source);
        let direction = thesis::normalised(DIRECTION);
        let right = thesis::normalised(direction.cross(Vec3::Y));
        let up = right.cross(direction);
        let origin = right * x + up * y - direction * CAMERA;
        ray(origin, direction, CAMERA + 1.0 + BEYOND)
    }
}

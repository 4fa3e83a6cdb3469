//! A landscape over a square, z upwards, never steep.

use super::shape::Shape;
use super::{BuiltIn, View};
use crate::workload::{Pcg, Unit};
use glam::Vec3;

pub(super) const TERRAIN: BuiltIn = BuiltIn {
    name: "terrain",
    about: "heights over a square of side 2, no slope above 0.71",
    size: "squares along a side; 2 n^2 triangles",
    usual: 64,
    sizes: [1, 1024],
    build,
};

const SEED: u64 = 2008;
/// Layers of noise, each of half the height and half the spacing of the one before.
const LAYERS: u32 = 4;
/// Spacings along a side, of the first layer.
const COARSEST: usize = 4;
/// Height of the first layer. Within a layer a height falls from its largest to 0 over a spacing at
/// most, 1/16 over 1/2, and so does every other layer; the slope along x is below 4 / 8, so is that
/// along y, and both together are below sqrt(1/2).
const HEIGHT: f32 = 1.0 / 16.0;

/// One layer: heights on a lattice.
struct Layer {
    side: usize,
    heights: Vec<f32>,
}

impl Layer {
    fn new(index: u32, source: &mut Pcg) -> Self {
        let side = COARSEST << index;
        let most = HEIGHT / (1u32 << index) as f32;
        let heights = (0..(side + 1) * (side + 1)).map(|_| most * source.unit()).collect();
        Layer { side, heights }
    }

    /// Linear between the four points of the lattice around (x, y) in the unit square.
    fn at(&self, x: f32, y: f32) -> f32 {
        let (x, y) = (x * self.side as f32, y * self.side as f32);
        let (column, row) = ((x as usize).min(self.side - 1), (y as usize).min(self.side - 1));
        let (x, y) = (x - column as f32, y - row as f32);
        let height = |column: usize, row: usize| self.heights[row * (self.side + 1) + column];
        let lower = height(column, row) * (1.0 - x) + height(column + 1, row) * x;
        let upper = height(column, row + 1) * (1.0 - x) + height(column + 1, row + 1) * x;
        lower * (1.0 - y) + upper * y
    }
}

fn build(cells: u32) -> (Shape, Option<View>) {
    let mut source = Pcg::new(SEED);
    let layers: Vec<Layer> = (0..LAYERS).map(|index| Layer::new(index, &mut source)).collect();
    let mut shape = Shape::default();
    for (row, column) in (0..=cells).flat_map(|row| (0..=cells).map(move |column| (row, column))) {
        let (x, y) = (column as f32 / cells as f32, row as f32 / cells as f32);
        let height = layers.iter().fold(0.0, |sum, layer| sum + layer.at(x, y));
        shape.vertices.push(Vec3::new(2.0 * x - 1.0, 2.0 * y - 1.0, height));
    }
    let at = |row: u32, column: u32| row * (cells + 1) + column;
    for (row, column) in (0..cells).flat_map(|row| (0..cells).map(move |column| (row, column))) {
        let [a, b] = [at(row, column), at(row, column + 1)];
        let [c, d] = [at(row + 1, column + 1), at(row + 1, column)];
        shape.triangles.extend([[a, b, c], [a, c, d]]);
    }
    let view = View {
        eye: Vec3::new(-2.0, -2.5, 2.0),
        target: Vec3::ZERO,
        up: Vec3::Z,
        light: Vec3::new(2.0, -1.0, 3.0),
    };
    (shape, Some(view))
}

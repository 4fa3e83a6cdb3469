//! Triangles that have nothing to do with each other.

use super::shape::Shape;
use super::{BuiltIn, View};
use crate::workload::{Pcg, Unit};
use glam::Vec3;

pub(super) const SOUP: BuiltIn = BuiltIn {
    name: "soup",
    about: "random triangles in a cube of side 2; the more, the smaller",
    size: "triangles",
    usual: 1000,
    sizes: [1, 1 << 20],
    build,
};

const SEED: u64 = 2007;

fn build(count: u32) -> (Shape, Option<View>) {
    let mut source = Pcg::new(SEED);
    // The cube cut into as many small ones as there are triangles; a whole root needs no logarithm.
    let along = (1u64..).find(|along| along.pow(3) >= u64::from(count)).unwrap_or(1);
    let reach = 1.0 / along as f32;
    let mut shape = Shape::default();
    for index in 0..count {
        let centre = point(&mut source);
        shape.vertices.extend([(); 3].map(|()| centre + point(&mut source) * reach));
        shape.triangles.push([0, 1, 2].map(|corner| 3 * index + corner));
    }
    (shape, None)
}

/// A point of the cube from -1 to 1.
fn point(source: &mut Pcg) -> Vec3 {
    // One statement a draw: their order is part of the scene.
    let x = 2.0 * source.unit() - 1.0;
    let y = 2.0 * source.unit() - 1.0;
    let z = 2.0 * source.unit() - 1.0;
    Vec3::new(x, y, z)
}

//! A closed room with things in it, far from the origin of coordinates.

use super::cuboid::{FACES, Front, cuboid};
use super::icosphere::sphere;
use super::shape::Shape;
use super::{BuiltIn, View};
use glam::Vec3;

pub(super) const ROOM_FAR: BuiltIn = BuiltIn {
    name: "room-far",
    about: "a closed room of 4 x 3 x 5 with a sphere and a board in it, 10^5 from the origin along \
            each axis",
    size: "squares along the side of a wall; 24 n^2 + 320 triangles",
    usual: 4,
    sizes: [1, 64],
    build,
};

/// There, f32 numbers are 1/128 apart.
const PLACE: Vec3 = Vec3::splat(1e5);

fn build(cells: u32) -> (Shape, Option<View>) {
    let size = Vec3::new(4.0, 3.0, 5.0);
    let mut shape = cuboid(Vec3::ZERO, size, cells, &FACES, Front::Inside);
    let ball = sphere(2).moved(|point| point * 0.5 + Vec3::new(1.5, 1.75, 2.0));
    shape.add(&ball);
    let [low, high] = [Vec3::new(1.0, 0.7, 1.5), Vec3::new(3.0, 0.8, 3.0)];
    shape.add(&cuboid(low, high, cells, &FACES, Front::Outside));
    let view = View {
        eye: Vec3::new(0.5, 1.6, 4.5) + PLACE,
        target: Vec3::new(2.25, 1.25, 2.0) + PLACE,
        up: Vec3::Y,
        light: Vec3::new(2.0, 2.75, 3.5) + PLACE,
    };
    (shape.moved(|point| point + PLACE), Some(view))
}

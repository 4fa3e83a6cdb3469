//! The room of Goral, Torrance, Greenberg and Battaile, 1984, with the two blocks that later
//! pictures have: open to the viewer, and so not closed.

use super::cuboid::{FACES, Face, Front, cuboid};
use super::shape::Shape;
use super::{BuiltIn, View};
use glam::Vec3;

pub(super) const CORNELL_BOX: BuiltIn = BuiltIn {
    name: "cornell-box",
    about: "an open room of side 2 with two blocks and a panel of light, most walls along axes",
    size: "squares along the side of a wall; 30 n^2 + 2 triangles",
    usual: 4,
    sizes: [1, 128],
    build,
};

/// The side that is left open.
const OPEN: Face = (2, true);
/// The side that blocks stand on.
const BOTTOM: Face = (1, false);
/// A turn of about 16 degrees: 7-24-25 is a right triangle.
const TURN: [f32; 2] = [24.0 / 25.0, 7.0 / 25.0];

fn build(cells: u32) -> (Shape, Option<View>) {
    let walls: Vec<Face> = FACES.into_iter().filter(|face| *face != OPEN).collect();
    let mut shape = cuboid(-Vec3::ONE, Vec3::ONE, cells, &walls, Front::Inside);
    let [cosine, sine] = TURN;
    for (half_height, place, sine) in
        [(0.6, Vec3::new(-0.35, -0.4, -0.3), sine), (0.3, Vec3::new(0.35, -0.7, 0.35), -sine)]
    {
        let half = Vec3::new(0.3, half_height, 0.3);
        let sides: Vec<Face> = FACES.into_iter().filter(|face| *face != BOTTOM).collect();
        let block = cuboid(-half, half, cells, &sides, Front::Outside);
        shape.add(&block.moved(|p| {
            let turned = Vec3::new(cosine * p.x + sine * p.z, p.y, cosine * p.z - sine * p.x);
            turned + place
        }));
    }
    let panel = [[-0.25, -0.25], [0.25, -0.25], [0.25, 0.25], [-0.25, 0.25]];
    shape.quad(panel.map(|[x, z]| Vec3::new(x, 0.99, z)));
    let view = View {
        eye: Vec3::new(0.0, 0.0, 3.9),
        target: Vec3::ZERO,
        up: Vec3::Y,
        light: Vec3::new(0.0, 0.9, 0.0),
    };
    (shape.welded(), Some(view))
}

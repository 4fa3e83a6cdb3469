//! Boxes with faces of many triangles.

use super::shape::Shape;
use glam::Vec3;

/// Which way the front of a face is.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Front {
    /// As of a block that is seen from outside.
    Outside,
    /// As of a room that is seen from inside.
    Inside,
}

/// A face: the axis that it is across, and whether it is at the higher end.
pub(super) type Face = (usize, bool);

/// Every face of a box.
pub(super) const FACES: [Face; 6] =
    [(0, false), (0, true), (1, false), (1, true), (2, false), (2, true)];

/// The faces of a box, each of `cells` x `cells` squares. Faces that meet share vertices.
pub(super) fn cuboid(low: Vec3, high: Vec3, cells: u32, faces: &[Face], front: Front) -> Shape {
    // One rule for an axis, whichever face asks: so neighbours get the same numbers.
    let along = |axis: usize, step: u32| match step {
        step if step == cells => high[axis],
        step => low[axis] + (high[axis] - low[axis]) * (step as f32 / cells as f32),
    };
    let mut shape = Shape::default();
    for &(axis, is_high) in faces {
        let (across, up) = ((axis + 1) % 3, (axis + 2) % 3);
        let point = |i: u32, j: u32| {
            let mut point = Vec3::ZERO;
            point[axis] = if is_high { high[axis] } else { low[axis] };
            point[across] = along(across, i);
            point[up] = along(up, j);
            point
        };
        for (i, j) in (0..cells).flat_map(|i| (0..cells).map(move |j| (i, j))) {
            // Counter-clockwise seen from the higher side of the axis.
            let mut corners = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
            if is_high != (front == Front::Outside) {
                corners.reverse();
            }
            shape.quad(corners);
        }
    }
    shape.welded()
}

//! Where the normals of a mesh point: which coordinate may be dropped to project all triangles.

use super::direction::Direction;
use serde::Serialize;

/// Each list has an entry for the axes x, y, z. Triangles without area have no normal.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Normals {
    /// Triangles whose normal has exactly no component along the axis: seen along it, they are
    /// lines.
    pub edge_on: [u64; 3],
    /// Smallest magnitude of that component over the length of the normal, 0 to 1. 0 exactly where
    /// `edge_on` is not; `None` without triangles that have an area.
    pub smallest_share: [Option<f64>; 3],
    /// Triangles whose normal points to the higher end of the axis.
    pub up: [u64; 3],
    /// Triangles whose normal points to the lower end.
    pub down: [u64; 3],
    /// Whether every triangle with an area has one when projected along the axis: `edge_on` is 0.
    pub can_project: [bool; 3],
    /// Whether all normals point to one end of the axis, so that no two triangles of a height field
    /// overlap by folding: `up` or `down` is the number of triangles with an area.
    pub one_sided: [bool; 3],
    /// The axis (0, 1, 2) with the largest `smallest_share`, if that is above 0.
    pub best_axis: Option<u8>,
}

impl Normals {
    /// Of the directions of triangles.
    pub(super) fn of(directions: &[Direction]) -> Self {
        let mut normals = Normals {
            edge_on: [0; 3],
            smallest_share: [None; 3],
            up: [0; 3],
            down: [0; 3],
            can_project: [true; 3],
            one_sided: [false; 3],
            best_axis: None,
        };
        let mut count = 0;
        for direction in directions.iter().filter(|direction| !direction.is_degenerate()) {
            count += 1;
            (0..3).for_each(|axis| normals.add(direction, axis));
        }
        let of = |axis: usize| normals.smallest_share[axis].unwrap_or_default();
        let best = (1..3).fold(0, |best, axis| if of(axis) > of(best) { axis } else { best });
        normals.best_axis = (normals.edge_on[best] == 0 && of(best) > 0.0).then_some(best as u8);
        normals.can_project = normals.edge_on.map(|edge_on| edge_on == 0);
        normals.one_sided = [0, 1, 2]
            .map(|axis| count > 0 && (normals.up[axis] == count || normals.down[axis] == count));
        normals
    }

    fn add(&mut self, direction: &Direction, axis: usize) {
        let component = direction.components[axis];
        let is_certain = direction.certain[axis];
        self.edge_on[axis] += u64::from(is_certain && component == 0.0);
        self.up[axis] += u64::from(is_certain && component > 0.0);
        self.down[axis] += u64::from(is_certain && component < 0.0);
        let share = component.abs() / direction.length();
        let smallest = &mut self.smallest_share[axis];
        *smallest = Some(smallest.map_or(share, |smallest| smallest.min(share)));
    }
}

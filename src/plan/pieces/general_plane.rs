//! Projecting each triangle along the axis that suits it, where one axis may suit all.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const GENERAL_PLANE: Piece = Piece {
    name: "general plane",
    look,
    done_by: Some(|form| !form.projects_along_z),
    pair: Some([
        "wald/f32/single/{level}/early/last/plain/tuv",
        "wald/f32/single/{level}/early/last/plain/tuv/projection=fixed",
    ]),
};

/// The axis of the forms that project along one.
const Z: usize = 2;

fn look(situation: &Situation) -> Look {
    let normals = &situation.looks.normals;
    if !normals.can_project[Z] {
        return Look::Needed(format!(
            "seen along z, {} triangles are lines, exactly",
            normals.edge_on[Z]
        ));
    }
    let share = normals.smallest_share[Z].unwrap_or_default();
    if share < LEAST_SHARE {
        return Look::Needed(format!("the steepest normal has {share:.1e} of its length along z"));
    }
    Look::Spare(format!(
        "no triangle is a line seen along z: the steepest normal has {share:.2} of its length there"
    ))
}

/// A triangle's own axis has at least 1 / sqrt(3) of its normal's length. Dividing by a component that is
/// smaller by a factor makes rounding larger by that factor; forms are judged by 16 condition numbers, of
/// which projecting tests use a few. At a quarter of the least own share they have four.
const LEAST_SHARE: f64 = 0.577_350_269_189_625_8 / 4.0;

//! A structure that spares a ray most triangles.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const HIERARCHY: Piece = Piece { name: "hierarchy", look, done_by: None, pair: None };

pub(super) fn look(situation: &Situation) -> Look {
    let triangles = situation.crowd.triangles;
    let Some(paths) = &situation.paths else {
        return Look::Needed(format!("{triangles} triangles; going without was not timed"));
    };
    let (name, tests) = (&paths.hierarchy, paths.tests_in_hierarchy);
    let so_many =
        format!("of {triangles} triangles a ray is tested against {tests:.1} in '{name}'");
    match paths.list {
        None => Look::Needed(format!("{so_many}; without it against all")),
        Some(saving) if saving.is_loss() => {
            let times = saving.ratio.estimate;
            Look::Needed(format!("{so_many}; without it a ray takes {times:.1} times as long"))
        }
        Some(saving) => Look::Measured(so_many, saving),
    }
}

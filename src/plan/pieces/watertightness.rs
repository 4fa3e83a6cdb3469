//! That no ray slips through between two triangles.

use super::USUAL;
use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const WATERTIGHTNESS: Piece = Piece {
    name: "watertightness",
    look,
    done_by: Some(|form| form.watertight),
    pair: Some(["woop-watertight/f32/single/{level}/early/last/plain/tuv", USUAL]),
};

fn look(situation: &Situation) -> Look {
    let (edges, pilot) = (&situation.looks.edges, &situation.pilot);
    let shared = edges.manifold + edges.non_manifold;
    if shared == 0 {
        return Look::Spare(
            "no two triangles share an edge: there is nothing to keep tight".into(),
        );
    }
    if pilot.leaks > 0 {
        return Look::Needed(format!(
            "{} of {} rays slip through between triangles, and a watertight test stops them",
            pilot.leaks, pilot.rays
        ));
    }
    Look::Spare(format!(
        "none of {} rays slips through one of the {shared} shared edges",
        pilot.rays
    ))
}

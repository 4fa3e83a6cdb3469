//! Triangles without area.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const DEGENERATE_TRIANGLES: Piece =
    Piece { name: "degenerate triangles", look, done_by: None, pair: None };

fn look(situation: &Situation) -> Look {
    let (none, all) = (situation.looks.shapes.zero_area, situation.looks.shapes.triangles);
    if none > 0 {
        return Look::Needed(format!(
            "{none} of {all} triangles have no area, exactly; that det is not 0 keeps rays from hitting them"
        ));
    }
    Look::Spare(format!(
        "all {all} triangles have an area, exactly: a guard of their own would never be of use. Saves no \
         time: no form here has one"
    ))
}

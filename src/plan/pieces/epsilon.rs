//! A small number that comparisons are made against, as published listings have it.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

/// No form that is timed on rays and many triangles has one.
pub(super) const EPSILON: Piece = Piece { name: "epsilon", look, done_by: None, pair: None };

fn look(situation: &Situation) -> Look {
    let rays = situation.pilot.rays;
    let extent = &situation.looks.extent;
    let size = extent.diagonal;
    Look::Spare(format!(
        "no constant suits a mesh of any size (this one's is {size:.2e}); signs decide, and on {rays} rays \
         the answers stand without. Saves no time: no form here has one"
    ))
}

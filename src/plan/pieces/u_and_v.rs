//! The weights of a hit's vertices.

use super::USUAL;
use crate::plan::form::Output;
use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const U_AND_V: Piece = Piece {
    name: "u and v",
    look,
    done_by: Some(|form| form.output >= Output::Tuv),
    pair: Some([USUAL, "moller-trumbore/f32/single/{level}/early/last/plain/t"]),
};

fn look(situation: &Situation) -> Look {
    let output = situation.wanted.output;
    let word = output.word();
    if output >= Output::Tuv {
        Look::Needed(format!("the caller needs '{word}', which has them"))
    } else {
        Look::Spare(format!("the caller needs '{word}' and reads no weights"))
    }
}

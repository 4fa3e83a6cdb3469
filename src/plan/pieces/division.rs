//! The one division of a test that divides last: whether there is a hit is known before it.

use crate::plan::form::Output;
use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const DIVISION: Piece = Piece {
    name: "division",
    look,
    done_by: Some(|form| form.output > Output::Hit || !form.divides_last),
    pair: Some([
        "moller-trumbore/f32/single/{level}/early/first/plain/hit",
        "moller-trumbore/f32/single/{level}/early/last/plain/hit",
    ]),
};

fn look(situation: &Situation) -> Look {
    let word = situation.wanted.output.word();
    if situation.any_hit() {
        Look::Spare("the caller needs to know of a hit only, which signs tell".into())
    } else {
        Look::Needed(format!("the caller needs '{word}': t is a quotient"))
    }
}

//! Directions of length 1.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const NORMALISED_DIRECTIONS: Piece =
    Piece { name: "normalised directions", look, done_by: None, pair: None };

fn look(situation: &Situation) -> Look {
    let are = match &situation.looks.rays {
        Some(rays) if rays.normalised => "are normalised, which no test makes use of",
        Some(_) => "are not all of length 1, and need not be",
        None => "need no length",
    };
    Look::Spare(format!(
        "t counts lengths of the direction, u and v do not depend on it: these {are}. Saves time where rays \
         are made, none in a test"
    ))
}

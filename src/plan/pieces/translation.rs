//! Subtracting the ray's origin, or a vertex, before multiplying: tests with constants of a plane, or of
//! Pluecker's coordinates, do without.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const TRANSLATION: Piece =
    Piece { name: "translation", look, done_by: Some(|form| form.translates), pair: None };

/// What is subtracted first is as large as the scene, what is not as large as its coordinates. Rounding
/// errors go by that: with an offset of a times the diagonal, coordinates are at most a + 1/2 diagonals,
/// and the condition number with them up to 1 + 2 (a + 1/2) times that without. At a = 1 these are two
/// bits; forms are judged by 16 condition numbers, which are four.
const MOST_OFFSET: f64 = 1.0;

fn look(situation: &Situation) -> Look {
    let extent = &situation.looks.extent;
    let Some(offset) = extent.offset_over_size else {
        return Look::Needed("the mesh has no size".into());
    };
    let far = extent.farthest_coordinate;
    if offset > MOST_OFFSET {
        let bits = (1.0 + 2.0 * (offset + 0.5)).log2();
        return Look::Needed(format!(
            "the mesh lies {offset:.0} times its size from the origin of coordinates (up to {far:.4e}): \
             constants of planes would lose up to {bits:.0} bits"
        ));
    }
    Look::Open(format!(
        "the mesh lies {offset:.2} times its size from the origin of coordinates: nothing cancels"
    ))
}

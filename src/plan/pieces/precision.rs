//! Computing in f64.

use super::USUAL;
use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const F64: Piece = Piece {
    name: "f64",
    look,
    done_by: Some(|form| form.in_f64),
    pair: Some(["moller-trumbore/f64/single/{level}/early/last/plain/tuv", USUAL]),
};

fn look(situation: &Situation) -> Look {
    let pilot = &situation.pilot;
    if pilot.too_coarse > 0 {
        return Look::Needed(format!(
            "on {} of {} rays f32 is wrong by more than rounding of its inputs explains, and f64 is right",
            pilot.too_coarse, pilot.rays
        ));
    }
    let ulp = situation.looks.extent.ulp_over_smallest_edge.unwrap_or_default();
    Look::Spare(format!(
        "on all {} rays f32 is as right as its inputs (neighbouring numbers at the farthest coordinate are \
         {ulp:.1e} of the shortest edge apart)",
        pilot.rays
    ))
}

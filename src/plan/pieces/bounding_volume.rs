//! One box around everything.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const BOUNDING_VOLUME: Piece =
    Piece { name: "bounding volume", look, done_by: None, pair: None };

/// It pays where B + p I < I: here both sides are measured.
fn look(situation: &Situation) -> Look {
    let share = situation.looks.rays.as_ref().map_or(1.0, |rays| rays.box_share);
    let so_many = format!("{:.1} % of the rays meet the box around all triangles", 100.0 * share);
    if !super::hierarchy::look(situation).is_spare() {
        return Look::Needed(format!("{so_many}; it is the root of the hierarchy, which stays"));
    }
    match situation.paths.as_ref().and_then(|paths| paths.without_box) {
        None => Look::Needed(format!("{so_many}; going without was not timed")),
        Some(saving) if saving.is_loss() => {
            let percent = -saving.percent();
            Look::Needed(format!("{so_many}; without it a ray takes {percent:.0} % longer"))
        }
        Some(saving) => Look::Measured(so_many, saving),
    }
}

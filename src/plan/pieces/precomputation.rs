//! Storing more of a triangle than its vertices.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const PRECOMPUTATION: Piece =
    Piece { name: "precomputation", look, done_by: Some(|form| form.prepares), pair: None };

fn look(situation: &Situation) -> Look {
    let tests = situation.crowd.tests_per_triangle();
    let Some(preparing) = &situation.preparing else {
        return Look::Spare(format!(
            "a triangle takes part in {tests:.1} tests; no form that prepares does all that is needed"
        ));
    };
    let (with, ns) = (&preparing.with, preparing.prepare_ns);
    let so_many = format!("a triangle takes part in {tests:.1} tests");
    let because = match preparing.pays_from {
        None => format!("{so_many}, and no test is faster for it ({with})"),
        Some(from) if tests < from => {
            format!("{so_many}; preparing it ({with}, {ns:.1} ns) pays from {from:.1} on")
        }
        Some(from) => {
            return Look::Open(format!(
                "{so_many}; preparing it ({with}, {ns:.1} ns) pays from {from:.1} on"
            ));
        }
    };
    match preparing.saving {
        Some(saving) => Look::Measured(because, saving),
        None => Look::Spare(because),
    }
}

//! The range of t.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const RANGE: Piece = Piece { name: "t range", look, done_by: None, pair: None };

fn look(situation: &Situation) -> Look {
    if !situation.any_hit() {
        return Look::Needed("the nearest of several hits is found by a range that shrinks".into());
    }
    let Some(rays) = &situation.looks.rays else {
        return Look::Needed("nothing is known of the rays".into());
    };
    if rays.open_range {
        let all = rays.rays;
        return Look::Needed(format!(
            "all {all} rays are endless, but what lies behind an origin is no hit; no form leaves the \
             sign of t out"
        ));
    }
    Look::Needed(format!(
        "{} of {} rays end, and {} begin later than at 0",
        rays.finite_ends, rays.rays, rays.moved_starts
    ))
}

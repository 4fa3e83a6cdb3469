//! Back faces: they may be passed over where no ray can see one before a front.

use super::USUAL;
use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const TWO_SIDEDNESS: Piece = Piece {
    name: "two-sidedness",
    look,
    done_by: Some(|form| !form.culls),
    pair: Some([USUAL, "moller-trumbore/f32/single/{level}/early/last/plain/tuv/cull=on"]),
};

/// A ray from outside enters a closed, outward-facing shell through a front before it leaves through a
/// back. Shells may overlap: the first face that is met is the front of one of them.
fn look(situation: &Situation) -> Look {
    let edges = &situation.looks.edges;
    let needed = |because: String| Look::Needed(because);
    if edges.boundary > 0 {
        return needed(format!("{} edges belong to one triangle only: it is open", edges.boundary));
    }
    if edges.non_manifold > 0 {
        let count = edges.non_manifold;
        return needed(format!("{count} edges belong to more than two triangles"));
    }
    if edges.turned > 0 {
        let count = edges.turned;
        return needed(format!(
            "along {count} edges a triangle is turned over beside its neighbour"
        ));
    }
    if !edges.closed || edges.outward < edges.shells {
        let (outward, shells) = (edges.outward, edges.shells);
        return needed(format!("{outward} of {shells} closed parts face outwards"));
    }
    let Some(rays) = &situation.looks.rays else {
        return needed("nothing is known of the rays".into());
    };
    if !rays.all_outside {
        let inside = rays.rays - rays.origins_outside;
        return needed(format!("{inside} of {} rays start inside its box", rays.rays));
    }
    Look::Spare(format!(
        "each of its {} edges belongs to two triangles that face one side, {} of {} closed parts face \
         outwards, and all {} rays start outside",
        edges.manifold, edges.outward, edges.shells, rays.rays
    ))
}

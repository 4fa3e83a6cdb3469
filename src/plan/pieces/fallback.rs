//! What a watertight test does where an edge function is 0 in f32: compute it again with more digits.

use crate::plan::piece::{Look, Piece};
use crate::plan::situation::Situation;

pub(super) const FALLBACK: Piece = Piece {
    name: "fallback",
    look,
    done_by: Some(|form| form.falls_back),
    pair: Some([
        "woop-watertight/f32/single/{level}/early/last/plain/tuv",
        "woop-watertight/f32/single/{level}/early/last/plain/tuv/edges=no-fallback",
    ]),
};

fn look(situation: &Situation) -> Look {
    let samples = situation.looks.samples.as_ref();
    let near = samples.map_or(0.0, |samples| samples.near_edge_share);
    let rays = samples.map_or(0, |samples| samples.rays);
    // Without it a ray on an edge may hit both of its triangles. That changes which of two equally near
    // triangles is told, and what is odd or even; nobody here counts crossings.
    Look::Spare(format!(
        "it keeps rays on an edge from hitting both triangles, which is for those who count crossings; of \
         {rays} rays a share of {near:.1e} is within rounding of an edge"
    ))
}

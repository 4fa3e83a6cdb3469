//! THE list of pieces: a new one is a file and a line here.

mod bounding_volume;
mod degenerate;
mod division;
mod epsilon;
mod fallback;
mod general_plane;
mod hierarchy;
mod normalised;
mod precision;
mod precomputation;
mod range;
#[cfg(test)]
mod tests;
mod translation;
mod two_sidedness;
mod u_and_v;
mod watertightness;

use super::piece::Piece;

/// All of them, in the order in which plans tell them.
pub static PIECES: [Piece; 15] = [
    two_sidedness::TWO_SIDEDNESS,
    u_and_v::U_AND_V,
    division::DIVISION,
    range::RANGE,
    general_plane::GENERAL_PLANE,
    translation::TRANSLATION,
    precomputation::PRECOMPUTATION,
    precision::F64,
    watertightness::WATERTIGHTNESS,
    fallback::FALLBACK,
    bounding_volume::BOUNDING_VOLUME,
    hierarchy::HIERARCHY,
    epsilon::EPSILON,
    normalised::NORMALISED_DIRECTIONS,
    degenerate::DEGENERATE_TRIANGLES,
];

/// The usual test, and what it is without one thing.
const USUAL: &str = "moller-trumbore/f32/single/{level}/early/last/plain/tuv";

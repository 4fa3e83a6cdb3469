//! What a figure shows, in a sentence computed from its numbers.

mod bars;
mod heat;
mod lines;
mod named;
mod others;

use crate::chart::{Figure, Kind, Numbers};
use named::Named;

/// The sentence. It says who is best and by how much, panel by panel, whether the intervals tell
/// them apart, and how far what was published is from it.
pub(super) fn sentence(figure: &Figure, numbers: &Numbers) -> String {
    let named = Named { figure };
    let words = match numbers {
        Numbers::Points { ours, published, bounds } if figure.kind == Kind::Lines => {
            debug_assert!(bounds.is_empty());
            lines::sentence(&named, ours, published)
        }
        Numbers::Points { ours, published, bounds } => {
            bars::sentence(&named, ours, published, bounds)
        }
        Numbers::Shares { ours, published, ours_below, .. } => {
            others::shares(&named, ours, published, ours_below)
        }
        Numbers::Counts(counts) => others::counts(&named, counts),
        Numbers::Fields(fields) => heat::sentence(&named, fields),
        Numbers::Dots(dots) => others::dots(&named, dots),
    };
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

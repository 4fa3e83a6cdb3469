//! What a figure shows, in sentences computed from its numbers.

mod bars;
mod heat;
mod lines;
mod named;
mod others;
mod predicted;

use crate::chart::{Figure, Kind, Numbers};
use named::Named;

/// The sentences, one for each panel and one for what was published: who is best and by how much,
/// and whether the intervals tell them apart.
pub(super) fn sentences(figure: &Figure, numbers: &Numbers) -> Vec<String> {
    let named = Named { figure };
    let mut parts = match numbers {
        Numbers::Points { ours, published, .. } if figure.kind == Kind::Lines => {
            let predicted = predicted::sentences(&named, ours);
            predicted.unwrap_or_else(|| lines::sentences(&named, ours, published))
        }
        Numbers::Points { ours, published, .. } => bars::sentences(&named, ours, published),
        Numbers::Shares { ours, published, ours_below, .. } => {
            others::shares(&named, ours, published, ours_below)
        }
        Numbers::Counts(counts) => vec![others::counts(&named, counts)],
        Numbers::Fields(fields) => vec![heat::sentence(&named, fields)],
        Numbers::Dots(dots) => others::dots(&named, dots),
    };
    parts.retain(|part| !part.is_empty());
    parts
}

//! Stored rows -> the variant to take, the rows that say so, and what the next best costs.
//!
//! This is the only rule by which anything is chosen: [`recommend`] puts it into words for whoever
//! asks, and the report asks it ([`choose`]) the questions that it answers at its top.
//!
//! Only times of the same rays, triangles and order are held against each other (`arena`). What a
//! variant can do beyond its rows comes from outside, as [`KnownVariant`]: nothing here can run one.

mod answer;
mod arena;
mod because;
mod candidates;
mod choice;
mod evidence;
mod found;
mod place;
mod preparing;
mod question;
mod settings;
#[cfg(test)]
mod tests;

pub use answer::{Recommendation, recommend};
pub use choice::{Behind, Choice, choose};
pub use question::{KnownVariant, Needs, Packets, Question};

/// Why nothing can be recommended.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum RecommendError {
    /// The rows hold no time.
    #[error(
        "there are no times in {0}; allowed: a folder that `ray_test run` or `reproduce` wrote"
    )]
    NoTimes(String),
    /// Nothing that was timed fits.
    #[error(
        "none of the {timed} variants timed in {folders} fits: {reasons}. Allowed: fewer demands, or rows of more variants"
    )]
    NothingFits {
        /// Variants with times.
        timed: usize,
        /// Where they are from.
        folders: String,
        /// How many are left out for what reason.
        reasons: String,
    },
}

//! Anyone's cases against the exact answer: what the kernels say of them, or somebody else's
//! program, and how far that is off.
//!
//! ```text
//! read::Cases ─> Case ─> Query (rounded) ─> Known ─┬─> Judged
//! read::Answers, or a kernel's form ─────> Reply ──┘
//! ```
//! One case is held at a time, so a file of any length is judged in the same memory.

mod case;
mod forms;
mod judged;
mod known;
#[cfg(feature = "cli")]
pub mod read;
mod reply;
mod segment;
#[cfg(test)]
mod tests;

pub use crate::number::Precision;
pub use case::{Case, NUMBERS, Number};
pub use forms::{form, kernels};
pub use judged::{Judged, Verdict};
pub use known::{Known, Place};
pub use reply::Reply;

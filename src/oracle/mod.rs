//! The exact answer for one ray against one triangle, for every finite input.
//!
//! It is written from the signs of orientation determinants and imports no kernel, so a kernel
//! that agrees with it agrees with the geometry, not with another kernel. Three stages, each used
//! only where the one before cannot be certain:
//!
//! 1. `filter`: the five determinants in f64, each with a bound on its error. Decides nearly every
//!    case that is not an exact boundary, in some tens of nanoseconds.
//! 2. `numerators` in `i128`, when the bits that the inputs span leave room, a few
//!    times as long.
//! 3. `numerators` in big integers (`dashu`), always: some microseconds, and as long for the values
//!    of any case, whose first 105 bits and more are kept.
//!
//! [`stage`] tells which one decides; `ray_test doctor --oracle` times each.
//!
//! Every finite float is an integer times a power of two, so no rational arithmetic is needed: the
//! only quotients are the values that are reported, and those are rounded once, correctly.
//!
//! ```text
//! Query -> filter -> Class            (classify)
//!       -> aligned -> numerators -> Class, ratio -> Exact   (solve)
//!                                         Exact -> Condition -> excusable
//! ```

mod aligned;
mod class;
mod condition;
mod exact;
mod filter;
mod integer;
mod nearest;
mod numerators;
mod query;
mod ratio;

#[cfg(test)]
mod draws;
#[cfg(test)]
mod reference;
#[cfg(test)]
mod tests;

pub use class::Class;
pub use condition::{Condition, condition, excusable, output_error_limit};
pub use exact::{Exact, Stage, classify, solve, stage};
pub use nearest::nearest;
pub use query::Query;

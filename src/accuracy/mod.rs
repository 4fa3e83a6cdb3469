//! Answers against the exact ones: what is wrong, what rounding excuses, how large errors are.

mod judge;
mod surface;
#[cfg(test)]
mod tests;
mod truth;

pub use judge::{Judgement, Reported, judge, judge_nearest};
pub use truth::{NearestTruth, Truth};

//! Answers against the exact ones: what is wrong, what rounding excuses, how large errors are.

mod bits_lost;
mod case;
mod deviation;
mod judge;
mod measures;
#[cfg(test)]
mod measures_tests;
mod quantiles;
mod reported;
mod samples;
mod summary;
mod surface;
#[cfg(test)]
mod tests;
mod truth;

pub use judge::{Judgement, judge, judge_nearest};
pub use measures::Measures;
pub use quantiles::Quantiles;
pub use reported::Reported;
pub use summary::Accuracy;
pub use truth::{NearestTruth, Truth};

//! Textbook statistics for few, noisy, skewed numbers: medians, exact order-statistic intervals,
//! sign tests, Holm's correction. Nothing here knows of clocks or kernels, nothing draws random
//! numbers, and nothing but [`normal_quantile`] is about one distribution.

mod holm;
mod median;
mod normal;
mod ratio;
mod sign;
mod verdict;

pub use holm::holm;
pub use median::median;
pub use normal::normal_quantile;
pub use ratio::{Ratio, log_ratios, paired_ratio};
pub use sign::{CONFIDENCE, Interval, binomial_half, sign_interval, sign_test};
pub use verdict::{Decision, LEVEL, Verdict, decide};

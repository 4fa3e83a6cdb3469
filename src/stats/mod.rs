//! Textbook statistics for few, noisy, skewed numbers: medians, exact order-statistic intervals,
//! sign tests, Holm's correction. Nothing here knows of clocks or kernels, nothing draws random
//! numbers, and nothing assumes a distribution.

mod holm;
mod median;
mod ratio;
mod sign;

pub use holm::holm;
pub use median::median;
pub use ratio::{Ratio, paired_ratio};
pub use sign::{CONFIDENCE, Interval, binomial_half, sign_interval, sign_test};

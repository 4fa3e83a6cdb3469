//! What a precision is expected to be good for.

pub use crate::number::{Precision, power_of_two};

impl Precision {
    /// The error at which a kernel is said to fail: one in a thousand leaves a few digits of a f32
    /// picture; f64 is bought for nine.
    pub fn knee_error(self) -> f64 {
        match self {
            Precision::F32 => 1e-3,
            Precision::F64 => 1e-9,
        }
    }
}

/// `10^exponent`, correctly rounded, so that it is the same on every machine; 0 and infinity
/// beyond the range.
pub fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

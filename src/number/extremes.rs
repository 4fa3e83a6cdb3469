//! The larger and the smaller of two numbers, and masks as bits: for searches, not for kernels.

use super::Real;

/// Numbers that can be sorted. Kernels do without: which of two zeros is the larger differs between
/// levels, and so does what becomes of NaN.
pub trait Extremes: Real {
    /// The larger of both, neither of which is NaN; of two zeros, either.
    fn larger(self, other: Self) -> Self;
    /// The smaller of both, likewise.
    fn smaller(self, other: Self) -> Self;
    /// Bit i is set where lane i is.
    fn bits(mask: Self::Mask) -> u64;
}

impl Extremes for f32 {
    #[inline(always)]
    fn larger(self, other: f32) -> f32 {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn smaller(self, other: f32) -> f32 {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn bits(mask: bool) -> u64 {
        mask.into()
    }
}

//! Bits turned over: what flips of signs come down to.

use super::Real;

/// Numbers whose bits can be turned over.
pub trait Toggle: Real {
    /// `self` with those bits turned over that are set in `bits`: one exclusive or.
    fn toggled(self, bits: Self) -> Self;
}

impl Toggle for f32 {
    #[inline(always)]
    fn toggled(self, bits: f32) -> f32 {
        f32::from_bits(self.to_bits() ^ bits.to_bits())
    }
}

impl Toggle for f64 {
    #[inline(always)]
    fn toggled(self, bits: f64) -> f64 {
        f64::from_bits(self.to_bits() ^ bits.to_bits())
    }
}

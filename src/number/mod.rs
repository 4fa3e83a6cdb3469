//! What a number is: the smallest set of operations that every kernel is written over.
//!
//! | type | what comes out of a kernel's one source |
//! |---|---|
//! | `f32`, `f64` | the single-ray forms |
//! | [`Lanes`] | packets: one lane a ray, in the registers of an instruction-set level |
//! | [`Twice`] | packets of two registers, or of four |
//! | [`Xyz`] | single rays, a vector in a register |
//! | [`Counted`] | the operations that a test executes, by kind |
//! | [`Traced`] | the operations that an optimiser leaves of a test |
//! | [`Flushed`] | what a processor computes that flushes subnormal numbers to zero |
//! | `Exact` (tests) | rational numbers: the algebra without rounding |
//!
//! What is absent matters as much: no `min`, `max` or `abs` (they differ between levels for signed
//! zeros and NaN; kernels build them from a comparison and [`Real::signed_by`]).

mod axis;
mod counted;
mod extremes;
mod flushed;
mod lanes;
mod masked;
mod precision;
mod scalar;
mod shuffled;
mod spread;
mod toggle;
mod traced;
mod twice;
mod vector;
mod xyz;

pub use axis::{Axis, dominant};
pub use counted::{Counted, Operations, count};
pub use extremes::Extremes;
pub use flushed::Flushed;
pub use lanes::{LaneMask, Lanes};
pub use precision::{Precision, exponent, power_of_two};
pub use spread::Spread;
pub(crate) use spread::spread;
pub use toggle::Toggle;
pub use traced::{Needed, Noted, Place, Traced, TracedMask, TracedOne, needed};
pub use twice::Twice;
pub use vector::Vec3;
pub use xyz::{FirstLane, Horizontal, Instruction, Summing, Xyz};

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// The answer of a comparison: one truth value per lane.
pub trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// Number of lanes.
    const LANES: usize;
    /// True if any lane is.
    fn any(self) -> bool;
    /// The truth value of one lane; `lane` is below [`Real::LANES`].
    fn lane(self, lane: usize) -> bool;
}

/// A number, or one number per lane.
///
/// Comparisons with NaN are false, `ne` included excepted (`NaN != x` is true, as in IEEE 754),
/// so a kernel that asks for what must hold, and never for what must not, misses on NaN.
pub trait Real:
    Copy
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// What comparisons give.
    type Mask: Mask;
    /// What memory holds of one lane.
    type Element: Element;
    /// Proof that the processor has the lanes' instructions; `()` for scalars.
    type Token: Copy;
    /// Number of lanes.
    const LANES: usize;

    /// The token that `self` was made with.
    fn token(self) -> Self::Token;
    /// The same element in every lane.
    fn splat(token: Self::Token, element: Self::Element) -> Self;
    /// The first [`Real::LANES`] elements of `elements`, which holds at least as many.
    fn load(token: Self::Token, elements: &[Self::Element]) -> Self;
    /// Writes the lanes to the first [`Real::LANES`] places of `elements`.
    fn store(self, elements: &mut [Self::Element]);
    /// `truth` in every lane.
    fn mask(token: Self::Token, truth: bool) -> Self::Mask;

    /// `self < other`.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`.
    fn le(self, other: Self) -> Self::Mask;
    /// `self > other`.
    fn gt(self, other: Self) -> Self::Mask;
    /// `self >= other`.
    fn ge(self, other: Self) -> Self::Mask;
    /// `self != other`.
    fn ne(self, other: Self) -> Self::Mask;
    /// `mask` where also `self < other`: one instruction where there is one for both, else two.
    #[inline(always)]
    fn lt_where(self, other: Self, mask: Self::Mask) -> Self::Mask {
        mask & self.lt(other)
    }
    /// `mask` where also `self <= other`.
    #[inline(always)]
    fn le_where(self, other: Self, mask: Self::Mask) -> Self::Mask {
        mask & self.le(other)
    }
    /// `mask` where also `self >= other`.
    #[inline(always)]
    fn ge_where(self, other: Self, mask: Self::Mask) -> Self::Mask {
        mask & self.ge(other)
    }
    /// `mask` where also `self != other`.
    #[inline(always)]
    fn ne_where(self, other: Self, mask: Self::Mask) -> Self::Mask {
        mask & self.ne(other)
    }
    /// `yes` where `mask` holds, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// [`Real::select`] of several at once, without a jump. A scalar blends bits by a mask that the
    /// optimiser cannot look through: a plain select becomes a jump, with a division behind it.
    #[inline(always)]
    fn blend<const N: usize>(mask: Self::Mask, yes: [Self; N], mut no: [Self; N]) -> [Self; N] {
        for (no, yes) in no.iter_mut().zip(yes) {
            *no = Self::select(mask, yes, *no);
        }
        no
    }
    /// `self` with its sign flipped where the sign bit of `sign` is set (exact types: where it is
    /// negative). `x.signed_by(x)` is the magnitude of `x`.
    fn signed_by(self, sign: Self) -> Self;
    /// Where the sign bit is set: -0 and negative NaN count.
    fn sign_bit(self) -> Self::Mask;
    /// A number whose sign bit is set where either's is; nothing else of it means anything.
    #[inline(always)]
    fn either_sign(self, other: Self) -> Self {
        Self::select(self.sign_bit(), self, other)
    }
    /// 1 / self, roughly: the estimate of the processor where the lanes of a level have one, else the
    /// quotient itself. Of f32, the relative error is below 1.5 * 2^-12 on x86 (Intel's and AMD's
    /// manuals, RCPPS; 2^-14 with AVX-512, VRCP14PS) and below 2^-8 on AArch64. Of numbers below
    /// the least normal one or above 2^126 it may be infinite or zero.
    #[inline(always)]
    fn estimated_inverse(self) -> Self {
        self.one() / self
    }
    /// `self * factor + addend` with one rounding. Only the `fused` forms call it, and only levels
    /// with the instruction have them.
    fn mul_add(self, factor: Self, addend: Self) -> Self;

    /// `self` + 1, of a number that is the same in every lane: one addition, however many registers.
    #[inline(always)]
    fn successor(self) -> Self {
        self + self.one()
    }
    /// The vector of three in a row of four numbers, the first at place `from`: 0 or 1. This and the two
    /// that follow are for numbers that can be a whole vector ([`Xyz`]); others take a vector for one of
    /// a single number, and nobody asks them.
    #[inline(always)]
    fn vector(token: Self::Token, numbers: &[Self::Element], from: usize) -> Self {
        Self::load(token, &numbers[from..])
    }
    /// The dot product of two vectors.
    #[inline(always)]
    fn vector_dot(self, other: Self) -> Self {
        self * other
    }
    /// The cross product of two vectors.
    #[inline(always)]
    fn vector_cross(self, _other: Self) -> Self {
        self.zero()
    }

    /// `element` in every lane, with the token of `self`.
    #[inline(always)]
    fn like(self, element: Self::Element) -> Self {
        Self::splat(self.token(), element)
    }
    /// Zero in every lane.
    #[inline(always)]
    fn zero(self) -> Self {
        self.like(Self::Element::ZERO)
    }
    /// One in every lane.
    #[inline(always)]
    fn one(self) -> Self {
        self.like(Self::Element::ONE)
    }
}

/// A number that memory holds: a scalar whose masks are `bool`.
pub trait Element: Real<Element = Self, Mask = bool, Token = ()> {
    /// A number that holds products of two of these exactly: f64 for f32. Where there is none, the
    /// number itself.
    type Wide: Element;
    /// The column `precision`.
    const NAME: &'static str;
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// The largest number whose reciprocal can overflow: the largest subnormal; 0 for exact types.
    const LARGEST_SUBNORMAL: Self;
    /// Half the distance from 1 to the next number; 0 for exact types.
    const UNIT_ROUNDOFF: Self;
    /// The distance from 1 to the next number, twice the unit roundoff; 0 for exact types.
    const EPSILON: Self;
    /// The largest finite number.
    const MAX: Self;
    /// What a number is multiplied by to be split into two halves whose products are exact
    /// (Veltkamp): 2 to the half of the digits, rounded up, plus 1. Exact types split at any.
    const SPLITTER: Self;
    /// The exact value of an f32 (`value` is finite).
    fn from_f32(value: f32) -> Self;
    /// The number nearest to `value` (which is finite).
    fn from_f64(value: f64) -> Self;
    /// The nearest f64.
    fn to_f64(self) -> f64;
    /// The same number, wider.
    fn widened(self) -> Self::Wide;
    /// The number nearest to `wide`.
    fn narrowed(wide: Self::Wide) -> Self;
    /// The bit pattern, zero-extended (0 for types that have none).
    fn bits(self) -> u64;
    /// The number with that bit pattern ([`Element::ZERO`] for types that have none).
    fn from_bits(bits: u64) -> Self;
    /// An index below 3 as a number that memory holds, and that compares with others of its kind.
    fn from_index(index: u32) -> Self {
        Self::from_f32(index as f32)
    }
    /// The index that [`Element::from_index`] made a number of.
    fn index(self) -> u32 {
        self.to_f64() as u32
    }
    /// Square root, for what is prepared and for the sum of angles.
    fn sqrt(self) -> Self;
    /// Arc cosine from `libm`, the same on every machine; only the sum of angles calls it.
    fn acos(self) -> Self;
    /// An if-statement of a published listing: `Counted` counts it, others pass it on.
    #[inline(always)]
    fn condition(truth: bool) -> bool {
        truth
    }
}

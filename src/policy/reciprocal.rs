//! The axis `reciprocal`: how a number is divided by.

use super::{Facing, Policy, Tests};
use crate::number::Real;

/// How reciprocals are computed.
pub trait Reciprocal: Copy + 'static {
    /// The column `reciprocal`.
    const NAME: &'static str;
    /// 1 / x, or what is taken for it.
    fn of<P: Policy, R: Real>(x: R) -> R;
    /// `numerator` / x, or what is taken for it.
    fn quotient<P: Policy, R: Real>(numerator: R, x: R) -> R;
    /// Where x can be divided by before anything is tested; with culling, where it is positive.
    fn divisible<P: Policy, R: Real>(x: R) -> R::Mask;
    /// `mask` where a reciprocal is one of a finite number.
    fn usable<R: Real>(mask: R::Mask, inverse: R) -> R::Mask;
}

/// The division of the processor, rounded once.
#[derive(Clone, Copy)]
pub struct Divide;

/// The processor's estimate ([`Real::estimated_inverse`]), and so many of Newton's steps
/// y + y (1 - x y), each of which squares the relative error and adds its own rounding.
///
/// Other numbers than f32 in the lanes of a level have no estimate and divide. Estimates differ
/// between levels and between processors, and so do the bits of all that is computed with them.
/// Divided last, the tests are those of a true division and only what is reported is inexact;
/// divided first, decisions near edges are as inexact as the estimate.
///
/// The estimate of a subnormal number can be infinite, and that of a number above 2^126 can be 0;
/// from either a step can make NaN. What is infinite or NaN lies in no range and is no hit; a zero is
/// asked for, as it would put everything at t = u = v = 0. Divided last, subnormal determinants were
/// refused before.
#[derive(Clone, Copy)]
pub struct Estimated<const STEPS: usize>;

impl Reciprocal for Divide {
    const NAME: &'static str = "divide";
    #[inline(always)]
    fn of<P: Policy, R: Real>(x: R) -> R {
        x.one() / x
    }
    #[inline(always)]
    fn quotient<P: Policy, R: Real>(numerator: R, x: R) -> R {
        numerator / x
    }
    /// A quotient by 0 is infinite or NaN. A search for the nearest hit takes neither, so that its packets
    /// need not ask. Nor need tests that refuse NaN at the end: where u or v is infinite, it or 1 - u - v
    /// is negative or NaN, and an infinite t is in no range.
    #[inline(always)]
    fn divisible<P: Policy, R: Real>(x: R) -> R::Mask {
        if P::Facing::CULLS {
            x.gt(x.zero())
        } else if P::Tests::LEAVES_NAN || (R::LANES > 1 && P::LEAVES_BOUND) {
            R::mask(x.token(), true)
        } else {
            x.ne(x.zero())
        }
    }
    #[inline(always)]
    fn usable<R: Real>(mask: R::Mask, inverse: R) -> R::Mask {
        inverse.ne_where(inverse.zero(), mask)
    }
}

impl<const STEPS: usize> Reciprocal for Estimated<STEPS> {
    const NAME: &'static str = match STEPS {
        0 => "estimate",
        1 => "newton",
        _ => "newton-2",
    };
    #[inline(always)]
    fn of<P: Policy, R: Real>(x: R) -> R {
        let mut inverse = x.estimated_inverse();
        for _ in 0..STEPS {
            let rest = P::multiply_add(-x, inverse, x.one());
            inverse = P::multiply_add(inverse, rest, inverse);
        }
        inverse
    }
    #[inline(always)]
    fn quotient<P: Policy, R: Real>(numerator: R, x: R) -> R {
        numerator * Self::of::<P, R>(x)
    }
    /// A positive number has a positive estimate.
    #[inline(always)]
    fn divisible<P: Policy, R: Real>(x: R) -> R::Mask {
        let inverse = Self::of::<P, R>(x);
        if P::Facing::CULLS {
            inverse.gt(x.zero())
        } else {
            Self::usable(R::mask(x.token(), true), inverse)
        }
    }
    #[inline(always)]
    fn usable<R: Real>(mask: R::Mask, inverse: R) -> R::Mask {
        inverse.zero().lt_where(inverse.signed_by(inverse), mask)
    }
}

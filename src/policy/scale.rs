//! Dividing first or last (thesis H, 4.2.4).

use super::{Policy, Reciprocal, Tests};
use crate::number::{Element, Real};

/// What numerators are compared with.
#[derive(Clone, Copy)]
pub struct Scale<R> {
    /// `first`: what numerators are multiplied by. `last`: the number whose sign they are flipped by.
    pub factor: R,
    /// What 1 is, in the scale of the numerators.
    pub one: R,
}

/// When the determinant is divided by.
pub trait Division: Copy + 'static {
    /// The column `division`.
    const NAME: &'static str;
    /// Quotients are computed behind the tests, where they can still overflow.
    const BEHIND_TESTS: bool;
    /// See [`Policy::divisible`].
    fn divisible<P: Policy, R: Real>(det: R) -> R::Mask;
    /// See [`Policy::divide`].
    fn divide<P: Policy, R: Real>(det: R) -> Scale<R>;
    /// See [`Policy::signed`].
    fn signed<P: Policy, R: Real>(numerator: R, scale: Scale<R>) -> R;
    /// See [`Policy::quotient`].
    fn quotient<P: Policy, R: Real>(numerator: R, det: R) -> (R, Scale<R>);
    /// See [`Policy::scaled`].
    fn scaled<R: Real>(value: R, scale: Scale<R>) -> R;
    /// See [`Policy::divided`].
    fn divided<P: Policy, R: Real>(det: R) -> R;
    /// See [`Policy::divided_by`].
    fn divided_by<P: Policy, R: Real>(det: R, divided: R) -> (Scale<R>, R);
    /// What [`Division::resolve`] multiplies by.
    fn inverse<P: Policy, R: Real>(scale: Scale<R>) -> R;
    /// A numerator with its division done.
    fn resolve<R: Real>(numerator: R, inverse: R) -> R;
}

/// Divide as soon as the determinant is known: the division overlaps with what follows.
#[derive(Clone, Copy)]
pub struct First;
/// Compare numerators and divide behind all tests: misses never divide.
#[derive(Clone, Copy)]
pub struct Last;

impl Division for First {
    const NAME: &'static str = "first";
    const BEHIND_TESTS: bool = false;
    #[inline(always)]
    fn divisible<P: Policy, R: Real>(det: R) -> R::Mask {
        P::Reciprocal::divisible::<P, R>(det)
    }
    #[inline(always)]
    fn divide<P: Policy, R: Real>(det: R) -> Scale<R> {
        Scale { factor: P::Reciprocal::of::<P, R>(det), one: det.one() }
    }
    #[inline(always)]
    fn signed<P: Policy, R: Real>(numerator: R, scale: Scale<R>) -> R {
        numerator * scale.factor
    }
    #[inline(always)]
    fn quotient<P: Policy, R: Real>(numerator: R, det: R) -> (R, Scale<R>) {
        let quotient = P::Reciprocal::quotient::<P, R>(numerator, det);
        (quotient, Scale { factor: det.one(), one: det.one() })
    }
    #[inline(always)]
    fn scaled<R: Real>(value: R, _: Scale<R>) -> R {
        value
    }
    #[inline(always)]
    fn divided<P: Policy, R: Real>(det: R) -> R {
        Self::divide::<P, R>(det).factor
    }
    #[inline(always)]
    fn divided_by<P: Policy, R: Real>(det: R, divided: R) -> (Scale<R>, R) {
        (Scale { factor: divided, one: det.one() }, det.one())
    }
    #[inline(always)]
    fn inverse<P: Policy, R: Real>(scale: Scale<R>) -> R {
        scale.one
    }
    #[inline(always)]
    fn resolve<R: Real>(numerator: R, _: R) -> R {
        numerator
    }
}

impl Division for Last {
    const NAME: &'static str = "last";
    const BEHIND_TESTS: bool = true;
    /// The reciprocal of a subnormal can overflow, and a hit must never be non-finite; hits lost
    /// here are a finding about tiny triangles. An infinite determinant shows in its reciprocal, see
    /// [`Policy::finish`]. Sign bits, as printed, test nothing.
    #[inline(always)]
    fn divisible<P: Policy, R: Real>(det: R) -> R::Mask {
        if P::Tests::SIGN_BITS {
            return R::mask(det.token(), true);
        }
        let magnitude = if P::FLIPS { det.signed_by(det) } else { det };
        magnitude.gt(det.like(R::Element::LARGEST_SUBNORMAL))
    }
    #[inline(always)]
    fn divide<P: Policy, R: Real>(det: R) -> Scale<R> {
        Scale { factor: det, one: if P::FLIPS { det.signed_by(det) } else { det } }
    }
    #[inline(always)]
    fn signed<P: Policy, R: Real>(numerator: R, scale: Scale<R>) -> R {
        if P::FLIPS { numerator.signed_by(scale.factor) } else { numerator }
    }
    #[inline(always)]
    fn quotient<P: Policy, R: Real>(numerator: R, det: R) -> (R, Scale<R>) {
        let scale = Self::divide::<P, R>(det);
        (Self::signed::<P, R>(numerator, scale), scale)
    }
    #[inline(always)]
    fn scaled<R: Real>(value: R, scale: Scale<R>) -> R {
        value * scale.one
    }
    #[inline(always)]
    fn divided<P: Policy, R: Real>(det: R) -> R {
        Self::inverse::<P, R>(Self::divide::<P, R>(det))
    }
    #[inline(always)]
    fn divided_by<P: Policy, R: Real>(det: R, divided: R) -> (Scale<R>, R) {
        (Self::divide::<P, R>(det), divided)
    }
    #[inline(always)]
    fn inverse<P: Policy, R: Real>(scale: Scale<R>) -> R {
        P::Reciprocal::of::<P, R>(scale.one)
    }
    #[inline(always)]
    fn resolve<R: Real>(numerator: R, inverse: R) -> R {
        numerator * inverse
    }
}

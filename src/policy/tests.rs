//! The axis `tests`: how the signs of a test are compared.

use super::Span;
use crate::number::Real;

/// How signs are tested.
pub trait Tests: Copy + 'static {
    /// The column `tests_form`.
    const NAME: &'static str;
    /// Sign bits are compared, and nothing is flipped by the sign of a determinant.
    const SIGN_BITS: bool;
    /// Signs of products are compared (Chirkov's published form).
    const PRODUCTS: bool;
    /// What a hit reports need not be finite: the form is kept as it was published.
    const AS_PUBLISHED: bool = Self::SIGN_BITS || Self::PRODUCTS;
    /// The tests may let a NaN pass, which is looked for in what they leave.
    const LEAVES_NAN: bool = false;
    /// Where `t` is in `[lower, upper]`.
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask;
    /// `mask` where a number, t or a weight, is not negative. Not asked of sign bits as printed, which
    /// flip nothing.
    #[inline(always)]
    fn ahead<R: Real>(mask: R::Mask, t: R) -> R::Mask {
        t.ge_where(t.zero(), mask)
    }
    /// `mask` where `u` is in `[0, one]`.
    fn share<R: Real>(mask: R::Mask, u: R, one: R) -> R::Mask;
    /// `mask` where `v` and one - u - v are not negative, `u` being known not to be.
    fn beside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask;
    /// `mask` where u, v and one - u - v are not negative.
    fn inside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask;
}

/// Comparisons that ask for what must hold: NaN misses, boundaries hit.
#[derive(Clone, Copy)]
pub struct Compare;
/// Thesis H, text 9: equal sign bits, as printed. Loses hits on boundaries where a sum is -0 or
/// rounds to the other side, takes a zero determinant, and reports NaN.
#[derive(Clone, Copy)]
pub struct SignBits;
/// Sign bits as integers again, but with the decisions of [`Compare`], all of them.
///
/// For x that is not NaN, x >= 0 exactly if the sign bit of x + 0 is clear: adding +0 changes nothing
/// but turns -0 into +0. And x <= y, y not being -0, exactly if the sign bit of y - x is clear: with
/// subnormal numbers a difference is zero only of equals, that zero is then +0, and rounding changes
/// no sign. Bits that must be clear are united by `or` and asked for at once: one jump where
/// comparisons have two or three.
///
/// A NaN has either sign. Where one passes, the sum of t, u and v is NaN, and [`Policy::finish`]
/// refuses it by one ordered comparison, which is for hits alone. Where two infinities are subtracted
/// the determinant or t is infinite, and no form takes that for a hit.
///
/// [`Policy::finish`]: super::Policy::finish
#[derive(Clone, Copy)]
pub struct SignBitsSafe;
/// Chirkov's `>=` and `<` of products, as published; other tests as [`Compare`].
#[derive(Clone, Copy)]
pub struct Products;

impl Tests for Compare {
    const NAME: &'static str = "compare";
    const SIGN_BITS: bool = false;
    const PRODUCTS: bool = false;
    #[inline(always)]
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask {
        t.le_where(upper, t.ge(lower))
    }
    #[inline(always)]
    fn share<R: Real>(mask: R::Mask, u: R, one: R) -> R::Mask {
        u.le_where(one, u.ge_where(u.zero(), mask))
    }
    #[inline(always)]
    fn beside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask {
        (u + v).le_where(one, v.ge_where(v.zero(), mask))
    }
    #[inline(always)]
    fn inside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask {
        (u + v).le_where(one, v.ge_where(v.zero(), u.ge_where(u.zero(), mask)))
    }
}

impl Tests for SignBits {
    const NAME: &'static str = "sign-bits";
    const SIGN_BITS: bool = true;
    const PRODUCTS: bool = false;
    #[inline(always)]
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask {
        let above = if S::FROM_ZERO { t } else { t - lower };
        !above.signed_by(upper - t).sign_bit()
    }
    #[inline(always)]
    fn share<R: Real>(mask: R::Mask, u: R, one: R) -> R::Mask {
        mask & !u.signed_by(one - u).sign_bit()
    }
    #[inline(always)]
    fn beside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask {
        mask & !v.signed_by(one - u - v).sign_bit()
    }
    #[inline(always)]
    fn inside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask {
        mask & !(u.signed_by(v).sign_bit() | u.signed_by(one - u - v).sign_bit())
    }
}

impl Tests for SignBitsSafe {
    const NAME: &'static str = "sign-bits-safe";
    const SIGN_BITS: bool = false;
    const PRODUCTS: bool = false;
    const LEAVES_NAN: bool = true;
    #[inline(always)]
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask {
        // A range of a ray's own may end in NaN on either side; one that begins at 0 is a search's.
        if !S::FROM_ZERO {
            return Compare::range::<S, R>(t, lower, upper);
        }
        let (t, upper) = (t + t.zero(), upper + t.zero());
        !t.either_sign(upper - t).sign_bit()
    }
    #[inline(always)]
    fn ahead<R: Real>(mask: R::Mask, t: R) -> R::Mask {
        mask & !(t + t.zero()).sign_bit()
    }
    #[inline(always)]
    fn share<R: Real>(mask: R::Mask, u: R, one: R) -> R::Mask {
        mask & !(u + u.zero()).either_sign(one - u).sign_bit()
    }
    #[inline(always)]
    fn beside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask {
        mask & !(v + v.zero()).either_sign(one - (u + v)).sign_bit()
    }
    #[inline(always)]
    fn inside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask {
        let rest = one - (u + v);
        mask & !(u + u.zero()).either_sign(v + v.zero()).either_sign(rest).sign_bit()
    }
}

impl Tests for Products {
    const NAME: &'static str = "products";
    const SIGN_BITS: bool = false;
    const PRODUCTS: bool = true;
    #[inline(always)]
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask {
        Compare::range::<S, R>(t, lower, upper)
    }
    #[inline(always)]
    fn share<R: Real>(mask: R::Mask, u: R, one: R) -> R::Mask {
        Compare::share(mask, u, one)
    }
    #[inline(always)]
    fn beside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask {
        Compare::beside(mask, u, v, one)
    }
    #[inline(always)]
    fn inside<R: Real>(mask: R::Mask, u: R, v: R, one: R) -> R::Mask {
        Compare::inside(mask, u, v, one)
    }
}

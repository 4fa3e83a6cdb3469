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
    /// Where `t` is in `[lower, upper]`.
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask;
    /// Where `t` is not negative.
    fn ahead<R: Real>(t: R) -> R::Mask;
    /// Where `u` is in `[0, one]`.
    fn share<R: Real>(u: R, one: R) -> R::Mask;
    /// Where `v` and one - u - v are not negative, `u` being known to be a share.
    fn beside<R: Real>(u: R, v: R, one: R) -> R::Mask;
    /// Where u, v and one - u - v are not negative.
    fn inside<R: Real>(u: R, v: R, one: R) -> R::Mask;
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
/// no sign. Bits that must be clear are united by `or` and asked for once.
///
/// A NaN has either sign. It is left to one ordered comparison, which is false for it: that of u + v
/// with `one`, which NaN in u or v reaches, and that of t with its upper bound. A share by itself, or
/// what lies ahead, may let a NaN pass: the test of v, or the search, refuses it. Where two infinities
/// are subtracted the determinant is infinite, and no form takes it for a hit.
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
        t.ge(lower) & t.le(upper)
    }
    #[inline(always)]
    fn ahead<R: Real>(t: R) -> R::Mask {
        t.ge(t.zero())
    }
    #[inline(always)]
    fn share<R: Real>(u: R, one: R) -> R::Mask {
        u.ge(u.zero()) & u.le(one)
    }
    #[inline(always)]
    fn beside<R: Real>(u: R, v: R, one: R) -> R::Mask {
        v.ge(v.zero()) & (u + v).le(one)
    }
    #[inline(always)]
    fn inside<R: Real>(u: R, v: R, one: R) -> R::Mask {
        u.ge(u.zero()) & v.ge(v.zero()) & (u + v).le(one)
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
    fn ahead<R: Real>(t: R) -> R::Mask {
        !t.sign_bit()
    }
    #[inline(always)]
    fn share<R: Real>(u: R, one: R) -> R::Mask {
        !u.signed_by(one - u).sign_bit()
    }
    #[inline(always)]
    fn beside<R: Real>(u: R, v: R, one: R) -> R::Mask {
        !v.signed_by(one - u - v).sign_bit()
    }
    #[inline(always)]
    fn inside<R: Real>(u: R, v: R, one: R) -> R::Mask {
        !(u.signed_by(v).sign_bit() | u.signed_by(one - u - v).sign_bit())
    }
}

impl Tests for SignBitsSafe {
    const NAME: &'static str = "sign-bits-safe";
    const SIGN_BITS: bool = false;
    const PRODUCTS: bool = false;
    #[inline(always)]
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask {
        let above = t + t.zero();
        let above = if S::FROM_ZERO { above } else { above - lower };
        !above.sign_bit() & t.le(upper)
    }
    #[inline(always)]
    fn ahead<R: Real>(t: R) -> R::Mask {
        !(t + t.zero()).sign_bit()
    }
    #[inline(always)]
    fn share<R: Real>(u: R, one: R) -> R::Mask {
        !(u + u.zero()).either_sign(one - u).sign_bit()
    }
    #[inline(always)]
    fn beside<R: Real>(u: R, v: R, one: R) -> R::Mask {
        !(v + v.zero()).sign_bit() & (u + v).le(one)
    }
    #[inline(always)]
    fn inside<R: Real>(u: R, v: R, one: R) -> R::Mask {
        !(u + u.zero()).either_sign(v + v.zero()).sign_bit() & (u + v).le(one)
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
    fn ahead<R: Real>(t: R) -> R::Mask {
        Compare::ahead(t)
    }
    #[inline(always)]
    fn share<R: Real>(u: R, one: R) -> R::Mask {
        Compare::share(u, one)
    }
    #[inline(always)]
    fn beside<R: Real>(u: R, v: R, one: R) -> R::Mask {
        Compare::beside(u, v, one)
    }
    #[inline(always)]
    fn inside<R: Real>(u: R, v: R, one: R) -> R::Mask {
        Compare::inside(u, v, one)
    }
}

//! The values of the axes, and the little that each of them does.

use std::hint::black_box;

use super::Miss;
use crate::number::{Mask, Real};

/// When a test may end.
pub trait Exit: Copy + 'static {
    /// The column `exit`.
    const NAME: &'static str;
    /// Whether the range test waits for the end.
    const DEFERS_RANGE: bool;
    /// Goes on, or leaves with `code`.
    fn keep<M: Mask>(mask: M, code: u8) -> Result<M, Miss>;
    /// `yes` where `mask` holds, else `no`; `early` may jump for it.
    fn select<R: Real, const N: usize>(mask: R::Mask, yes: [R; N], no: [R; N]) -> [R; N];
    /// All bits set for a hit, none otherwise; in `full` without a jump around what it masks.
    fn spread(hit: bool) -> u64;
}

/// Leave as soon as no lane can hit.
#[derive(Clone, Copy)]
pub struct Early;
/// Do all the work, whatever the lanes say (the thesis's worst case).
#[derive(Clone, Copy)]
pub struct Full;

impl Exit for Early {
    const NAME: &'static str = "early";
    const DEFERS_RANGE: bool = false;
    #[inline(always)]
    fn keep<M: Mask>(mask: M, code: u8) -> Result<M, Miss> {
        if mask.any() { Ok(mask) } else { Err(Miss(code)) }
    }
    #[inline(always)]
    fn select<R: Real, const N: usize>(mask: R::Mask, yes: [R; N], mut no: [R; N]) -> [R; N] {
        for (no, yes) in no.iter_mut().zip(yes) {
            *no = R::select(mask, yes, *no);
        }
        no
    }
    #[inline(always)]
    fn spread(hit: bool) -> u64 {
        u64::from(hit).wrapping_neg()
    }
}

impl Exit for Full {
    const NAME: &'static str = "full";
    const DEFERS_RANGE: bool = true;
    #[inline(always)]
    fn keep<M: Mask>(mask: M, _: u8) -> Result<M, Miss> {
        Ok(mask)
    }
    #[inline(always)]
    fn select<R: Real, const N: usize>(mask: R::Mask, yes: [R; N], no: [R; N]) -> [R; N] {
        R::blend(mask, yes, no)
    }
    #[inline(always)]
    fn spread(hit: bool) -> u64 {
        black_box(u64::from(hit).wrapping_neg())
    }
}

/// How sums of products round.
pub trait Rounding: Copy + 'static {
    /// The column `rounding`.
    const NAME: &'static str;
    /// a b + c
    fn multiply_add<R: Real>(a: R, b: R, c: R) -> R;
    /// a b - c
    fn multiply_subtract<R: Real>(a: R, b: R, c: R) -> R;
}

/// Every operation rounds: bit-identical on every level and width.
#[derive(Clone, Copy)]
pub struct Plain;
/// Products are not rounded before they are added; only on levels with the instruction.
#[derive(Clone, Copy)]
pub struct Fused;

impl Rounding for Plain {
    const NAME: &'static str = "plain";
    #[inline(always)]
    fn multiply_add<R: Real>(a: R, b: R, c: R) -> R {
        a * b + c
    }
    #[inline(always)]
    fn multiply_subtract<R: Real>(a: R, b: R, c: R) -> R {
        a * b - c
    }
}

impl Rounding for Fused {
    const NAME: &'static str = "fused";
    #[inline(always)]
    fn multiply_add<R: Real>(a: R, b: R, c: R) -> R {
        a.mul_add(b, c)
    }
    #[inline(always)]
    fn multiply_subtract<R: Real>(a: R, b: R, c: R) -> R {
        a.mul_add(b, -c)
    }
}

/// What is reported of a hit.
pub trait Output: Copy + 'static {
    /// The column `output`.
    const NAME: &'static str;
    /// t is reported.
    const T: bool;
    /// u and v are reported.
    const UV: bool;
    /// The point and the normal are reported.
    const SURFACE: bool;
}

macro_rules! output {
    ($(#[$doc:meta] $type:ident $name:literal $t:literal $uv:literal $surface:literal;)*) => {$(
        #[$doc]
        #[derive(Clone, Copy)]
        pub struct $type;
        impl Output for $type {
            const NAME: &'static str = $name;
            const T: bool = $t;
            const UV: bool = $uv;
            const SURFACE: bool = $surface;
        }
    )*};
}

output! {
    /// Only whether.
    Hit "hit" false false false;
    /// And where on the ray.
    T "t" true false false;
    /// And where on the triangle.
    Tuv "tuv" true true false;
    /// And the point in space with the triangle's normal (not normalised).
    Surface "surface" true true true;
}

/// Whether back faces are hit.
pub trait Facing: Copy + 'static {
    /// The column `cull`.
    const NAME: &'static str;
    /// Only front faces (counter-clockwise as the ray sees them) are hit.
    const CULLS: bool;
}

/// Both faces are hit.
#[derive(Clone, Copy)]
pub struct TwoSided;
/// Only front faces are hit.
#[derive(Clone, Copy)]
pub struct Cull;

impl Facing for TwoSided {
    const NAME: &'static str = "off";
    const CULLS: bool = false;
}

impl Facing for Cull {
    const NAME: &'static str = "on";
    const CULLS: bool = true;
}

/// Which t count.
pub trait Span: Copy + 'static {
    /// t_min is zero and not read, as in both theses: one multiplication less in `last`.
    const FROM_ZERO: bool;
}

/// From zero to t_max.
#[derive(Clone, Copy)]
pub struct FromZero;
/// From t_min to t_max.
#[derive(Clone, Copy)]
pub struct Between;

impl Span for FromZero {
    const FROM_ZERO: bool = true;
}

impl Span for Between {
    const FROM_ZERO: bool = false;
}

/// Which test comes first, where the algebra allows both.
pub trait Leading: Copy + 'static {
    /// The column `leading`.
    const NAME: &'static str;
    /// The distance is tested before the inside.
    const DISTANCE: bool;
}

/// The distance first.
#[derive(Clone, Copy)]
pub struct Distance;
/// The inside first.
#[derive(Clone, Copy)]
pub struct Inside;

impl Leading for Distance {
    const NAME: &'static str = "distance";
    const DISTANCE: bool = true;
}

impl Leading for Inside {
    const NAME: &'static str = "inside";
    const DISTANCE: bool = false;
}

/// How signs are tested.
pub trait Tests: Copy + 'static {
    /// The column `tests_form`.
    const NAME: &'static str;
    /// Sign bits are compared, and nothing is flipped by the sign of a determinant.
    const SIGN_BITS: bool;
    /// Signs of products are compared (Chirkov's published form).
    const PRODUCTS: bool;
    /// Where `t` is in `[lower, upper]`.
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask;
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

impl Tests for Products {
    const NAME: &'static str = "products";
    const SIGN_BITS: bool = false;
    const PRODUCTS: bool = true;
    #[inline(always)]
    fn range<S: Span, R: Real>(t: R, lower: R, upper: R) -> R::Mask {
        Compare::range::<S, R>(t, lower, upper)
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

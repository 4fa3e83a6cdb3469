//! The values of the axes, and the little that each of them does.

use crate::number::{Element, Real};

/// How sums of products round.
pub trait Rounding: Copy + 'static {
    /// The column `rounding`.
    const NAME: &'static str;
    /// a b + c
    fn multiply_add<R: Real>(a: R, b: R, c: R) -> R;
    /// a b - c
    fn multiply_subtract<R: Real>(a: R, b: R, c: R) -> R;
    /// A number as [`Rounding::product_error`] takes it.
    type Parts<R: Real>: Copy;
    /// Prepares a factor.
    fn parts<R: Real>(x: R) -> Self::Parts<R>;
    /// a b - `product`, where `product` is a b rounded: the error of that rounding, exactly, unless
    /// a part of it underflows or a factor is too large to be split.
    fn product_error<R: Real>(a: Self::Parts<R>, b: Self::Parts<R>, product: R) -> R;
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
    /// Two halves whose products are exact.
    type Parts<R: Real> = [R; 2];
    /// G. W. Veltkamp, 1968.
    #[inline(always)]
    fn parts<R: Real>(x: R) -> [R; 2] {
        let large = x * x.like(R::Element::SPLITTER);
        let half = large - (large - x);
        [half, x - half]
    }
    /// T. J. Dekker, "A floating-point technique for extending the available precision", 1971.
    #[inline(always)]
    fn product_error<R: Real>([a, a_rest]: [R; 2], [b, b_rest]: [R; 2], product: R) -> R {
        a_rest * b_rest - (((product - a * b) - a_rest * b) - a * b_rest)
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
    type Parts<R: Real> = R;
    #[inline(always)]
    fn parts<R: Real>(x: R) -> R {
        x
    }
    #[inline(always)]
    fn product_error<R: Real>(a: R, b: R, product: R) -> R {
        a.mul_add(b, -product)
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
    /// t_max is the distance of the nearest hit so far: who keeps it compares with it anyhow.
    const NEARER: bool = false;
}

/// From zero to t_max.
#[derive(Clone, Copy)]
pub struct FromZero;
/// From zero to the nearest hit so far.
#[derive(Clone, Copy)]
pub struct Nearer;
/// From t_min to t_max.
#[derive(Clone, Copy)]
pub struct Between;

impl Span for FromZero {
    const FROM_ZERO: bool = true;
}

impl Span for Nearer {
    const FROM_ZERO: bool = true;
    const NEARER: bool = true;
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

//! What a kernel leaves open: the axes that turn one source into its many forms.
//!
//! Every axis is a type without data, so a form costs nothing at run time and its name stands in
//! the symbols of the compiled program. A kernel sees the axes only through the provided methods
//! of [`Policy`]: a `?` behind each test, and numerators that are compared with `one`.

mod axes;
mod exit;
mod form;
mod reciprocal;
mod scale;
mod tests;

pub use axes::{
    Between, Cull, Distance, Facing, FromZero, Fused, Hit, Inside, Leading, Nearer, Output, Plain,
    Rounding, Span, Surface, T, Tuv, TwoSided,
};
pub use exit::{Early, Exit, Full, Once};
pub use form::{BothFaces, Form, InRegisters};
pub use reciprocal::{Divide, Estimated, Reciprocal};
pub use scale::{Division, First, Last, Scale};
pub use tests::{Compare, Products, SignBits, SignBitsSafe, Tests};

use crate::number::{Element, Mask, Real, Vec3};

/// A ray, as a kernel sees it: one, or one per lane.
#[derive(Clone, Copy)]
pub struct Ray<R> {
    /// Where t = 0.
    pub origin: Vec3<R>,
    /// Direction; t is counted in units of it.
    pub direction: Vec3<R>,
    /// End of the segment; only segment kernels read it.
    pub end: Vec3<R>,
    /// Smallest t that counts (not read by forms whose span starts at zero).
    pub t_min: R,
    /// Largest t that counts; finite.
    pub t_max: R,
}

/// Why a test ended early: the return code of its exit path; never 0, which is a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Miss(pub u8);

/// What a test found, per lane. Without a `hit`, t, u and v mean nothing.
#[derive(Clone, Copy)]
pub struct Found<R: Real> {
    /// Where the triangle is hit.
    pub hit: R::Mask,
    /// Distance in units of the direction.
    pub t: R,
    /// Weight of vertex b.
    pub u: R,
    /// Weight of vertex c.
    pub v: R,
}

/// One value of every axis.
pub trait Policy: Copy + 'static {
    /// Leave early or do the full work.
    type Exit: Exit;
    /// Divide first or last.
    type Division: Division;
    /// How sums of products round.
    type Rounding: Rounding;
    /// What is reported.
    type Output: Output;
    /// Whether back faces are hit.
    type Facing: Facing;
    /// How signs are tested.
    type Tests: Tests;
    /// Which test comes first, where the algebra allows both.
    type Leading: Leading;
    /// Which t count.
    type Span: Span;
    /// How a reciprocal is computed.
    type Reciprocal: Reciprocal;

    /// a . b
    #[inline(always)]
    fn dot<R: Real>(a: Vec3<R>, b: Vec3<R>) -> R {
        Self::multiply_add(a.z(), b.z(), Self::multiply_add(a.y(), b.y(), a.x() * b.x()))
    }
    /// a x b
    #[inline(always)]
    fn cross<R: Real>(a: Vec3<R>, b: Vec3<R>) -> Vec3<R> {
        Vec3([
            Self::difference(a.y(), b.z(), a.z(), b.y()),
            Self::difference(a.z(), b.x(), a.x(), b.z()),
            Self::difference(a.x(), b.y(), a.y(), b.x()),
        ])
    }
    /// a b + c
    #[inline(always)]
    fn multiply_add<R: Real>(a: R, b: R, c: R) -> R {
        Self::Rounding::multiply_add(a, b, c)
    }
    /// a b - c d
    #[inline(always)]
    fn difference<R: Real>(a: R, b: R, c: R, d: R) -> R {
        Self::Rounding::multiply_subtract(a, b, c * d)
    }

    /// Goes on where any lane is still wanted; `code` names this exit.
    #[inline(always)]
    fn keep<M: Mask>(mask: M, code: u8) -> Result<M, Miss> {
        Self::Exit::keep(mask, code)
    }
    /// [`Policy::keep`] where t is within the ray's range. In `full` the range is left to
    /// [`Policy::finish`]: the bound shrinks from test to test, and a chain of dependences through
    /// it would limit the loop.
    #[inline(always)]
    fn keep_range<R: Real>(
        mask: R::Mask,
        ray: &Ray<R>,
        t: R,
        scale: Scale<R>,
        code: u8,
    ) -> Result<R::Mask, Miss> {
        if Self::Exit::DEFERS_RANGE {
            Ok(mask)
        } else {
            Self::keep(Self::within(mask, ray, t, scale), code)
        }
    }
    /// The upper bound of t is left to the search for the nearest hit, which compares every hit with
    /// the one before it. Forms that leave early leave by the bound; where only the hit is wanted
    /// nobody keeps a distance. Sign bits as printed ask for both bounds at once or for none.
    const LEAVES_BOUND: bool =
        Self::Exit::DEFERS_RANGE && Self::IS_SEARCH && !Self::Tests::SIGN_BITS;
    /// Whoever is given the answer keeps the nearest hit, and takes none that is not nearer.
    const IS_SEARCH: bool = Self::Span::NEARER && Self::Output::T;

    /// `mask` where t / one is within the ray's closed range; in a search, where it is not negative.
    #[inline(always)]
    fn within<R: Real>(mask: R::Mask, ray: &Ray<R>, t: R, scale: Scale<R>) -> R::Mask {
        if Self::LEAVES_BOUND {
            return Self::Tests::ahead(mask, t);
        }
        let lower = if Self::Span::FROM_ZERO { t.zero() } else { Self::scaled(ray.t_min, scale) };
        mask & Self::Tests::range::<Self::Span, R>(t, lower, Self::scaled(ray.t_max, scale))
    }
    /// `hit` where a numerator is between 0 and `one`. Where no test ends here, `one` is left to
    /// [`Policy::beside`]: rounding is monotone, so that u + v, v not being negative, is at least u.
    #[inline(always)]
    fn share<R: Real>(hit: R::Mask, u: R, scale: Scale<R>) -> R::Mask {
        if Self::Exit::UNITES && !Self::Tests::AS_PUBLISHED {
            Self::Tests::ahead(hit, u)
        } else {
            Self::Tests::share(hit, u, scale.one)
        }
    }
    /// `hit` where `v` and what u and v leave of `one` are not negative, behind [`Policy::share`] of u.
    #[inline(always)]
    fn beside<R: Real>(hit: R::Mask, u: R, v: R, scale: Scale<R>) -> R::Mask {
        Self::Tests::beside(hit, u, v, scale.one)
    }
    /// `hit` where both numerators and what they leave of `one` are not negative.
    #[inline(always)]
    fn inside<R: Real>(hit: R::Mask, u: R, v: R, scale: Scale<R>) -> R::Mask {
        Self::Tests::inside(hit, u, v, scale.one)
    }

    /// Numerators are flipped by the sign of `det`, so that `one` is positive. Not needed where it
    /// is known to be (culling) nor where signs are compared as bits.
    const FLIPS: bool = !Self::Facing::CULLS && !Self::Tests::SIGN_BITS;

    /// Where `det` can be divided by; with culling, where it is positive (a front face).
    #[inline(always)]
    fn divisible<R: Real>(det: R) -> R::Mask {
        Self::Division::divisible::<Self, R>(det)
    }
    /// The scale of several numerators over `det`.
    #[inline(always)]
    fn divide<R: Real>(det: R) -> Scale<R> {
        Self::Division::divide::<Self, R>(det)
    }
    /// The one division of [`Policy::divide`] and [`Policy::inverse`], for those who share it.
    #[inline(always)]
    fn divided<R: Real>(det: R) -> R {
        Self::Division::divided::<Self, R>(det)
    }
    /// What [`Policy::divide`] and [`Policy::inverse`] give, by the division that was done.
    #[inline(always)]
    fn divided_by<R: Real>(det: R, divided: R) -> (Scale<R>, R) {
        Self::Division::divided_by::<Self, R>(det, divided)
    }
    /// A numerator over `det`, brought to `scale`.
    #[inline(always)]
    fn signed<R: Real>(numerator: R, scale: Scale<R>) -> R {
        Self::Division::signed::<Self, R>(numerator, scale)
    }
    /// `numerator / det` and the scale that it is in. For kernels that need one quotient only:
    /// `first` divides once and multiplies nothing.
    #[inline(always)]
    fn quotient<R: Real>(numerator: R, det: R) -> (R, Scale<R>) {
        Self::Division::quotient::<Self, R>(numerator, det)
    }
    /// A value that needs no division, brought to `scale` so that it compares with numerators.
    #[inline(always)]
    fn scaled<R: Real>(value: R, scale: Scale<R>) -> R {
        Self::Division::scaled(value, scale)
    }
    /// A component of origin + t direction, in `scale`.
    #[inline(always)]
    fn along<R: Real>(origin: R, direction: R, t: R, scale: Scale<R>) -> R {
        Self::multiply_add(t, direction, Self::scaled(origin, scale))
    }
    /// The scale of fractions whose denominators are those of both.
    #[inline(always)]
    fn joined<R: Real>(a: Scale<R>, b: Scale<R>) -> Scale<R> {
        Scale { factor: b.factor, one: Self::scaled(b.one, a) }
    }

    /// What late division multiplies by.
    #[inline(always)]
    fn inverse<R: Real>(scale: Scale<R>) -> R {
        Self::Division::inverse::<Self, R>(scale)
    }
    /// Behind the last test: the range where it was deferred, and the way out of `once`.
    #[inline(always)]
    fn settle<R: Real>(hit: R::Mask, ray: &Ray<R>, t: R, scale: Scale<R>) -> Result<R::Mask, Miss> {
        let deferred = Self::Exit::DEFERS_RANGE;
        Self::Exit::settle(if deferred { Self::within(hit, ray, t, scale) } else { hit })
    }
    /// The answer where t, u and v share their denominator.
    #[inline(always)]
    fn finish<R: Real>(
        hit: R::Mask,
        ray: &Ray<R>,
        numerators: [R; 3],
        scale: Scale<R>,
    ) -> Result<Found<R>, Miss> {
        let hit = Self::settle(hit, ray, numerators[0], scale)?;
        Ok(Self::finish_by(hit, ray, numerators, Self::inverse(scale)))
    }
    /// [`Policy::finish`] behind [`Policy::settle`], the inverse of the scale being known.
    #[inline(always)]
    fn finish_by<R: Real>(hit: R::Mask, ray: &Ray<R>, [t, u, v]: [R; 3], inverse: R) -> Found<R> {
        let hit = Self::ordered(hit, [t, u, v]);
        let resolve = Self::Division::resolve;
        let [t, u, v] = [resolve(t, inverse), resolve(u, inverse), resolve(v, inverse)];
        Found { hit: Self::reached(hit, ray, t, inverse), t, u, v }
    }
    /// The answer where u and v have a denominator of their own, which bounds them.
    #[inline(always)]
    fn finish_apart<R: Real>(
        hit: R::Mask,
        ray: &Ray<R>,
        (t, t_scale): (R, Scale<R>),
        ([u, v], uv_scale): ([R; 2], Scale<R>),
    ) -> Result<Found<R>, Miss> {
        let hit = Self::ordered(Self::settle(hit, ray, t, t_scale)?, [t, u, v]);
        let (t_inverse, inverse) = (Self::inverse(t_scale), Self::inverse(uv_scale));
        let resolve = Self::Division::resolve;
        let [t, u, v] = [resolve(t, t_inverse), resolve(u, inverse), resolve(v, inverse)];
        let hit = Self::reached(hit, ray, t, t_inverse);
        let asks = Self::Division::BEHIND_TESTS && !Self::Tests::AS_PUBLISHED;
        let hit = if asks { Self::Reciprocal::usable(hit, inverse) } else { hit };
        Ok(Found { hit, t, u, v })
    }
    /// `hit` where none of the numerators is NaN, if the tests have left that open.
    #[inline(always)]
    fn ordered<R: Real>(hit: R::Mask, [t, u, v]: [R; 3]) -> R::Mask {
        if !Self::Tests::LEAVES_NAN {
            return hit;
        }
        let sum = t + u + v;
        sum.le_where(sum, hit)
    }
    /// `hit` where t, which passed the test of its range, is finite, and the determinant, whose
    /// reciprocal is `inverse`. Divided last, t was tested as a numerator; the quotient can overflow,
    /// and so can the bounds that are scaled for it; below an infinite determinant is everything. A
    /// search takes only what is nearer than its bound, which is finite.
    #[inline(always)]
    fn reached<R: Real>(hit: R::Mask, ray: &Ray<R>, t: R, inverse: R) -> R::Mask {
        if !Self::Division::BEHIND_TESTS || Self::Tests::AS_PUBLISHED {
            return hit;
        }
        let hit = Self::Reciprocal::usable(hit, inverse);
        if Self::IS_SEARCH {
            hit
        } else if Self::Span::FROM_ZERO {
            t.le_where(ray.t_max, hit)
        } else {
            hit & Self::finite(t)
        }
    }
    /// Where a number is finite.
    #[inline(always)]
    fn finite<R: Real>(x: R) -> R::Mask {
        x.signed_by(x).le(x.like(R::Element::MAX))
    }
}

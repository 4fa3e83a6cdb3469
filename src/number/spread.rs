//! One value for all lanes.

use super::{Axis, Real, Vec3};

/// A value made of numbers, which can be put into every lane.
pub trait Spread<R: Real>: Copy {
    /// The same value of single numbers.
    type One: Copy;
    /// `one` in every lane; for scalars `one` itself.
    fn spread(token: R::Token, one: Self::One) -> Self;
}

impl<R: Real> Spread<R> for R {
    type One = R::Element;
    #[inline(always)]
    fn spread(token: R::Token, one: R::Element) -> Self {
        R::splat(token, one)
    }
}

impl<R: Real> Spread<R> for Vec3<R> {
    type One = Vec3<R::Element>;
    #[inline(always)]
    fn spread(token: R::Token, one: Vec3<R::Element>) -> Self {
        Vec3::splat(token, one)
    }
}

impl<R: Real> Spread<R> for [R; 2] {
    type One = [R::Element; 2];
    #[inline(always)]
    fn spread(token: R::Token, [first, second]: [R::Element; 2]) -> Self {
        [R::splat(token, first), R::splat(token, second)]
    }
}

impl<R: Real> Spread<R> for Axis<R::Mask> {
    type One = Axis<bool>;
    /// A single triangle has one axis; masks of one lane, which nothing stores, are spread as well.
    #[inline(always)]
    fn spread(token: R::Token, one: Axis<bool>) -> Self {
        match one {
            Axis::Uniform(axis) => Axis::Uniform(axis),
            Axis::Lanes(is_x, is_y) => Axis::Lanes(R::mask(token, is_x), R::mask(token, is_y)),
        }
    }
}

/// [`Spread`] of a struct, field by field.
macro_rules! spread {
    ($type:ident { $($field:ident),* $(,)? }) => {
        impl<R: $crate::number::Real> $crate::number::Spread<R> for $type<R> {
            type One = $type<R::Element>;
            #[inline(always)]
            fn spread(token: R::Token, one: $type<R::Element>) -> Self {
                $type { $($field: $crate::number::Spread::<R>::spread(token, one.$field)),* }
            }
        }
    };
}

pub(crate) use spread;

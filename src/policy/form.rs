//! A form: one value of every axis.

use std::marker::PhantomData;

use super::{
    Compare, Distance, Divide, Division, Exit, Facing, FromZero, Leading, Output, Policy,
    Reciprocal, Rounding, Span, Tests, TwoSided,
};
use crate::number::{Real, Vec3};

/// The form with these values of the axes.
#[derive(Clone, Copy)]
#[allow(clippy::type_complexity, reason = "one marker per axis, in the order of a variant's id")]
pub struct Form<E, D, A, O, F = TwoSided, T = Compare, L = Distance, S = FromZero, V = Divide>(
    PhantomData<(E, D, A, O, F, T, L, S, V)>,
);

impl<E, D, A, O, F, T, L, S, V> Policy for Form<E, D, A, O, F, T, L, S, V>
where
    E: Exit,
    D: Division,
    A: Rounding,
    O: Output,
    F: Facing,
    T: Tests,
    L: Leading,
    S: Span,
    V: Reciprocal,
{
    type Exit = E;
    type Division = D;
    type Rounding = A;
    type Output = O;
    type Facing = F;
    type Tests = T;
    type Leading = L;
    type Span = S;
    type Reciprocal = V;
}

/// `P` with both faces: for kernels whose determinant does not carry the face in its sign.
#[derive(Clone, Copy)]
pub struct BothFaces<P>(PhantomData<P>);

impl<P: Policy> Policy for BothFaces<P> {
    type Exit = P::Exit;
    type Division = P::Division;
    type Rounding = P::Rounding;
    type Output = P::Output;
    type Facing = TwoSided;
    type Tests = P::Tests;
    type Leading = P::Leading;
    type Span = P::Span;
    type Reciprocal = P::Reciprocal;
}

/// `P` of numbers that can be vectors ([`Real::vector`]), where each of a vector's three is all of it.
/// Sums of products are plain.
#[derive(Clone, Copy)]
pub struct InRegisters<P>(PhantomData<P>);

impl<P: Policy> Policy for InRegisters<P> {
    type Exit = P::Exit;
    type Division = P::Division;
    type Rounding = P::Rounding;
    type Output = P::Output;
    type Facing = P::Facing;
    type Tests = P::Tests;
    type Leading = P::Leading;
    type Span = P::Span;
    type Reciprocal = P::Reciprocal;

    #[inline(always)]
    fn dot<R: Real>(a: Vec3<R>, b: Vec3<R>) -> R {
        a.x().vector_dot(b.x())
    }
    #[inline(always)]
    fn cross<R: Real>(a: Vec3<R>, b: Vec3<R>) -> Vec3<R> {
        Vec3([a.x().vector_cross(b.x()); 3])
    }
}

//! Packets longer than a register: two numbers side by side, and two of those (thesis H, 4.2).
//!
//! What is broadcast of a triangle serves both halves, and while one half waits for a result the
//! other has work to do.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use super::{Mask, Real};

/// Twice as many lanes: the first half, and the second.
#[derive(Clone, Copy)]
pub struct Twice<R>(R, R);

macro_rules! halves {
    ($($trait:ident $method:ident $bound:ident;)*) => {$(
        impl<R: $bound> $trait for Twice<R> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Twice(self.0.$method(other.0), self.1.$method(other.1))
            }
        }
    )*};
}

halves! {
    BitAnd bitand Mask;
    BitOr bitor Mask;
    Add add Real;
    Sub sub Real;
    Mul mul Real;
    Div div Real;
}

impl<M: Not<Output = M>> Not for Twice<M> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Twice(!self.0, !self.1)
    }
}

impl<R: Neg<Output = R>> Neg for Twice<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Twice(-self.0, -self.1)
    }
}

impl<M: Mask> Mask for Twice<M> {
    const LANES: usize = 2 * M::LANES;
    #[inline(always)]
    fn any(self) -> bool {
        (self.0 | self.1).any()
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> bool {
        if lane < M::LANES { self.0.lane(lane) } else { self.1.lane(lane - M::LANES) }
    }
}

macro_rules! comparisons {
    ($($method:ident)*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> Self::Mask {
            Twice(self.0.$method(other.0), self.1.$method(other.1))
        }
    )*};
}

macro_rules! masked_comparisons {
    ($($method:ident)*) => {$(
        #[inline(always)]
        fn $method(self, other: Self, mask: Self::Mask) -> Self::Mask {
            Twice(self.0.$method(other.0, mask.0), self.1.$method(other.1, mask.1))
        }
    )*};
}

impl<R: Real> Real for Twice<R> {
    type Mask = Twice<R::Mask>;
    type Element = R::Element;
    type Token = R::Token;
    const LANES: usize = 2 * R::LANES;

    comparisons!(lt le gt ge ne);
    masked_comparisons!(lt_where le_where ge_where ne_where);

    #[inline(always)]
    fn token(self) -> R::Token {
        self.0.token()
    }
    #[inline(always)]
    fn splat(token: R::Token, element: R::Element) -> Self {
        Twice(R::splat(token, element), R::splat(token, element))
    }
    #[inline(always)]
    fn load(token: R::Token, elements: &[R::Element]) -> Self {
        Twice(R::load(token, elements), R::load(token, &elements[R::LANES..]))
    }
    #[inline(always)]
    fn store(self, elements: &mut [R::Element]) {
        let (first, second) = elements.split_at_mut(R::LANES);
        self.0.store(first);
        self.1.store(second);
    }
    #[inline(always)]
    fn mask(token: R::Token, truth: bool) -> Self::Mask {
        Twice(R::mask(token, truth), R::mask(token, truth))
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Twice(R::select(mask.0, yes.0, no.0), R::select(mask.1, yes.1, no.1))
    }
    #[inline(always)]
    fn signed_by(self, sign: Self) -> Self {
        Twice(self.0.signed_by(sign.0), self.1.signed_by(sign.1))
    }
    #[inline(always)]
    fn sign_bit(self) -> Self::Mask {
        Twice(self.0.sign_bit(), self.1.sign_bit())
    }
    #[inline(always)]
    fn either_sign(self, other: Self) -> Self {
        Twice(self.0.either_sign(other.0), self.1.either_sign(other.1))
    }
    #[inline(always)]
    fn estimated_inverse(self) -> Self {
        Twice(self.0.estimated_inverse(), self.1.estimated_inverse())
    }
    #[inline(always)]
    fn successor(self) -> Self {
        let next = self.0.successor();
        Twice(next, next)
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Twice(self.0.mul_add(factor.0, addend.0), self.1.mul_add(factor.1, addend.1))
    }
}

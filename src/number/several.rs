//! Several registers as one number: packets longer than a register.
//!
//! All registers of a packet go through a test side by side. Each operation is done on all of them
//! before the next, so that one's latency hides behind the others, and what is the same in all of
//! them, a triangle's numbers or a common origin, is read and computed once.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use super::{Mask, Real};

/// `N` numbers of lanes, one behind the other.
#[derive(Clone, Copy)]
pub struct Several<R, const N: usize>([R; N]);

/// The masks of `N` numbers.
#[derive(Clone, Copy)]
pub struct SeveralMasks<M, const N: usize>([M; N]);

impl<M: Mask, const N: usize> Mask for SeveralMasks<M, N> {
    const LANES: usize = N * M::LANES;
    /// One question for all registers, not one for each.
    #[inline(always)]
    fn any(self) -> bool {
        let mut all = self.0[0];
        for mask in &self.0[1..] {
            all = all | *mask;
        }
        all.any()
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> bool {
        self.0[lane / M::LANES].lane(lane % M::LANES)
    }
}

macro_rules! binary {
    ($type:ident, $bound:ident, $trait:ident, $method:ident) => {
        impl<T: $bound, const N: usize> $trait for $type<T, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for (one, other) in self.0.iter_mut().zip(other.0) {
                    *one = $trait::$method(*one, other);
                }
                self
            }
        }
    };
}

binary!(SeveralMasks, Mask, BitAnd, bitand);
binary!(SeveralMasks, Mask, BitOr, bitor);
binary!(Several, Real, Add, add);
binary!(Several, Real, Sub, sub);
binary!(Several, Real, Mul, mul);
binary!(Several, Real, Div, div);

impl<M: Mask, const N: usize> Not for SeveralMasks<M, N> {
    type Output = Self;
    #[inline(always)]
    fn not(mut self) -> Self {
        for mask in &mut self.0 {
            *mask = !*mask;
        }
        self
    }
}

impl<R: Real, const N: usize> Neg for Several<R, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for number in &mut self.0 {
            *number = -*number;
        }
        self
    }
}

macro_rules! compared {
    ($($method:ident)*) => {
        $(#[inline(always)]
        fn $method(self, other: Self) -> Self::Mask {
            let mut masks = [self.0[0].$method(other.0[0]); N];
            for i in 1..N {
                masks[i] = self.0[i].$method(other.0[i]);
            }
            SeveralMasks(masks)
        })*
    };
}

impl<R: Real, const N: usize> Real for Several<R, N> {
    type Mask = SeveralMasks<R::Mask, N>;
    type Element = R::Element;
    type Token = R::Token;
    const LANES: usize = N * R::LANES;

    #[inline(always)]
    fn token(self) -> R::Token {
        self.0[0].token()
    }
    #[inline(always)]
    fn splat(token: R::Token, element: R::Element) -> Self {
        Several([R::splat(token, element); N])
    }
    #[inline(always)]
    fn load(token: R::Token, elements: &[R::Element]) -> Self {
        let mut numbers = [R::load(token, elements); N];
        for i in 1..N {
            numbers[i] = R::load(token, &elements[i * R::LANES..]);
        }
        Several(numbers)
    }
    #[inline(always)]
    fn store(self, elements: &mut [R::Element]) {
        for (number, place) in self.0.into_iter().zip(elements.chunks_exact_mut(R::LANES)) {
            number.store(place);
        }
    }
    #[inline(always)]
    fn mask(token: R::Token, truth: bool) -> Self::Mask {
        SeveralMasks([R::mask(token, truth); N])
    }
    compared!(lt le gt ge ne);
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, mut no: Self) -> Self {
        for i in 0..N {
            no.0[i] = R::select(mask.0[i], yes.0[i], no.0[i]);
        }
        no
    }
    #[inline(always)]
    fn signed_by(mut self, sign: Self) -> Self {
        for (number, sign) in self.0.iter_mut().zip(sign.0) {
            *number = number.signed_by(sign);
        }
        self
    }
    #[inline(always)]
    fn sign_bit(self) -> Self::Mask {
        let mut masks = [self.0[0].sign_bit(); N];
        for (mask, number) in masks.iter_mut().zip(self.0) {
            *mask = number.sign_bit();
        }
        SeveralMasks(masks)
    }
    #[inline(always)]
    fn mul_add(mut self, factor: Self, addend: Self) -> Self {
        for i in 0..N {
            self.0[i] = self.0[i].mul_add(factor.0[i], addend.0[i]);
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two "registers" of one lane each.
    type Two = Several<f64, 2>;

    #[test]
    fn every_register_is_computed_with() {
        let (mut place, x) = ([0.0; 2], Two::load((), &[3.0, -4.0]));
        let y = Two::splat((), 2.0);
        for (result, expected) in [
            (x + y, [5.0, -2.0]),
            (x - y, [1.0, -6.0]),
            (x * y, [6.0, -8.0]),
            (x / y, [1.5, -2.0]),
            (-x, [-3.0, 4.0]),
            (y.signed_by(x), [2.0, -2.0]),
            (x.mul_add(y, y), [8.0, -6.0]),
            (Two::select(x.lt(y), x, y), [2.0, -4.0]),
        ] {
            result.store(&mut place);
            assert_eq!(place, expected);
        }
        assert_eq!(Two::LANES, 2);
    }

    #[test]
    fn masks_answer_lane_by_lane() {
        let x = Two::load((), &[3.0, -4.0]);
        let negative = x.sign_bit();
        assert!(!negative.lane(0) && negative.lane(1) && negative.any());
        assert!((!negative).lane(0) && !(!negative).lane(1));
        assert!(!(negative & x.gt(x.zero())).any());
        assert!((negative | x.ge(x.zero())).lane(0));
        assert!(!x.ne(x).any() && x.le(x).lane(1));
    }
}

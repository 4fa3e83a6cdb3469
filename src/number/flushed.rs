//! A number of a processor that flushes subnormal numbers to zero.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Element, Real};

/// `T` as under "flush to zero" and "denormals are zero": a subnormal operand counts as the zero of
/// its sign, and a subnormal result becomes that zero. Setting the processor's own mode is unsafe,
/// and the compiler does not expect it.
///
/// Selections and flips of a sign move bits and flush nothing. A result that rounds up to the
/// smallest normal number stays; processors differ there (x86 asks what it would be with an
/// unbounded exponent, and flushes the upper half of the last step).
///
/// Operations are never inlined: nothing here is timed, and code that is not made need not be built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flushed<T>(pub T);

/// `x`, or the zero of its sign where it is subnormal. NaN stays.
fn flush<T: Element>(x: T) -> T {
    if x.signed_by(x).le(T::LARGEST_SUBNORMAL) { T::ZERO.signed_by(x) } else { x }
}

macro_rules! flushed {
    ($trait:ident, $method:ident) => {
        impl<T: Element> $trait for Flushed<T> {
            type Output = Self;
            #[inline(never)]
            fn $method(self, other: Self) -> Self {
                Flushed(flush($trait::$method(flush(self.0), flush(other.0))))
            }
        }
    };
}

flushed!(Add, add);
flushed!(Sub, sub);
flushed!(Mul, mul);
flushed!(Div, div);

impl<T: Element> Neg for Flushed<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Flushed(-self.0)
    }
}

macro_rules! compared {
    ($($method:ident)*) => {
        $(#[inline(never)]
        fn $method(self, other: Self) -> bool {
            flush(self.0).$method(flush(other.0))
        })*
    };
}

impl<T: Element> Real for Flushed<T> {
    type Mask = bool;
    type Element = Self;
    type Token = ();
    const LANES: usize = 1;

    fn token(self) {}
    fn splat((): (), element: Self) -> Self {
        element
    }
    fn load((): (), elements: &[Self]) -> Self {
        elements[0]
    }
    fn store(self, elements: &mut [Self]) {
        elements[0] = self;
    }
    fn mask((): (), truth: bool) -> bool {
        truth
    }
    compared!(lt le gt ge ne);
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    fn signed_by(self, sign: Self) -> Self {
        Flushed(self.0.signed_by(sign.0))
    }
    fn sign_bit(self) -> bool {
        self.0.sign_bit()
    }
    #[inline(never)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Flushed(flush(flush(self.0).mul_add(flush(factor.0), flush(addend.0))))
    }
}

impl<T: Element> Element for Flushed<T> {
    type Wide = Flushed<T::Wide>;
    const NAME: &'static str = T::NAME;
    const ZERO: Self = Flushed(T::ZERO);
    const ONE: Self = Flushed(T::ONE);
    const LARGEST_SUBNORMAL: Self = Flushed(T::LARGEST_SUBNORMAL);
    const UNIT_ROUNDOFF: Self = Flushed(T::UNIT_ROUNDOFF);
    const EPSILON: Self = Flushed(T::EPSILON);
    const MAX: Self = Flushed(T::MAX);
    const SPLITTER: Self = Flushed(T::SPLITTER);
    fn from_f32(value: f32) -> Self {
        Flushed(flush(T::from_f32(value)))
    }
    fn from_f64(value: f64) -> Self {
        Flushed(flush(T::from_f64(value)))
    }
    fn to_f64(self) -> f64 {
        flush(self.0).to_f64()
    }
    fn widened(self) -> Self::Wide {
        Flushed(flush(self.0).widened())
    }
    fn narrowed(wide: Self::Wide) -> Self {
        Flushed(flush(T::narrowed(flush(wide.0))))
    }
    fn bits(self) -> u64 {
        self.0.bits()
    }
    fn from_bits(bits: u64) -> Self {
        Flushed(T::from_bits(bits))
    }
    fn from_index(index: u32) -> Self {
        Flushed(T::from_index(index))
    }
    fn index(self) -> u32 {
        self.0.index()
    }
    fn sqrt(self) -> Self {
        Flushed(flush(flush(self.0).sqrt()))
    }
    fn acos(self) -> Self {
        Flushed(flush(flush(self.0).acos()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SMALLEST: f32 = f32::MIN_POSITIVE;

    /// The bits, so that the zeros are told apart.
    fn bits(x: Flushed<f32>) -> u32 {
        x.0.to_bits()
    }

    #[test]
    fn subnormal_results_become_the_zero_of_their_sign() {
        let (smallest, half) = (Flushed(SMALLEST), Flushed(0.5));
        for (result, wanted) in [
            (smallest * half, 0.0f32),
            (-smallest * half, -0.0),
            (smallest / (half + half + half + half), 0.0),
            (Flushed(1.5 * SMALLEST) - smallest, 0.0),
            (smallest - Flushed(1.5 * SMALLEST), -0.0),
            (smallest.mul_add(half, Flushed(0.0)), 0.0),
            (smallest.mul_add(half, smallest), 1.5 * SMALLEST),
            (smallest * (half + half), SMALLEST),
            (Flushed::from_f64(f64::from(SMALLEST) / 2.0), 0.0),
            (Flushed::narrowed(Flushed(-f64::from(SMALLEST) / 2.0)), -0.0),
        ] {
            assert_eq!(bits(result), wanted.to_bits(), "{result:?}, expected {wanted:e}");
        }
    }

    #[test]
    fn subnormal_operands_count_as_zero() {
        let (subnormal, one) = (Flushed(SMALLEST / 4.0), Flushed(1.0f32));
        let large = Flushed(f32::MAX);
        assert_eq!(bits(subnormal * large), 0);
        assert_eq!(bits(-subnormal * large), (-0.0f32).to_bits());
        assert_eq!((one / subnormal).0, f32::INFINITY);
        assert_eq!((one / -subnormal).0, f32::NEG_INFINITY);
        assert_eq!(subnormal.mul_add(large, one).0, 1.0);
        assert!(
            subnormal.le(Flushed(0.0)) && !subnormal.gt(Flushed(0.0)) && !subnormal.ne(-subnormal)
        );
        // A product of two of them is far from subnormal in f64; the operands were zero before.
        assert_eq!(subnormal.widened().0, 0.0);
    }

    #[test]
    fn other_numbers_are_those_of_the_type() {
        let (x, y) = (Flushed(0.1f32), Flushed(0.3f32));
        assert_eq!((x * y + x / y - y).0, 0.1f32 * 0.3 + 0.1 / 0.3 - 0.3);
        assert!((x / Flushed(0.0) - x / Flushed(0.0)).ne(x));
        assert!(!Flushed(f32::NAN).le(x) && Flushed(f32::NAN).0.is_nan());
        assert!((Flushed(f32::NAN) + x).0.is_nan(), "NaN is not flushed");
    }
}

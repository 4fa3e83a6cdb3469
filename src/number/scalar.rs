//! `f32` and `f64` as numbers.

use std::hint::black_box;

use super::{Element, Mask, Real};

impl Mask for bool {
    const LANES: usize = 1;
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn lane(self, _: usize) -> bool {
        self
    }
}

/// Both scalars from one text; what differs is named in the call.
macro_rules! scalar {
    ($float:ident, $bits:ident, $name:literal, $acos:path, $sign:expr, $splitter:expr) => {
        impl Real for $float {
            type Mask = bool;
            type Element = Self;
            type Token = ();
            const LANES: usize = 1;

            #[inline(always)]
            fn token(self) {}
            #[inline(always)]
            fn splat((): (), element: Self) -> Self {
                element
            }
            #[inline(always)]
            fn load((): (), elements: &[Self]) -> Self {
                elements[0]
            }
            #[inline(always)]
            fn store(self, elements: &mut [Self]) {
                elements[0] = self;
            }
            #[inline(always)]
            fn mask((): (), truth: bool) -> bool {
                truth
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn le(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn gt(self, other: Self) -> bool {
                self > other
            }
            #[inline(always)]
            fn ge(self, other: Self) -> bool {
                self >= other
            }
            #[inline(always)]
            fn ne(self, other: Self) -> bool {
                self != other
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            #[inline(always)]
            fn blend<const N: usize>(mask: bool, yes: [Self; N], mut no: [Self; N]) -> [Self; N] {
                let keep = black_box($bits::from(mask).wrapping_neg());
                for (no, yes) in no.iter_mut().zip(yes) {
                    *no = Self::from_bits((yes.to_bits() & keep) | (no.to_bits() & !keep));
                }
                no
            }
            #[inline(always)]
            fn signed_by(self, sign: Self) -> Self {
                Self::from_bits(self.to_bits() ^ (sign.to_bits() & $sign))
            }
            #[inline(always)]
            fn sign_bit(self) -> bool {
                self.to_bits() & $sign != 0
            }
            #[inline(always)]
            fn either_sign(self, other: Self) -> Self {
                Self::from_bits(self.to_bits() | other.to_bits())
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                <$float>::mul_add(self, factor, addend)
            }
        }

        impl Element for $float {
            type Wide = f64;
            const NAME: &'static str = $name;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const LARGEST_SUBNORMAL: Self = <$float>::MIN_POSITIVE.next_down();
            const UNIT_ROUNDOFF: Self = <$float>::EPSILON / 2.0;
            const EPSILON: Self = <$float>::EPSILON;
            const MAX: Self = <$float>::MAX;
            const SPLITTER: Self = $splitter;
            #[inline(always)]
            fn from_f32(value: f32) -> Self {
                Self::from(value)
            }
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as Self
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn widened(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn narrowed(wide: f64) -> Self {
                wide as Self
            }
            #[inline(always)]
            fn bits(self) -> u64 {
                u64::from(self.to_bits())
            }
            #[inline(always)]
            fn from_bits(bits: u64) -> Self {
                <$float>::from_bits(bits as $bits)
            }
            /// The bits themselves, so that no conversion stands between memory and an address.
            #[inline(always)]
            fn from_index(index: u32) -> Self {
                <$float>::from_bits($bits::from(index))
            }
            #[inline(always)]
            fn index(self) -> u32 {
                self.to_bits() as u32
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                <$float>::sqrt(self)
            }
            #[inline(always)]
            fn acos(self) -> Self {
                $acos(self)
            }
        }
    };
}

// 24 digits are split into 12 and 12, 53 into 26 and 26 with a sign between them.
scalar!(f32, u32, "f32", libm::acosf, 1 << 31, 4_097.0);
scalar!(f64, u64, "f64", libm::acos, 1 << 63, 134_217_729.0);

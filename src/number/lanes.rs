//! Packets: one lane a ray, in the vector registers of an instruction-set level.
//!
//! One implementation serves every width, precision and level, because `fearless_simd` names its
//! operations the same for all of them. The wrapper exists only so that our trait can be
//! implemented for all of its types at once.

use std::marker::PhantomData;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use fearless_simd::{Select, Simd, SimdFloat, SimdMask};

use super::masked::Masked;
use super::{Element, Extremes, Mask, Real, Toggle};

/// A vector register (or several) of floats of level `S`, seen as one number.
#[derive(Clone, Copy)]
pub struct Lanes<S, V>(V, PhantomData<S>);

impl<S, V> Lanes<S, V> {
    /// Of a register.
    #[inline(always)]
    pub(super) fn of(register: V) -> Self {
        Lanes(register, PhantomData)
    }
    /// The register.
    #[inline(always)]
    pub(super) fn register(self) -> V {
        self.0
    }
}

/// The mask that belongs to [`Lanes`].
#[derive(Clone, Copy)]
pub struct LaneMask<S, M>(M, PhantomData<S>);

impl<S: Simd, M: SimdMask<S>> Mask for LaneMask<S, M> {
    const LANES: usize = M::LEN;
    #[inline(always)]
    fn any(self) -> bool {
        self.0.any_true()
    }
    #[inline(always)]
    fn lane(self, lane: usize) -> bool {
        self.0.to_bitmask() >> lane & 1 != 0
    }
}

macro_rules! binary {
    ($type:ident, $vector:path, $trait:ident, $method:ident) => {
        impl<S: Simd, V: $vector> $trait for $type<S, V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                $type(self.0.$method(other.0), PhantomData)
            }
        }
    };
}

binary!(LaneMask, SimdMask<S>, BitAnd, bitand);
binary!(LaneMask, SimdMask<S>, BitOr, bitor);
binary!(Lanes, SimdFloat<S>, Add, add);
binary!(Lanes, SimdFloat<S>, Sub, sub);
binary!(Lanes, SimdFloat<S>, Mul, mul);
binary!(Lanes, SimdFloat<S>, Div, div);

impl<S: Simd, M: SimdMask<S>> Not for LaneMask<S, M> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        LaneMask(!self.0, PhantomData)
    }
}

impl<S: Simd, V: SimdFloat<S>> Neg for Lanes<S, V> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Lanes(-self.0, PhantomData)
    }
}

impl<S, V> Real for Lanes<S, V>
where
    S: Masked<V>,
    V: SimdFloat<S, Element: Element>,
{
    type Mask = LaneMask<S, V::Mask>;
    type Element = V::Element;
    type Token = S;
    const LANES: usize = V::LEN;

    #[inline(always)]
    fn token(self) -> S {
        self.0.token()
    }
    #[inline(always)]
    fn splat(token: S, element: V::Element) -> Self {
        Lanes(V::splat(token, element), PhantomData)
    }
    #[inline(always)]
    fn load(token: S, elements: &[V::Element]) -> Self {
        Lanes(V::from_slice(token, &elements[..V::LEN]), PhantomData)
    }
    #[inline(always)]
    fn store(self, elements: &mut [V::Element]) {
        self.0.store_slice(&mut elements[..V::LEN]);
    }
    #[inline(always)]
    fn mask(token: S, truth: bool) -> Self::Mask {
        LaneMask(V::Mask::splat(token, truth), PhantomData)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        LaneMask(self.0.simd_lt(other.0), PhantomData)
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        LaneMask(self.0.simd_le(other.0), PhantomData)
    }
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        LaneMask(self.0.simd_gt(other.0), PhantomData)
    }
    #[inline(always)]
    fn ge(self, other: Self) -> Self::Mask {
        LaneMask(self.0.simd_ge(other.0), PhantomData)
    }
    #[inline(always)]
    fn ne(self, other: Self) -> Self::Mask {
        LaneMask(!self.0.simd_eq(other.0), PhantomData)
    }
    #[inline(always)]
    fn lt_where(self, other: Self, mask: Self::Mask) -> Self::Mask {
        LaneMask(S::lt_where(mask.0, self.0, other.0), PhantomData)
    }
    #[inline(always)]
    fn le_where(self, other: Self, mask: Self::Mask) -> Self::Mask {
        LaneMask(S::le_where(mask.0, self.0, other.0), PhantomData)
    }
    #[inline(always)]
    fn ge_where(self, other: Self, mask: Self::Mask) -> Self::Mask {
        other.le_where(self, mask)
    }
    #[inline(always)]
    fn ne_where(self, other: Self, mask: Self::Mask) -> Self::Mask {
        LaneMask(S::ne_where(mask.0, self.0, other.0), PhantomData)
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Lanes(mask.0.select(yes.0, no.0), PhantomData)
    }
    #[inline(always)]
    fn signed_by(self, sign: Self) -> Self {
        let minus_zero = (-V::splat(self.0.token(), V::Element::ZERO)).to_bits();
        let flipped = self.0.to_bits() ^ (sign.0.to_bits() & minus_zero);
        Lanes(V::from_bits(flipped), PhantomData)
    }
    #[inline(always)]
    fn sign_bit(self) -> Self::Mask {
        LaneMask(self.0.is_sign_negative(), PhantomData)
    }
    #[inline(always)]
    fn either_sign(self, other: Self) -> Self {
        Lanes(V::from_bits(self.0.to_bits() | other.0.to_bits()), PhantomData)
    }
    #[inline(always)]
    fn estimated_inverse(self) -> Self {
        Lanes(self.0.approximate_recip(), PhantomData)
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Lanes(self.0.mul_add(factor.0, addend.0), PhantomData)
    }
}

impl<S, V> Toggle for Lanes<S, V>
where
    S: Masked<V>,
    V: SimdFloat<S, Element: Element>,
{
    #[inline(always)]
    fn toggled(self, bits: Self) -> Self {
        Lanes(V::from_bits(self.0.to_bits() ^ bits.0.to_bits()), PhantomData)
    }
}

impl<S, V> Extremes for Lanes<S, V>
where
    S: Masked<V>,
    V: SimdFloat<S, Element: Element>,
{
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Lanes(self.0.max(other.0), PhantomData)
    }
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Lanes(self.0.min(other.0), PhantomData)
    }
    #[inline(always)]
    fn bits(mask: Self::Mask) -> u64 {
        mask.0.to_bitmask()
    }
}

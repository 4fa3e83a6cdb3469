//! A single number that notes what is done with it: what a triangle's numbers are before they are put
//! into every lane.
//!
//! Operations are never inlined: a kernel is hundreds of them, in every form, and nothing here is timed.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Noted, Place, Word, note};
use crate::number::{Element, Real};

/// A single number. Comparisons of it are answered and not noted: they are done once per triangle.
#[derive(Clone, Copy, Debug)]
pub struct TracedOne(Word);

impl TracedOne {
    /// A number that comes from outside.
    pub fn input(noted: Noted, value: f64) -> Self {
        Self::at(note(noted, [None; 3], value))
    }
    /// What stands at a place.
    pub(super) fn at(place: Place) -> Self {
        TracedOne(Word::of(place))
    }
    /// Where it stands.
    pub(super) fn place(self) -> Place {
        self.0.place()
    }
    /// What it is.
    pub(super) fn value(self) -> f64 {
        self.0.value()
    }
    const fn constant(value: f64) -> Self {
        TracedOne(Word::constant(value.to_bits()))
    }
    fn is(self, value: f64) -> bool {
        self.place() == Place::Constant(value.to_bits())
    }
    /// The result of an operation: a constant, if all operands are.
    #[inline(never)]
    fn noted<const N: usize>(noted: Noted, operands: [Self; N], value: f64) -> Self {
        if operands.iter().all(|operand| matches!(operand.place(), Place::Constant(_))) {
            return Self::constant(value);
        }
        let mut places = [None; 3];
        for (place, operand) in places.iter_mut().zip(operands) {
            *place = Some(operand.place());
        }
        Self::at(note(noted, places, value))
    }
    /// Two operands whose order makes no difference.
    #[inline(never)]
    fn ordered(self, other: Self) -> [Self; 2] {
        if other.place() < self.place() { [other, self] } else { [self, other] }
    }
}

impl Add for TracedOne {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let value = self.value() + other.value();
        match (self, other) {
            (zero, x) | (x, zero) if zero.is(-0.0) => x,
            _ => Self::noted(Noted::Add, self.ordered(other), value),
        }
    }
}

impl Sub for TracedOne {
    type Output = Self;
    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        if other.is(0.0) {
            return self;
        }
        // Not the sum of the same operands: the third says so.
        let mark = Self::constant(-1.0);
        Self::noted(Noted::Add, [self, other, mark], self.value() - other.value())
    }
}

impl Mul for TracedOne {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        match (self, other) {
            (one, x) | (x, one) if one.is(1.0) => x,
            _ => Self::noted(Noted::Multiply, self.ordered(other), self.value() * other.value()),
        }
    }
}

impl Div for TracedOne {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        if other.is(1.0) {
            return self;
        }
        Self::noted(Noted::Divide, [self, other], self.value() / other.value())
    }
}

impl Neg for TracedOne {
    type Output = Self;
    #[inline(never)]
    fn neg(self) -> Self {
        Self::noted(Noted::Free(2), [self], -self.value())
    }
}

macro_rules! compared {
    ($($method:ident $operator:tt)*) => {
        $(#[inline(never)]
        fn $method(self, other: Self) -> bool {
            self.value() $operator other.value()
        })*
    };
}

impl Real for TracedOne {
    type Mask = bool;
    type Element = Self;
    type Token = ();
    const LANES: usize = 1;

    compared!(lt < le <= gt > ge >= ne !=);

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
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    #[inline(never)]
    fn signed_by(self, sign: Self) -> Self {
        Self::noted(Noted::Flip, [self, sign], self.value().signed_by(sign.value()))
    }
    fn sign_bit(self) -> bool {
        self.value().sign_bit()
    }
    #[inline(never)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        if self.is(1.0) || factor.is(1.0) {
            return self * factor + addend;
        }
        let [a, b] = self.ordered(factor);
        Self::noted(
            Noted::Fused,
            [a, b, addend],
            self.value().mul_add(factor.value(), addend.value()),
        )
    }
}

impl Element for TracedOne {
    type Wide = Self;
    const NAME: &'static str = "traced";
    const ZERO: Self = Self::constant(0.0);
    const ONE: Self = Self::constant(1.0);
    const LARGEST_SUBNORMAL: Self = Self::constant(f64::LARGEST_SUBNORMAL);
    const UNIT_ROUNDOFF: Self = Self::constant(f64::UNIT_ROUNDOFF);
    const EPSILON: Self = Self::constant(f64::EPSILON);
    const MAX: Self = Self::constant(f64::MAX);
    const SPLITTER: Self = Self::constant(f64::SPLITTER);
    fn from_f32(value: f32) -> Self {
        Self::constant(f64::from(value))
    }
    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }
    fn to_f64(self) -> f64 {
        self.value()
    }
    fn widened(self) -> Self {
        self
    }
    fn narrowed(wide: Self) -> Self {
        wide
    }
    fn bits(self) -> u64 {
        self.value().to_bits()
    }
    fn from_bits(bits: u64) -> Self {
        Self::constant(f64::from_bits(bits))
    }
    fn sqrt(self) -> Self {
        Self::noted(Noted::Free(3), [self], self.value().sqrt())
    }
    fn acos(self) -> Self {
        Self::noted(Noted::Free(4), [self], self.value().acos())
    }
}

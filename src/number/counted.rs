//! A number that counts what is done with it.

use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Element, Real};

/// Operations by kind, as executed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions.
    pub add: u64,
    /// Subtractions, unary minus excluded.
    pub sub: u64,
    /// Unary minuses (thesis B counts them as subtractions).
    pub neg: u64,
    /// Multiplications.
    pub mul: u64,
    /// Divisions.
    pub div: u64,
    /// Comparisons of numbers.
    pub compare: u64,
    /// If-statements of a published listing.
    pub condition: u64,
}

thread_local! {
    static SO_FAR: Cell<Operations> = const { Cell::new(Operations { add: 0, sub: 0, neg: 0, mul: 0, div: 0, compare: 0, condition: 0 }) };
}

fn tick(change: impl FnOnce(&mut Operations)) {
    let mut operations = SO_FAR.get();
    change(&mut operations);
    SO_FAR.set(operations);
}

/// Runs `body` and returns its value with the operations that it executed on this thread.
pub fn count<T>(body: impl FnOnce() -> T) -> (T, Operations) {
    let before = SO_FAR.replace(Operations::default());
    let value = body();
    (value, SO_FAR.replace(before))
}

/// `T` with its arithmetic counted. Flips of a sign bit and selections are not arithmetic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counted<T>(pub T);

macro_rules! counted {
    ($trait:ident, $method:ident, $field:ident) => {
        impl<T: Element> $trait for Counted<T> {
            type Output = Self;
            #[inline(never)]
            fn $method(self, other: Self) -> Self {
                tick(|operations| operations.$field += 1);
                Counted($trait::$method(self.0, other.0))
            }
        }
    };
}

counted!(Add, add, add);
counted!(Sub, sub, sub);
counted!(Mul, mul, mul);
counted!(Div, div, div);

impl<T: Element> Neg for Counted<T> {
    type Output = Self;
    fn neg(self) -> Self {
        tick(|operations| operations.neg += 1);
        Counted(-self.0)
    }
}

macro_rules! compared {
    ($($method:ident)*) => {
        $(#[inline(never)]
        fn $method(self, other: Self) -> bool {
            tick(|operations| operations.compare += 1);
            self.0.$method(other.0)
        })*
    };
}

impl<T: Element> Real for Counted<T> {
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
        Counted(self.0.signed_by(sign.0))
    }
    fn sign_bit(self) -> bool {
        self.0.sign_bit()
    }
    #[inline(never)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        tick(|operations| {
            operations.mul += 1;
            operations.add += 1;
        });
        Counted(self.0.mul_add(factor.0, addend.0))
    }
}

impl<T: Element> Element for Counted<T> {
    type Wide = Counted<T::Wide>;
    const NAME: &'static str = "counted";
    const ZERO: Self = Counted(T::ZERO);
    const ONE: Self = Counted(T::ONE);
    const LARGEST_SUBNORMAL: Self = Counted(T::LARGEST_SUBNORMAL);
    const UNIT_ROUNDOFF: Self = Counted(T::UNIT_ROUNDOFF);
    const EPSILON: Self = Counted(T::EPSILON);
    const MAX: Self = Counted(T::MAX);
    const SPLITTER: Self = Counted(T::SPLITTER);
    fn from_f32(value: f32) -> Self {
        Counted(T::from_f32(value))
    }
    fn from_f64(value: f64) -> Self {
        Counted(T::from_f64(value))
    }
    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }
    fn widened(self) -> Self::Wide {
        Counted(self.0.widened())
    }
    fn narrowed(wide: Self::Wide) -> Self {
        Counted(T::narrowed(wide.0))
    }
    fn bits(self) -> u64 {
        self.0.bits()
    }
    fn from_bits(bits: u64) -> Self {
        Counted(T::from_bits(bits))
    }
    fn from_index(index: u32) -> Self {
        Counted(T::from_index(index))
    }
    fn index(self) -> u32 {
        self.0.index()
    }
    fn sqrt(self) -> Self {
        Counted(self.0.sqrt())
    }
    fn acos(self) -> Self {
        Counted(self.0.acos())
    }
    fn condition(truth: bool) -> bool {
        tick(|operations| operations.condition += 1);
        truth
    }
}

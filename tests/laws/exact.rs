//! Rational numbers that a kernel can compute with.

use std::cell::RefCell;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_int::UBig;
use dashu_int::ops::SquareRoot;
use dashu_ratio::RBig;
use ray_test::number::{Element, Real};

/// A rational number, or undefined (x / 0): a handle into an arena of this thread, since kernels
/// copy their numbers.
///
/// Every comparison with an undefined number is false, `ne` included, and its sign bit is set, so
/// that no test, of either form, accepts it. Arithmetic knows one zero, whose sign bit says "not
/// negative"; flipping it gives a zero that only `signed_by` and `sign_bit` tell from it, so that a
/// chain of flips is the exclusive or of the signs that thesis H prints.
#[derive(Clone, Copy)]
pub struct Exact {
    place: u32,
    /// The case that the number belongs to; 0 for constants.
    epoch: u32,
}

struct Arena {
    numbers: Vec<RBig>,
    epoch: u32,
}

/// Zero, one, a number above all that the tests draw, and the flipped zero.
fn constants() -> Vec<RBig> {
    vec![RBig::ZERO, RBig::ONE, RBig::try_from(f64::MAX).unwrap(), RBig::ZERO]
}

thread_local! {
    static ARENA: RefCell<Arena> = RefCell::new(Arena { numbers: constants(), epoch: 1 });
}

/// Ends a case: its numbers are dropped, and using one of them afterwards panics.
pub fn reset() {
    ARENA.with_borrow_mut(|arena| {
        arena.numbers.truncate(constants().len());
        arena.epoch += 1;
    });
}

impl Arena {
    fn get(&self, x: Exact) -> Option<&RBig> {
        if x.place == Exact::UNDEFINED.place {
            return None;
        }
        assert!(x.epoch == 0 || x.epoch == self.epoch, "a number of an earlier case");
        Some(&self.numbers[x.place as usize])
    }

    fn put(&mut self, number: Option<RBig>) -> Exact {
        let Some(number) = number else { return Exact::UNDEFINED };
        let place = u32::try_from(self.numbers.len()).unwrap();
        self.numbers.push(number);
        Exact { place, epoch: self.epoch }
    }
}

fn binary(a: Exact, b: Exact, apply: impl FnOnce(&RBig, &RBig) -> Option<RBig>) -> Exact {
    ARENA.with_borrow_mut(|arena| {
        let number = arena.get(a).zip(arena.get(b)).and_then(|(a, b)| apply(a, b));
        arena.put(number)
    })
}

fn compare(a: Exact, b: Exact, apply: impl FnOnce(&RBig, &RBig) -> bool) -> bool {
    ARENA.with_borrow(|arena| arena.get(a).zip(arena.get(b)).is_some_and(|(a, b)| apply(a, b)))
}

impl Exact {
    /// What a division by zero gives.
    pub const UNDEFINED: Exact = Exact { place: u32::MAX, epoch: 0 };
    /// What a flip makes of zero.
    const FLIPPED_ZERO: Exact = Exact { place: 3, epoch: 0 };

    /// The exact value of a finite f64.
    pub fn of(value: f64) -> Self {
        ARENA.with_borrow_mut(|arena| arena.put(Some(RBig::try_from(value).unwrap())))
    }
    /// Whether it is a number.
    pub fn is_defined(self) -> bool {
        self.place != Self::UNDEFINED.place
    }
    /// Whether it is the number zero.
    pub fn is_zero(self) -> bool {
        compare(self, Self::ZERO, |a, b| a == b)
    }
    /// Whether both are the same number, or both undefined.
    pub fn same(self, other: Self) -> bool {
        self.is_defined() == other.is_defined()
            && (!self.is_defined() || compare(self, other, |a, b| a == b))
    }
}

impl fmt::Debug for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        ARENA.with_borrow(|arena| match arena.get(*self) {
            Some(number) => write!(f, "{number}"),
            None => write!(f, "undefined"),
        })
    }
}

impl Add for Exact {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        binary(self, other, |a, b| Some(a + b))
    }
}
impl Sub for Exact {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        binary(self, other, |a, b| Some(a - b))
    }
}
impl Mul for Exact {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        binary(self, other, |a, b| Some(a * b))
    }
}
impl Div for Exact {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        binary(self, other, |a, b| (!b.is_zero()).then(|| a / b))
    }
}
impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self::ZERO - self
    }
}

impl Real for Exact {
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
    fn lt(self, other: Self) -> bool {
        compare(self, other, |a, b| a < b)
    }
    fn le(self, other: Self) -> bool {
        compare(self, other, |a, b| a <= b)
    }
    fn gt(self, other: Self) -> bool {
        compare(self, other, |a, b| a > b)
    }
    fn ge(self, other: Self) -> bool {
        compare(self, other, |a, b| a >= b)
    }
    fn ne(self, other: Self) -> bool {
        compare(self, other, |a, b| a != b)
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    fn signed_by(self, sign: Self) -> Self {
        match (sign.is_defined(), sign.sign_bit()) {
            (false, _) => Self::UNDEFINED,
            (true, false) => self,
            (true, true) if !self.is_zero() => -self,
            (true, true) if self.sign_bit() => Self::ZERO,
            (true, true) => Self::FLIPPED_ZERO,
        }
    }
    fn sign_bit(self) -> bool {
        self.place == Self::FLIPPED_ZERO.place || !self.ge(Self::ZERO)
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
}

impl Element for Exact {
    type Wide = Self;
    const NAME: &'static str = "exact";
    const ZERO: Self = Exact { place: 0, epoch: 0 };
    const ONE: Self = Exact { place: 1, epoch: 0 };
    const LARGEST_SUBNORMAL: Self = Self::ZERO;
    const UNIT_ROUNDOFF: Self = Self::ZERO;
    const EPSILON: Self = Self::ZERO;
    const MAX: Self = Exact { place: 2, epoch: 0 };
    const SPLITTER: Self = Self::ONE;

    fn from_f32(value: f32) -> Self {
        Self::of(f64::from(value))
    }
    fn from_f64(value: f64) -> Self {
        Self::of(value)
    }
    fn to_f64(self) -> f64 {
        ARENA
            .with_borrow(|arena| arena.get(self).map_or(f64::NAN, |number| number.to_f64().value()))
    }
    fn widened(self) -> Self {
        self
    }
    fn narrowed(wide: Self) -> Self {
        wide
    }
    fn bits(self) -> u64 {
        0
    }
    fn from_bits(_: u64) -> Self {
        Self::ZERO
    }
    /// Undefined where the root is not rational.
    fn sqrt(self) -> Self {
        binary(self, Self::ONE, |square, _| {
            let top = UBig::try_from(square.numerator().clone()).ok()?.sqrt();
            let root = RBig::from_parts(top.into(), square.denominator().sqrt());
            (&root * &root == *square).then_some(root)
        })
    }
    /// An arc cosine is not rational.
    fn acos(self) -> Self {
        Self::UNDEFINED
    }
}

#[test]
fn exact_numbers_are_a_field_with_an_undefined_element() {
    let (third, two) = (Exact::ONE / Exact::of(3.0), Exact::of(2.0));
    assert!((third + third + third).same(Exact::ONE) && !third.is_zero());
    assert!(third.mul_add(two, -third).same(third), "a b + c");
    assert!((two - third).gt(Exact::ONE) && third.lt(two) && third.le(third) && third.ge(third));
    assert!(third.ne(two) && !third.ne(third) && Exact::MAX.gt(two));
    assert!((-third).sign_bit() && !third.sign_bit() && !Exact::ZERO.sign_bit());
    assert!(third.signed_by(-two).same(-third) && (-third).signed_by(-third).same(third));
    let flipped = (third - third).signed_by(-two);
    assert!(flipped.is_zero() && flipped.sign_bit() && !flipped.signed_by(-two).sign_bit());
    assert!(!(flipped + Exact::ZERO).sign_bit() && !(-flipped).sign_bit());
    assert!((third * third).sqrt().same(third) && Exact::ZERO.sqrt().same(Exact::ZERO));
    assert!(!two.sqrt().is_defined() && !(-two).sqrt().is_defined());
    assert_eq!((third.to_f64(), Exact::from_f32(0.1).to_f64()), (1.0 / 3.0, f64::from(0.1f32)));

    let undefined = Exact::ONE / Exact::ZERO;
    for x in
        [undefined + two, two - undefined, undefined * Exact::ZERO, undefined / two, -undefined]
    {
        assert!(!x.is_defined() && x.same(undefined) && !x.same(two) && x.sign_bit());
        assert!(!(x.lt(two) | x.le(x) | x.gt(two) | x.ge(x) | x.ne(two) | x.ne(x) | x.is_zero()));
    }
    assert!(!two.signed_by(undefined).is_defined());
}

#[test]
#[should_panic(expected = "earlier case")]
fn a_number_does_not_outlive_its_case() {
    let two = Exact::of(2.0);
    reset();
    let _ = two + two;
}

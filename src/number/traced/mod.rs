//! Numbers that note what is done with them: what an optimiser leaves of a test.
//!
//! [`super::Counted`] counts what is written, this what remains of it: the same operation on the same
//! operands once; nothing whose result nobody asks for; no multiplication by a constant 1; what
//! depends on the ray alone before the loop, and what depends on the triangle alone once for all
//! lanes. Values are computed along, so that a kernel can look at what it picks by index.

mod element;
mod graph;

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

pub use element::TracedOne;
use graph::Word;
pub use graph::{Needed, Noted, Place, needed, note};

use super::{Mask, Real};

/// A number of a lane, `LANES` of which are said to lie side by side.
#[derive(Clone, Copy, Debug)]
pub struct Traced<const LANES: usize>(TracedOne);

impl<const LANES: usize> Traced<LANES> {
    /// A number that comes from outside.
    #[inline(never)]
    pub fn input(noted: Noted, value: f64) -> Self {
        Traced(TracedOne::input(noted, value))
    }
    /// The same number, kept in memory and put into every lane from there.
    #[inline(never)]
    pub fn kept(self) -> Self {
        let place = note(Noted::Kept, [Some(self.place()), None, None], self.0.value());
        Traced(TracedOne::at(place))
    }
    /// Where it stands.
    pub fn place(self) -> Place {
        self.0.place()
    }
    #[inline(never)]
    fn compared(self, which: u8, other: Self, truth: bool) -> TracedMask<LANES> {
        TracedMask::of(Noted::Compare(which), [self.place(), other.place()], truth)
    }
}

/// Truth of a lane.
#[derive(Clone, Copy, Debug)]
pub struct TracedMask<const LANES: usize>(Word);

impl<const LANES: usize> TracedMask<LANES> {
    /// Where it stands.
    pub fn place(self) -> Place {
        self.0.place()
    }
    fn at(place: Place) -> Self {
        TracedMask(Word::of(place))
    }
    fn constant(truth: bool) -> Self {
        TracedMask(Word::constant(u64::from(truth)))
    }
    #[inline(never)]
    fn of(noted: Noted, operands: [Place; 2], truth: bool) -> Self {
        if operands.iter().all(|place| matches!(place, Place::Constant(_))) {
            return Self::constant(truth);
        }
        let operands = [Some(operands[0]), Some(operands[1]), None];
        Self::at(note(noted, operands, f64::from(u8::from(truth))))
    }
    /// `identity` is the truth value that leaves the other operand as it is.
    #[inline(never)]
    fn joined(self, other: Self, identity: bool) -> Self {
        let neutral = Place::Constant(u64::from(identity));
        let absorbing = Place::Constant(u64::from(!identity));
        let (one, two) = (self.0.truth(), other.0.truth());
        let truth = if identity { one & two } else { one | two };
        match (self.place(), other.place()) {
            (a, b) if a == neutral || a == b => other,
            (_, b) if b == neutral => self,
            (a, b) if a == absorbing || b == absorbing => Self::constant(!identity),
            (a, b) => Self::of(Noted::Join(identity), [a.min(b), a.max(b)], truth),
        }
    }
}

impl<const LANES: usize> BitAnd for TracedMask<LANES> {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        self.joined(other, true)
    }
}

impl<const LANES: usize> BitOr for TracedMask<LANES> {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        self.joined(other, false)
    }
}

impl<const LANES: usize> Not for TracedMask<LANES> {
    type Output = Self;
    #[inline(never)]
    fn not(self) -> Self {
        let truth = !self.0.truth();
        if let Place::Constant(_) = self.place() {
            return Self::constant(truth);
        }
        let operands = [Some(self.place()), None, None];
        Self::at(note(Noted::Free(0), operands, f64::from(u8::from(truth))))
    }
}

impl<const LANES: usize> Mask for TracedMask<LANES> {
    const LANES: usize = LANES;
    fn any(self) -> bool {
        self.0.truth()
    }
    fn lane(self, _: usize) -> bool {
        self.0.truth()
    }
}

macro_rules! through_one {
    ($($trait:ident $method:ident)*) => {$(
        impl<const LANES: usize> $trait for Traced<LANES> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Traced(self.0.$method(other.0))
            }
        }
    )*};
}

through_one!(Add add Sub sub Mul mul Div div);

impl<const LANES: usize> Neg for Traced<LANES> {
    type Output = Self;
    fn neg(self) -> Self {
        Traced(-self.0)
    }
}

macro_rules! compared {
    ($($method:ident $which:literal)*) => {
        $(fn $method(self, other: Self) -> Self::Mask {
            self.compared($which, other, self.0.$method(other.0))
        })*
    };
}

impl<const LANES: usize> Real for Traced<LANES> {
    type Mask = TracedMask<LANES>;
    type Element = TracedOne;
    type Token = ();
    const LANES: usize = LANES;

    compared!(lt 0 le 1 gt 2 ge 3 ne 4);

    fn token(self) {}
    fn splat((): (), element: TracedOne) -> Self {
        Traced(element)
    }
    fn load((): (), elements: &[TracedOne]) -> Self {
        Traced(elements[0])
    }
    fn store(self, elements: &mut [TracedOne]) {
        elements[..LANES].fill(self.0);
    }
    fn mask((): (), truth: bool) -> Self::Mask {
        TracedMask::constant(truth)
    }
    #[inline(never)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        let chosen = if mask.0.truth() { yes } else { no };
        if matches!(mask.place(), Place::Constant(_)) || yes.place() == no.place() {
            return chosen;
        }
        let operands = [Some(mask.place()), Some(yes.place()), Some(no.place())];
        Traced(TracedOne::at(note(Noted::Select, operands, chosen.0.value())))
    }
    fn signed_by(self, sign: Self) -> Self {
        Traced(self.0.signed_by(sign.0))
    }
    #[inline(never)]
    fn sign_bit(self) -> Self::Mask {
        let truth = self.0.sign_bit();
        if let Place::Constant(_) = self.place() {
            return TracedMask::constant(truth);
        }
        let operands = [Some(self.place()), None, None];
        TracedMask::at(note(Noted::Free(1), operands, f64::from(u8::from(truth))))
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Traced(self.0.mul_add(factor.0, addend.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Element;

    type One = Traced<2>;

    fn ray(value: f64) -> One {
        One::input(Noted::OfRay, value)
    }

    fn triangle(place: usize, value: f64) -> One {
        One::input(Noted::OfTriangle(place), value)
    }

    fn sorted(mut needed: Needed) -> Needed {
        needed.each.sort_by_key(|noted| format!("{noted:?}"));
        needed.once.sort_by_key(|noted| format!("{noted:?}"));
        needed
    }

    #[test]
    fn what_is_the_same_is_noted_once_and_what_nobody_needs_not_at_all() {
        let found = needed(|| {
            let (x, y) = (ray(2.0), triangle(0, 3.0));
            let (product, again) = (x * y, y * x);
            let _unused = x / y;
            vec![(product + again).place()]
        });
        let each = vec![Noted::Add, Noted::Multiply];
        assert_eq!(sorted(found), Needed { each, once: vec![Noted::OfTriangle(0)] });
    }

    #[test]
    fn each_operation_is_with_what_it_depends_on() {
        let found = needed(|| {
            let (x, y, z) = (ray(2.0), triangle(0, 3.0), triangle(1, 4.0));
            let (of_ray, of_triangle) = (x * x, y - z);
            vec![of_ray.mul_add(of_triangle, x).place()]
        });
        let once = vec![Noted::Add, Noted::OfTriangle(0), Noted::OfTriangle(1)];
        assert_eq!(sorted(found), Needed { each: vec![Noted::Fused], once });
    }

    #[test]
    fn constants_are_folded_where_no_bit_can_change() {
        let found = needed(|| {
            let x = ray(2.0) * triangle(0, 3.0);
            let scaled = (x * x.one() / x.one() - x.zero()).mul_add(x.one(), x);
            let is_true = x.one().ge(x.zero()) & x.ge(x.zero());
            vec![scaled.place(), One::select(is_true, x, x.zero()).place()]
        });
        let each = vec![Noted::Add, Noted::Compare(3), Noted::Multiply, Noted::Select];
        assert_eq!(sorted(found).each, each);
        // x + 0 turns -0 into 0.
        let kept = needed(|| vec![(triangle(0, 1.0) + One::splat((), TracedOne::ZERO)).place()]);
        assert_eq!(sorted(kept).once, [Noted::Add, Noted::OfTriangle(0)]);
    }

    #[test]
    fn values_are_those_of_the_numbers() {
        let (x, y) = (ray(2.0), triangle(0, -3.0));
        assert_eq!((x - y).0.value(), 5.0);
        assert_eq!((x / y).0.value(), -2.0 / 3.0);
        assert_eq!(x.signed_by(y).0.value(), -2.0);
        assert_eq!(x.mul_add(y, y).0.value(), -9.0);
        assert_eq!(One::select(x.lt(y), x, y).0.value(), -3.0);
        assert!((x.gt(y) & !x.le(y)).any() && !(y.sign_bit() & x.sign_bit()).any());
        assert!((x.sign_bit() | y.sign_bit()).lane(0));
    }
}

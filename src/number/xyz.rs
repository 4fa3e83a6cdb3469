//! A vector in a register: x, y and z of one point or direction beside each other, inside one test
//! (thesis H, 4.2).
//!
//! A number is a register of which the first lane counts; nobody looks at what the others hold. Sums of
//! products are made by [`Summing`]; all operations round as those of a scalar do, in the same order.

use std::marker::PhantomData;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use fearless_simd::{Simd, SimdBase, f32x4};

use super::lanes::{LaneMask, Lanes};
use super::shuffled::{Dotted, Shuffled};
use super::{Mask, Real};

/// A register of level `S`: a number, or a whole vector. A [`super::Vec3`] of them is one such vector,
/// three times the same register.
#[derive(Clone, Copy)]
pub struct Xyz<S: Simd, D>(Register<S>, PhantomData<D>);

/// The answer for a number: that of the first lane.
#[derive(Clone, Copy)]
pub struct FirstLane<S: Simd>(RegisterMask<S>);

type Register<S> = Lanes<S, f32x4<S>>;
type RegisterMask<S> = LaneMask<S, <f32x4<S> as SimdBase<S>>::Mask>;

/// The column `dot`: how the three products of a dot product are summed.
pub trait Summing<S: Simd>: Copy + 'static {
    /// The column's word.
    const NAME: &'static str;
    /// z z' + (y y' + x x') in the first lane.
    fn dot(a: f32x4<S>, b: f32x4<S>) -> f32x4<S>;
}

/// Lanes are brought below each other and added: two shuffles, two additions.
#[derive(Clone, Copy)]
pub struct Horizontal;
/// One instruction (DPPS, from SSE4.1 on). Its last sum is that of z and +0, so where all products are
/// -0 it gives +0.
#[derive(Clone, Copy)]
pub struct Instruction;

impl<S: Shuffled> Summing<S> for Horizontal {
    const NAME: &'static str = "horizontal";
    #[inline(always)]
    fn dot(a: f32x4<S>, b: f32x4<S>) -> f32x4<S> {
        let products = a * b;
        S::third(products) + (S::second(products) + products)
    }
}

impl<S: Dotted> Summing<S> for Instruction {
    const NAME: &'static str = "instruction";
    #[inline(always)]
    fn dot(a: f32x4<S>, b: f32x4<S>) -> f32x4<S> {
        S::dot(a, b)
    }
}

impl<S: Shuffled> Mask for FirstLane<S> {
    const LANES: usize = 1;
    #[inline(always)]
    fn any(self) -> bool {
        self.0.lane(0)
    }
    #[inline(always)]
    fn lane(self, _: usize) -> bool {
        self.0.lane(0)
    }
}

macro_rules! masks {
    ($($trait:ident $method:ident;)*) => {$(
        impl<S: Shuffled> $trait for FirstLane<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                FirstLane(self.0.$method(other.0))
            }
        }
    )*};
}

masks! {
    BitAnd bitand;
    BitOr bitor;
}

impl<S: Shuffled> Not for FirstLane<S> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        FirstLane(!self.0)
    }
}

macro_rules! binary {
    ($($trait:ident $method:ident;)*) => {$(
        impl<S: Shuffled, D: Summing<S>> $trait for Xyz<S, D> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Xyz(self.0.$method(other.0), PhantomData)
            }
        }
    )*};
}

binary! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}

impl<S: Shuffled, D: Summing<S>> Neg for Xyz<S, D> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Xyz(-self.0, PhantomData)
    }
}

macro_rules! comparisons {
    ($($method:ident)*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> FirstLane<S> {
            FirstLane(self.0.$method(other.0))
        }
    )*};
}

impl<S: Shuffled, D: Summing<S>> Real for Xyz<S, D> {
    type Mask = FirstLane<S>;
    type Element = f32;
    type Token = S;
    const LANES: usize = 1;

    #[inline(always)]
    fn token(self) -> S {
        self.0.token()
    }
    #[inline(always)]
    fn splat(token: S, element: f32) -> Self {
        Xyz(Lanes::splat(token, element), PhantomData)
    }
    #[inline(always)]
    fn load(token: S, elements: &[f32]) -> Self {
        Self::splat(token, elements[0])
    }
    #[inline(always)]
    fn store(self, elements: &mut [f32]) {
        elements[0] = self.0.register()[0];
    }
    #[inline(always)]
    fn mask(token: S, truth: bool) -> FirstLane<S> {
        FirstLane(Register::mask(token, truth))
    }
    comparisons!(lt le gt ge ne);
    #[inline(always)]
    fn select(mask: FirstLane<S>, yes: Self, no: Self) -> Self {
        Xyz(Lanes::select(mask.0, yes.0, no.0), PhantomData)
    }
    #[inline(always)]
    fn signed_by(self, sign: Self) -> Self {
        Xyz(self.0.signed_by(sign.0), PhantomData)
    }
    #[inline(always)]
    fn sign_bit(self) -> FirstLane<S> {
        FirstLane(self.0.sign_bit())
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Xyz(self.0.mul_add(factor.0, addend.0), PhantomData)
    }
    #[inline(always)]
    fn vector(token: S, numbers: &[f32], from: usize) -> Self {
        let four = Register::load(token, numbers);
        if from == 0 {
            Xyz(four, PhantomData)
        } else {
            Xyz(Lanes::of(S::behind_first(four.register())), PhantomData)
        }
    }
    #[inline(always)]
    fn vector_dot(self, other: Self) -> Self {
        Xyz(Lanes::of(D::dot(self.0.register(), other.0.register())), PhantomData)
    }
    /// a x b = (a (y, z, x of b) - (y, z, x of a) b), its lanes turned: each a difference of the two
    /// products that a scalar subtracts, in their order.
    #[inline(always)]
    fn vector_cross(self, other: Self) -> Self {
        let (a, b) = (self.0.register(), other.0.register());
        let sideways = a * S::turned(b) - S::turned(a) * b;
        Xyz(Lanes::of(S::turned(sideways)), PhantomData)
    }
}

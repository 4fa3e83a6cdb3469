//! A single ray against all triangles, each vector of both in a register (thesis H, 4.2).

use std::hint::black_box;
use std::marker::PhantomData;

use super::best::{ANSWER_NUMBERS, Best};
use super::nearest::{RAY_NUMBERS, Scene, places, step};
use crate::kernels::{Kernel, Source};
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Policy, Ray};

/// One loop over rays and all triangles, in [`super::Aos`] with one number more behind the last.
pub struct InRegisters<K, P, R>(PhantomData<(K, P, R)>);

/// Numbers of which four are read where three are meant: the fourth is of the next vector, of the next
/// triangle, or the one behind the last.
struct Fours<'a, R: Real> {
    token: R::Token,
    numbers: &'a [R::Element],
}

impl<R: Real> Source<R> for Fours<'_, R> {
    #[inline(always)]
    fn number(&self, place: usize) -> R {
        R::splat(self.token, self.numbers[place])
    }
    #[inline(always)]
    fn vector(&self, place: usize) -> Vec3<R> {
        match R::whole_vector(self.token, &self.numbers[place..][..4]) {
            Some(vector) => Vec3([vector; 3]),
            None => Vec3([self.number(place), self.number(place + 1), self.number(place + 2)]),
        }
    }
}

impl<L, K, P, R> Batch<L> for InRegisters<K, P, R>
where
    L: Level,
    K: Kernel,
    P: Policy,
    R: Real + On<L>,
{
    type Data<'a> = Scene<'a, R::Element>;
    type Yield = ();

    #[inline(always)]
    fn run(token: L::Token, scene: Self::Data<'_>) {
        let token = R::token_on(token);
        let rays = scene.rays.chunks_exact(RAY_NUMBERS);
        for (numbers, answer) in rays.zip(scene.answers.chunks_exact_mut(ANSWER_NUMBERS)) {
            let mut ray = load(&Fours::<R> { token, numbers });
            let best = walk::<K, P, R>(token, &mut ray, scene.numbers);
            best.write::<P>(&ray, answer);
        }
    }
}

/// A ray: the numbers behind its last vector are the bounds of t.
#[inline(always)]
fn load<R: Real>(numbers: &Fours<'_, R>) -> Ray<R> {
    Ray {
        origin: numbers.vector(0),
        direction: numbers.vector(3),
        end: numbers.vector(6),
        t_min: numbers.number(9),
        t_max: numbers.number(10),
    }
}

/// All triangles, until less than one and the number behind it is left.
#[inline(always)]
fn walk<K: Kernel, P: Policy, R: Real>(
    token: R::Token,
    ray: &mut Ray<R>,
    mut rest: &[R::Element],
) -> Best<R> {
    let mut best = Best::nothing(token, ray);
    let aim = K::aim::<P, R>(ray);
    let one = R::splat(token, R::Element::ONE);
    let mut index = R::splat(token, R::Element::ZERO);
    let places = places::<K, R::Element>();
    while let Some(numbers) = rest.get(..=places) {
        // As of every single ray: nothing of the next test before this one.
        black_box(());
        let met = K::read::<P, R, _>(&Fours::<R> { token, numbers });
        step::<K, P, R>(ray, &aim, &met, index, &mut best);
        index = index + one;
        rest = &rest[places..];
    }
    best
}

//! A single ray against triangles, each vector of both in a register (thesis H, 4.2).

use std::hint::black_box;
use std::marker::PhantomData;

use super::Sums;
use super::best::{ANSWER_NUMBERS, Best, lanes_of};
use super::layout::{Aos, Layout};
use super::nearest::{RAY_NUMBERS, Scene, load as load_ray, places, step};
use super::pairs::Walk;
use super::report;
use crate::job::Tally;
use crate::kernels::{Kernel, Source};
use crate::level::{Batch, Level, On};
use crate::number::{Element, Mask, Real, Vec3};
use crate::policy::{self, Found, Output, Policy, Ray};

/// One loop over rays and all triangles; `R` is a number that can be a vector.
pub struct InRegisters<K, P, R>(PhantomData<(K, P, R)>);

/// One loop over pairs, of which rays are [`RAY_NUMBERS`] numbers in a row; no form of it reports the
/// surface.
pub struct PairsInRegisters<K, P, R>(PhantomData<(K, P, R)>);

/// The policy that the tests see.
type Of<P> = policy::InRegisters<P>;

/// Numbers of which four are read where three are meant: of the last three, the one before them as well.
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
        let from = usize::from(place + 4 > self.numbers.len());
        Vec3([R::vector(self.token, &self.numbers[place - from..][..4], from); 3])
    }
}

impl<R: Real> Fours<'_, R> {
    /// A ray, of which the numbers are these.
    #[inline(always)]
    fn ray(&self) -> Ray<R> {
        Ray {
            origin: self.vector(0),
            direction: self.vector(3),
            end: self.vector(6),
            t_min: self.number(9),
            t_max: self.number(10),
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
            let mut ray = Fours::<R> { token, numbers }.ray();
            let mut best = Best::nothing(token, &ray);
            let aim = K::aim::<Of<P>, R>(&ray);
            let mut index = R::splat(token, R::Element::ZERO);
            for triangle in Aos::walk(scene.numbers, places::<K, R::Element>(), scene.triangles) {
                // As of every single ray: nothing of the next test before this one.
                black_box(());
                let met = K::read::<Of<P>, R, _>(&Fours::<R> { token, numbers: triangle.0 });
                step::<K, Of<P>, R>(&mut ray, &aim, &met, index, &mut best);
                index = index.successor();
            }
            best.write::<P>(&ray, answer);
        }
    }
}

impl<L, K, P, R> Batch<L> for PairsInRegisters<K, P, R>
where
    L: Level,
    K: Kernel,
    P: Policy,
    R: Real + On<L>,
{
    type Data<'a> = Walk<'a, ([R::Element; RAY_NUMBERS], K::Record<R::Element>)>;
    type Yield = Tally;

    #[inline(always)]
    fn run(token: L::Token, walk: Self::Data<'_>) -> Tally {
        const { assert!(!P::Output::SURFACE) };
        let token = R::token_on(token);
        let mut sums = Sums::default();
        for _ in 0..walk.times {
            for (numbers, record) in walk.pairs {
                black_box(());
                let ray = Fours::<R> { token, numbers }.ray();
                let met = K::read::<Of<P>, R, _>(&Fours::<R> { token, numbers: record.as_ref() });
                if let Ok(found) = K::test::<Of<P>, R>(&ray, &K::aim::<Of<P>, R>(&ray), &met) {
                    let ray = load_ray::<R::Element>((), numbers);
                    let none = Vec3([R::Element::ZERO; 3]);
                    report::<P, R::Element>(&mut sums, &ray, &first(&found), none);
                }
            }
        }
        Tally { hits: sums.hits, bits: sums.bits }
    }
}

/// What the first lane found.
#[inline(always)]
fn first<R: Real>(found: &Found<R>) -> Found<R::Element> {
    let [t, u, v] = [lanes_of(found.t)[0], lanes_of(found.u)[0], lanes_of(found.v)[0]];
    Found { hit: found.hit.lane(0), t, u, v }
}

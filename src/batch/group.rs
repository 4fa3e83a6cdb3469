//! One ray against several triangles at a time, one to a lane; the nearest of all lanes is picked
//! when all groups are done.

use std::marker::PhantomData;

use super::WIDEST;
use super::best::{ANSWER_NUMBERS, Best, lanes_of};
use super::nearest::{RAY_NUMBERS, Scene, align_frame, load, places};
use crate::kernels::{Kernel, Source};
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Exit, Output, Policy, Ray};

/// One loop over rays and groups of triangles. Their layout is [`super::Aosoa`] of as many as there
/// are lanes; a last group that is not full is filled up with triangles that nothing hits.
pub struct Group<K, P, R>(PhantomData<(K, P, R)>);

/// A group's numbers: as many of each in a row as there are lanes.
pub struct Packed<'a, R: Real> {
    /// Of the lanes.
    pub token: R::Token,
    /// Place by place.
    pub numbers: &'a [R::Element],
}

impl<R: Real> Source<R> for Packed<'_, R> {
    #[inline(always)]
    fn number(&self, place: usize) -> R {
        R::load(self.token, &self.numbers[place * R::LANES..][..R::LANES])
    }
}

impl<L, K, P, R> Batch<L> for Group<K, P, R>
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
        align_frame::<R>();
        let rays = scene.rays.chunks_exact(RAY_NUMBERS);
        for (ray, answer) in rays.zip(scene.answers.chunks_exact_mut(ANSWER_NUMBERS)) {
            let mut ray = everywhere::<R>(token, &load::<R::Element>((), ray));
            let best = walk::<K, P, R>(token, &mut ray, scene.numbers);
            pick::<P, R>(&best, &ray, answer);
        }
    }
}

/// One ray in every lane.
#[inline(always)]
pub fn everywhere<R: Real>(token: R::Token, ray: &Ray<R::Element>) -> Ray<R> {
    Ray {
        origin: Vec3::splat(token, ray.origin),
        direction: Vec3::splat(token, ray.direction),
        end: Vec3::splat(token, ray.end),
        t_min: R::splat(token, ray.t_min),
        t_max: R::splat(token, ray.t_max),
    }
}

/// All groups. Where tests end early, a hit bounds the search in every lane.
#[inline(always)]
fn walk<K: Kernel, P: Policy, R: Real>(
    token: R::Token,
    ray: &mut Ray<R>,
    numbers: &[R::Element],
) -> Best<R> {
    let mut best = Best::nothing(token, ray);
    let aim = K::aim::<P, R>(ray);
    let step = R::splat(token, R::Element::from_f32(R::LANES as f32));
    let mut index = counted::<R>(token);
    for numbers in numbers.chunks_exact(places::<K, R::Element>() * R::LANES) {
        let met = K::read::<P, R, _>(&Packed { token, numbers });
        if let Ok(found) = K::test::<P, R>(ray, &aim, &met) {
            best.update::<P>(ray, &found, index, K::normal::<P, R>(&met));
            if !P::Exit::DEFERS_RANGE && P::Output::T {
                ray.t_max = R::splat(token, best.nearest_t());
            }
        }
        index = index + step;
    }
    best
}

/// 0, 1, 2, ... in the lanes.
#[inline(always)]
fn counted<R: Real>(token: R::Token) -> R {
    let mut lanes = [R::Element::ZERO; WIDEST];
    for lane in 1..R::LANES {
        lanes[lane] = lanes[lane - 1] + R::Element::ONE;
    }
    R::load(token, &lanes)
}

/// Stores the answer of the lane that is nearest; of several at one distance, that of the triangle that
/// comes first.
#[inline(always)]
fn pick<P: Policy, R: Real>(best: &Best<R>, ray: &Ray<R>, answer: &mut [R::Element]) {
    let rows = best.rows::<P>(ray);
    let (triangles, distances) = (lanes_of(rows[0]), lanes_of(rows[1]));
    // A lane is below WIDEST; the remainder tells the optimiser so.
    let mut nearest = 0;
    for lane in 1..R::LANES {
        let one = (triangles[lane], distances[lane]);
        if precedes(one, (triangles[nearest % WIDEST], distances[nearest % WIDEST])) {
            nearest = lane;
        }
    }
    for (row, place) in rows.into_iter().zip(answer) {
        *place = lanes_of(row)[nearest % WIDEST];
    }
}

/// Whether what one lane hit, triangle and distance, comes before what the other hit, if anything.
#[inline(always)]
fn precedes<E: Element>((triangle, t): (E, E), (rival, rival_t): (E, E)) -> bool {
    let hits = triangle.ge(E::ZERO);
    hits && (rival.lt(E::ZERO) || t.lt(rival_t) || (t.le(rival_t) && triangle.lt(rival)))
}

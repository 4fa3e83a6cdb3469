//! Packets of rays that have their origin or their direction in common: what depends on it alone is
//! done once per triangle and packet, for as many triangles at a time as there are lanes.

use std::marker::PhantomData;

use super::WIDEST;
use super::best::{ANSWER_NUMBERS, Best};
use super::group::{Packed, everywhere};
use super::nearest::{RAY_NUMBERS, Scene, align_frame, load, places};
use crate::kernels::{Common, MOST_SHARED, Shares, Source};
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Exit, Miss, Policy, Ray};

/// One loop over packets of rays `R` and groups of triangles, one to a lane of `G`, whose layout is
/// that of [`super::Group`]. Rays of a packet must have in common what `C` says.
pub struct Sharing<K, P, R, G, C>(PhantomData<(K, P, R, G, C)>);

impl<L, K, P, R, G, C> Batch<L> for Sharing<K, P, R, G, C>
where
    L: Level,
    K: Shares<C>,
    P: Policy,
    R: Real + On<L>,
    G: Real<Element = R::Element, Token = R::Token>,
    C: Common,
{
    type Data<'a> = Scene<'a, R::Element>;
    type Yield = ();

    #[inline(always)]
    fn run(token: L::Token, scene: Self::Data<'_>) {
        let token = R::token_on(token);
        align_frame::<R>();
        let mut kept = Kept([R::Element::ZERO; MOST_SHARED * WIDEST]);
        let packets = scene.rays.chunks_exact(RAY_NUMBERS * R::LANES);
        let answers = scene.answers.chunks_exact_mut(ANSWER_NUMBERS * R::LANES);
        for (packet, answer) in packets.zip(answers) {
            let mut ray = load::<R>(token, packet);
            let first = everywhere::<G>(token, &first(packet));
            let best = walk::<K, P, R, G, C>(token, &mut ray, &first, scene.numbers, &mut kept);
            best.write::<P>(&ray, answer);
        }
    }
}

/// The first ray of a packet.
#[inline(always)]
fn first<E: Element>(packet: &[E]) -> Ray<E> {
    let step = packet.len() / RAY_NUMBERS;
    let mut numbers = [E::ZERO; RAY_NUMBERS];
    for (row, number) in numbers.iter_mut().enumerate() {
        *number = packet[row * step];
    }
    load::<E>((), &numbers)
}

/// What is shared of a group of triangles: as many of each number in a row as a group has lanes.
#[repr(align(64))]
struct Kept<E>([E; MOST_SHARED * WIDEST]);

/// What is shared of one triangle, in every lane.
struct OfOne<'a, R: Real> {
    token: R::Token,
    numbers: &'a [R::Element; MOST_SHARED * WIDEST],
    lane: usize,
    lanes: usize,
}

impl<R: Real> Source<R> for OfOne<'_, R> {
    #[inline(always)]
    fn number(&self, place: usize) -> R {
        R::splat(self.token, self.numbers[place * self.lanes + self.lane])
    }
}

/// All triangles. `ray.t_max` shrinks.
#[inline(always)]
fn walk<K, P, R, G, C>(
    token: R::Token,
    ray: &mut Ray<R>,
    first: &Ray<G>,
    numbers: &[R::Element],
    kept: &mut Kept<R::Element>,
) -> Best<R>
where
    K: Shares<C>,
    P: Policy,
    R: Real,
    G: Real<Element = R::Element, Token = R::Token>,
    C: Common,
{
    let mut best = Best::nothing(token, ray);
    let aim = K::aim::<P, R>(ray);
    let mut index = R::splat(token, R::Element::ZERO);
    for numbers in numbers.chunks_exact(places::<K, R::Element>() * G::LANES) {
        let met = K::read::<P, G, _>(&Packed { token, numbers });
        let shared = K::share::<P, G>(first, &met);
        for (row, place) in shared.as_ref().iter().zip(kept.0.chunks_exact_mut(G::LANES)) {
            row.store(place);
        }
        let of = |lane| OfOne::<R> { token, numbers: &kept.0, lane, lanes: G::LANES };
        if !P::Exit::DEFERS_RANGE {
            for lane in 0..G::LANES {
                step_shared::<K, P, R, C, _>(ray, &aim, &of(lane), index, &mut best);
                index = index.successor();
            }
            continue;
        }
        // The first part of a test is done before the second part of the one before it.
        let mut begun = K::begin_shared::<P, R, _>(ray, &aim, &of(0));
        for lane in 1..G::LANES {
            let next = K::begin_shared::<P, R, _>(ray, &aim, &of(lane));
            end::<K, P, R, C, _>(ray, &aim, (&of(lane - 1), begun), index, &mut best);
            begun = next;
            index = index.successor();
        }
        end::<K, P, R, C, _>(ray, &aim, (&of(G::LANES - 1), begun), index, &mut best);
        index = index.successor();
    }
    best
}

/// One triangle: the rest of the test, and its hit kept where it is the nearest. No form with a common
/// part reports surfaces.
#[inline(always)]
pub fn step_shared<K, P, R, C, S>(
    ray: &mut Ray<R>,
    aim: &K::Aim<R>,
    shared: &S,
    index: R,
    best: &mut Best<R>,
) where
    K: Shares<C>,
    P: Policy,
    R: Real,
    C: Common,
    S: Source<R>,
{
    let begun = K::begin_shared::<P, R, S>(ray, aim, shared);
    end::<K, P, R, C, S>(ray, aim, (shared, begun), index, best);
}

/// The second part of [`step_shared`].
#[inline(always)]
fn end<K, P, R, C, S>(
    ray: &mut Ray<R>,
    aim: &K::Aim<R>,
    (shared, begun): (&S, Result<<K as Shares<C>>::Begun<R>, Miss>),
    index: R,
    best: &mut Best<R>,
) where
    K: Shares<C>,
    P: Policy,
    R: Real,
    C: Common,
    S: Source<R>,
{
    if let Ok(begun) = begun
        && let Ok(found) = K::end_shared::<P, R, S>(ray, aim, shared, &begun)
    {
        best.update::<P>(ray, &found, index, Vec3([index.zero(); 3]));
    }
}

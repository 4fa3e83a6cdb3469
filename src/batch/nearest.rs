//! Every ray against every triangle; the nearest hit is kept and its distance bounds the rest.

use std::hint::black_box;
use std::marker::PhantomData;

use super::best::{ANSWER_NUMBERS, Best};
use super::layout::{Aos, Layout};
use crate::kernels::Kernel;
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real, Spread, Vec3};
use crate::policy::{Exit, Miss, Policy, Ray};

/// The widest register that there is, in numbers.
pub const WIDEST: usize = 16;

/// Numbers of a ray: origin, direction, end, t_min, t_max.
pub const RAY_NUMBERS: usize = 11;

/// One loop over packets of rays and all triangles, stored in layout `Y`.
pub struct Nearest<K, P, R, Y = Aos>(PhantomData<(K, P, R, Y)>);

/// What the loop reads and writes.
pub struct Scene<'a, E> {
    /// Packets of rays, [`RAY_NUMBERS`] rows of [`Real::LANES`] numbers each.
    pub rays: &'a [E],
    /// Every triangle's numbers, in the order of a layout.
    pub numbers: &'a [E],
    /// Triangles. Fewer than 2^24, so that an index is a number of either precision.
    pub triangles: usize,
    /// Answers of the packets, [`ANSWER_NUMBERS`] rows of [`Real::LANES`] numbers each.
    pub answers: &'a mut [E],
}

/// A local variable that has to lie at a multiple of 64 makes the compiler align the whole frame.
/// Without it, spilled registers of 32 bytes lie at multiples of 16, and one that is written in every
/// test can straddle two pages: measured, the loop then takes 2.5 to 3 times as long, at one in 64
/// places where the caller's stack may end.
#[repr(align(64))]
#[expect(dead_code, reason = "only its place matters")]
struct Anchor(u8);

/// Has the frame aligned that it is inlined into. See `Anchor`.
#[inline(always)]
pub fn align_frame<R: Real>() {
    if size_of::<R>() > 16 {
        let anchor = Anchor(0);
        black_box(&anchor);
    }
}

/// Numbers of a kernel's record.
pub const fn places<K: Kernel, E: Element>() -> usize {
    size_of::<K::Record<E>>() / size_of::<E>()
}

impl<L, K, P, R, Y> Batch<L> for Nearest<K, P, R, Y>
where
    L: Level,
    K: Kernel,
    P: Policy,
    R: Real + On<L>,
    Y: Layout,
{
    type Data<'a> = Scene<'a, R::Element>;
    type Yield = ();

    #[inline(always)]
    fn run(token: L::Token, scene: Self::Data<'_>) {
        let token = R::token_on(token);
        align_frame::<R>();
        let Scene { rays, numbers, triangles, answers } = scene;
        let packets = rays.chunks_exact(RAY_NUMBERS * R::LANES);
        let answers = answers.chunks_exact_mut(ANSWER_NUMBERS * R::LANES);
        for (packet, answer) in packets.zip(answers) {
            let mut ray = load::<R>(token, packet);
            let triangles = Y::walk(numbers, places::<K, R::Element>(), triangles);
            let best = walk::<K, P, R, Y>(token, &mut ray, triangles);
            best.write::<P>(&ray, answer);
        }
    }
}

/// A packet of rays. Row by row: an array of them would be cleared first, by a call where it is large.
#[inline(always)]
pub fn load<R: Real>(token: R::Token, packet: &[R::Element]) -> Ray<R> {
    Ray {
        origin: vector::<R>(token, packet, 0),
        direction: vector::<R>(token, packet, 3),
        end: vector::<R>(token, packet, 6),
        t_min: row::<R>(token, packet, 9),
        t_max: row::<R>(token, packet, 10),
    }
}

/// One number of every ray of a packet.
#[inline(always)]
fn row<R: Real>(token: R::Token, packet: &[R::Element], row: usize) -> R {
    R::load(token, &packet[row * R::LANES..][..R::LANES])
}

/// Three rows.
#[inline(always)]
fn vector<R: Real>(token: R::Token, packet: &[R::Element], first: usize) -> Vec3<R> {
    Vec3([
        row::<R>(token, packet, first),
        row::<R>(token, packet, first + 1),
        row::<R>(token, packet, first + 2),
    ])
}

/// All triangles. `ray.t_max` shrinks, except where only the hit itself is wanted.
#[inline(always)]
fn walk<K: Kernel, P: Policy, R: Real, Y: Layout>(
    token: R::Token,
    ray: &mut Ray<R>,
    mut triangles: Y::Walk<'_, R::Element>,
) -> Best<R> {
    let mut best = Best::nothing(token, ray);
    let aim = K::aim::<P, R>(ray);
    let mut index = R::splat(token, R::Element::ZERO);
    if R::LANES > 1 && P::Exit::DEFERS_RANGE {
        // The first part of a test is done before the second part of the one before it.
        let Some(mut triangle) = triangles.next() else { return best };
        let mut met = Spread::spread(token, K::read::<P, R::Element, _>(&triangle));
        let mut begun = K::begin::<P, R>(ray, &aim, &met);
        for next in triangles {
            let following = Spread::spread(token, K::read::<P, R::Element, _>(&next));
            let following_begun = K::begin::<P, R>(ray, &aim, &following);
            met = Spread::spread(token, K::read::<P, R::Element, _>(&triangle));
            end::<K, P, R>(ray, &aim, (&met, begun), index, &mut best);
            (triangle, begun) = (next, following_begun);
            index = index.successor();
        }
        met = Spread::spread(token, K::read::<P, R::Element, _>(&triangle));
        end::<K, P, R>(ray, &aim, (&met, begun), index, &mut best);
        return best;
    }
    for triangle in triangles {
        if R::LANES == 1 {
            // A single ray must not be tested against several triangles at once.
            black_box(());
        }
        let met = Spread::spread(token, K::read::<P, R::Element, _>(&triangle));
        step::<K, P, R>(ray, &aim, &met, index, &mut best);
        index = index.successor();
    }
    best
}

/// One triangle: the test, and its hit kept where it is the nearest.
#[inline(always)]
pub fn step<K: Kernel, P: Policy, R: Real>(
    ray: &mut Ray<R>,
    aim: &K::Aim<R>,
    met: &K::Met<R>,
    index: R,
    best: &mut Best<R>,
) {
    let begun = K::begin::<P, R>(ray, aim, met);
    end::<K, P, R>(ray, aim, (met, begun), index, best);
}

/// What [`Kernel::begin`] gives.
type Beginning<K, R> = Result<<K as Kernel>::Begun<R>, Miss>;

/// The second part of [`step`].
#[inline(always)]
fn end<K: Kernel, P: Policy, R: Real>(
    ray: &mut Ray<R>,
    aim: &K::Aim<R>,
    (met, begun): (&K::Met<R>, Beginning<K, R>),
    index: R,
    best: &mut Best<R>,
) {
    if let Ok(begun) = begun
        && let Ok(found) = K::end::<P, R>(ray, aim, met, &begun)
    {
        best.update::<P>(ray, &found, index, K::normal::<P, R>(met));
    }
}

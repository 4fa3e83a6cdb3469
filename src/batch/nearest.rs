//! Every ray against every triangle; the nearest hit is kept and its distance bounds the rest.

use std::hint::black_box;
use std::marker::PhantomData;

use super::{Sums, surface_point};
use crate::job::Tally;
use crate::kernels::Kernel;
use crate::level::{Batch, Level, On};
use crate::number::{Element, Mask, Real, Vec3};
use crate::policy::{Output, Policy, Ray};

/// The widest packet that there is, in rays.
pub const WIDEST: usize = 16;

/// Numbers of a ray: origin, direction, end, t_min, t_max.
pub const RAY_NUMBERS: usize = 11;

/// Numbers of an answer: triangle (as a number; -1 without a hit), t, u, v, point, normal.
pub const ANSWER_NUMBERS: usize = 10;

/// One loop over packets of rays and all triangles.
pub struct Nearest<K, P, R>(PhantomData<(K, P, R)>);

/// What the loop reads and writes.
pub struct Scene<'a, E, T> {
    /// Packets of rays, [`RAY_NUMBERS`] rows of [`Real::LANES`] numbers each.
    pub rays: &'a [E],
    /// Every triangle's record. Fewer than 2^24, so that an index is a number of either precision.
    pub records: &'a [T],
    /// Answers of the packets, [`ANSWER_NUMBERS`] rows of [`Real::LANES`] numbers each.
    pub answers: &'a mut [E],
}

/// What is known of a packet so far.
#[derive(Clone, Copy)]
struct Best<R: Real> {
    hit: R::Mask,
    triangle: R,
    t: R,
    u: R,
    v: R,
    normal: Vec3<R>,
}

impl<L, K, P, R> Batch<L> for Nearest<K, P, R>
where
    L: Level,
    K: Kernel,
    P: Policy,
    R: Real + On<L>,
{
    type Data<'a> = Scene<'a, R::Element, K::Record<R::Element>>;
    type Yield = Tally;

    #[inline(always)]
    fn run(token: L::Token, scene: Self::Data<'_>) -> Tally {
        let token = R::token_on(token);
        let mut sums = Sums::default();
        let packets = scene.rays.chunks_exact(RAY_NUMBERS * R::LANES);
        let answers = scene.answers.chunks_exact_mut(ANSWER_NUMBERS * R::LANES);
        for (packet, answer) in packets.zip(answers) {
            let mut ray = load::<R>(token, packet);
            let best = walk::<K, P, R>(token, &mut ray, scene.records);
            write::<P, R>(&ray, &best, answer, &mut sums);
        }
        Tally { hits: sums.hits, bits: sums.bits }
    }
}

#[inline(always)]
fn load<R: Real>(token: R::Token, packet: &[R::Element]) -> Ray<R> {
    let mut rows = [R::splat(token, R::Element::ZERO); RAY_NUMBERS];
    for (row, numbers) in rows.iter_mut().zip(packet.chunks_exact(R::LANES)) {
        *row = R::load(token, numbers);
    }
    let [ox, oy, oz, dx, dy, dz, ex, ey, ez, t_min, t_max] = rows;
    Ray {
        origin: Vec3([ox, oy, oz]),
        direction: Vec3([dx, dy, dz]),
        end: Vec3([ex, ey, ez]),
        t_min,
        t_max,
    }
}

/// All triangles. `ray.t_max` shrinks, except where only the hit itself is wanted.
#[inline(always)]
fn walk<K: Kernel, P: Policy, R: Real>(
    token: R::Token,
    ray: &mut Ray<R>,
    records: &[K::Record<R::Element>],
) -> Best<R> {
    let nothing = R::splat(token, R::Element::ZERO);
    let mut best = Best {
        hit: R::mask(token, false),
        triangle: -R::splat(token, R::Element::ONE),
        t: ray.t_max,
        u: nothing,
        v: nothing,
        normal: Vec3([nothing; 3]),
    };
    let mut index = R::Element::ZERO;
    for record in records {
        if R::LANES == 1 {
            // A single ray must not be tested against several triangles at once.
            black_box(());
        }
        let met = K::meet::<P, R>(token, record);
        if let Ok(found) = K::test::<P, R>(ray, &met) {
            let nearer = if P::Output::T { found.hit & found.t.lt(best.t) } else { found.hit };
            best.hit = best.hit | nearer;
            if P::Output::T {
                best.t = R::select(nearer, found.t, best.t);
                best.triangle = R::select(nearer, R::splat(token, index), best.triangle);
                ray.t_max = best.t;
            }
            if P::Output::UV {
                best.u = R::select(nearer, found.u, best.u);
                best.v = R::select(nearer, found.v, best.v);
            }
            if P::Output::SURFACE {
                let normal = K::normal::<P, R>(&met);
                for (old, new) in best.normal.0.iter_mut().zip(normal.0) {
                    *old = R::select(nearer, new, *old);
                }
            }
        }
        index = index + R::Element::ONE;
    }
    best
}

/// Stores a packet's answer and adds it to the sums.
#[inline(always)]
fn write<P: Policy, R: Real>(
    ray: &Ray<R>,
    best: &Best<R>,
    answer: &mut [R::Element],
    sums: &mut Sums,
) {
    let point = if P::Output::SURFACE {
        surface_point(ray.origin, ray.direction, best.t)
    } else {
        best.normal
    };
    let [x, y, z] = point.0;
    let [nx, ny, nz] = best.normal.0;
    // Where only the hit is wanted no triangle was noted; 0 stands for "one of them".
    let none = best.triangle;
    let triangle = if P::Output::T { none } else { R::select(best.hit, none.zero(), none) };
    let rows = [triangle, best.t, best.u, best.v, x, y, z, nx, ny, nz];
    for (row, place) in rows.into_iter().zip(answer.chunks_exact_mut(R::LANES)) {
        row.store(place);
    }
    for lane in 0..R::LANES {
        let hit = best.hit.lane(lane);
        let at = |row: usize| answer[row * R::LANES + lane];
        if P::Output::SURFACE {
            sums.add(hit, &[at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9)]);
        } else if P::Output::UV {
            sums.add(hit, &[at(1), at(2), at(3)]);
        } else if P::Output::T {
            sums.add(hit, &[at(1)]);
        } else {
            sums.add::<R::Element>(hit, &[]);
        }
    }
}

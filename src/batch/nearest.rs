//! Every ray against every triangle; the nearest hit is kept and its distance bounds the rest.

use std::hint::black_box;
use std::marker::PhantomData;

use super::surface_point;
use crate::kernels::Kernel;
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Exit, Found, Output, Policy, Ray};

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

/// A local variable that has to lie at a multiple of 64 makes the compiler align the whole frame.
/// Without it, spilled registers of 32 bytes lie at multiples of 16, and one that is written in every
/// test can straddle two pages: measured, the loop then takes 2.5 to 3 times as long, at one in 64
/// places where the caller's stack may end.
#[repr(align(64))]
#[expect(dead_code, reason = "only its place matters")]
struct Anchor(u8);

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

impl<R: Real> Best<R> {
    /// Takes over a hit where it is nearer. With `t` wanted, the triangle says whether there is a
    /// hit; without, the mask does: either way it is one register less in the loop.
    #[inline(always)]
    fn update<P: Policy>(&mut self, ray: &mut Ray<R>, found: &Found<R>, index: R, normal: Vec3<R>) {
        if !P::Output::T {
            self.hit = self.hit | found.hit;
            return;
        }
        let nearer = found.hit & found.t.lt(self.t);
        let Found { t, u, v, .. } = *found;
        if P::Output::SURFACE {
            let ([x, y, z], [ox, oy, oz]) = (normal.0, self.normal.0);
            let old = [self.t, self.triangle, self.u, self.v, ox, oy, oz];
            let new = P::Exit::select(nearer, [t, index, u, v, x, y, z], old);
            [self.t, self.triangle, self.u, self.v] = [new[0], new[1], new[2], new[3]];
            self.normal = Vec3([new[4], new[5], new[6]]);
        } else if P::Output::UV {
            let old = [self.t, self.triangle, self.u, self.v];
            let new = P::Exit::select(nearer, [t, index, u, v], old);
            [self.t, self.triangle, self.u, self.v] = new;
        } else {
            let new = P::Exit::select(nearer, [t, index], [self.t, self.triangle]);
            [self.t, self.triangle] = new;
        }
        ray.t_max = self.t;
    }
}

impl<L, K, P, R> Batch<L> for Nearest<K, P, R>
where
    L: Level,
    K: Kernel,
    P: Policy,
    R: Real + On<L>,
{
    type Data<'a> = Scene<'a, R::Element, K::Record<R::Element>>;
    type Yield = ();

    #[inline(always)]
    fn run(token: L::Token, scene: Self::Data<'_>) {
        let token = R::token_on(token);
        if size_of::<R>() > 16 {
            // See [`Anchor`].
            let anchor = Anchor(0);
            black_box(&anchor);
        }
        let packets = scene.rays.chunks_exact(RAY_NUMBERS * R::LANES);
        let answers = scene.answers.chunks_exact_mut(ANSWER_NUMBERS * R::LANES);
        for (packet, answer) in packets.zip(answers) {
            let mut ray = load::<R>(token, packet);
            let best = walk::<K, P, R>(token, &mut ray, scene.records);
            write::<P, R>(&ray, &best, answer);
        }
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
    let aim = K::aim::<P, R>(ray);
    let one = R::splat(token, R::Element::ONE);
    let mut index = nothing;
    for record in records {
        if R::LANES == 1 {
            // A single ray must not be tested against several triangles at once.
            black_box(());
        }
        let met = K::meet::<P, R>(token, record);
        if let Ok(found) = K::test::<P, R>(ray, &aim, &met) {
            best.update::<P>(ray, &found, index, K::normal::<P, R>(&met));
        }
        index = index + one;
    }
    best
}

/// Stores a packet's answer.
#[inline(always)]
fn write<P: Policy, R: Real>(ray: &Ray<R>, best: &Best<R>, answer: &mut [R::Element]) {
    let point = if P::Output::SURFACE {
        surface_point(ray.origin, ray.direction, best.t)
    } else {
        best.normal
    };
    let [x, y, z] = point.0;
    let [nx, ny, nz] = best.normal.0;
    // Where only the hit is wanted no triangle was noted; 0 stands for "one of them".
    let mut triangle = [best.triangle];
    if !P::Output::T {
        triangle = P::Exit::select(best.hit, [best.triangle.zero()], triangle);
    }
    let rows = [triangle[0], best.t, best.u, best.v, x, y, z, nx, ny, nz];
    for (row, place) in rows.into_iter().zip(answer.chunks_exact_mut(R::LANES)) {
        row.store(place);
    }
}

//! Kensler-Shirley: A. Kensler, P. Shirley, "Optimizing Ray-Triangle Intersection via Automated
//! Search", IEEE Symposium on Interactive Ray Tracing, 2006; thesis H, 3.3.2 and 4.3.1.
//!
//! Formula, with AB = b - a, CA = a - c, N = AB x CA, OA = a - o and I = OA x D: det = D . N,
//! t = N . OA / det, u = I . CA / det, v = I . AB / det.
//! Stored: 9 numbers (vertices), 12 (with normal), 12 (precomputed). Operations of a hit with
//! everything stored, divided first: 21 x, 15 +-, 1 / (divided last 22 x); the edges cost 6 -, N costs 6 x and 3 -.
//! Known weakness: as Moeller-Trumbore, whose algebra it is, and t inherits the rounding of N,
//! which is large for needles.

use std::marker::PhantomData;

use super::begun::in_one_piece;
use super::shares::{Known, known, shared_in_one_piece};
use super::stored::Frame;
use super::{About, CommonOrigin, Corners, Kernel, Parallel, Shares, Source, Stored};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Found, Leading, Miss, Policy, Ray, Scale};

/// See the module's text. `S` says what is stored.
pub struct KenslerShirley<S>(PhantomData<S>);

impl<S: Stored> Kernel for KenslerShirley<S> {
    const ABOUT: About = About {
        id: "kensler-shirley",
        name: "Kensler-Shirley",
        year: 2006,
        source: "Kensler and Shirley, IEEE Symposium on Interactive Ray Tracing, 2006",
        setup: S::SETUP,
        stored: S::NAME,
        watertight: false,
        codes: &["det is 0", "t outside", "u, v or u + v outside"],
    };
    type Record<E: Element> = S::Record<E>;
    type Met<R: Real> = Frame<R>;
    type Aim<R: Real> = ();

    fn prepare<E: Element>(corners: &Corners<E>) -> S::Record<E> {
        S::prepare(corners)
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, O: Source<T>>(stored: &O) -> Frame<T> {
        S::read::<P, T, O>(stored)
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    in_one_piece!();

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Frame<R>,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        test_knowing::<P, R>(ray, tri, Known::NOTHING)
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Frame<R>) -> Vec3<R> {
        P::cross(tri.ca, tri.ab)
    }
}

/// What follows from the origin: OA and N . OA.
#[derive(Clone, Copy)]
struct FromOrigin<R> {
    oa: Vec3<R>,
    depth: R,
}

/// What follows from the direction: det and the inverse of its scale.
#[derive(Clone, Copy)]
struct FromDirection<R> {
    det: R,
    inverse: R,
}

#[inline(always)]
fn seen<R: Real>(tri: &Frame<R>, ray: &Ray<R>) -> Vec3<R> {
    tri.a - ray.origin
}

#[inline(always)]
fn depth<P: Policy, R: Real>(tri: &Frame<R>, oa: Vec3<R>) -> R {
    P::dot(tri.n, oa)
}

#[inline(always)]
fn determinant<P: Policy, R: Real>(tri: &Frame<R>, ray: &Ray<R>) -> R {
    P::dot(ray.direction, tri.n)
}

/// The test, of which some is known.
#[inline(always)]
fn test_knowing<P: Policy, R: Real>(
    ray: &Ray<R>,
    tri: &Frame<R>,
    known: Known<FromOrigin<R>, FromDirection<R>>,
) -> Result<Found<R>, Miss> {
    let det = known!(known.direction.det, determinant::<P, R>(tri, ray));
    let scale = P::divide(det);
    let hit = P::keep(P::divisible(det), 1)?;
    let oa = known!(known.origin.oa, seen(tri, ray));
    let (hit, [t, u, v]) = if P::Leading::DISTANCE {
        let t = P::signed(known!(known.origin.depth, depth::<P, R>(tri, oa)), scale);
        let hit = P::keep_range(hit, ray, t, scale, 2)?;
        let (hit, u, v) = keep_inside::<P, R>(hit, ray, oa, tri, scale)?;
        (hit, [t, u, v])
    } else {
        let (hit, u, v) = keep_inside::<P, R>(hit, ray, oa, tri, scale)?;
        let t = P::signed(known!(known.origin.depth, depth::<P, R>(tri, oa)), scale);
        (P::keep_range(hit, ray, t, scale, 2)?, [t, u, v])
    };
    let hit = P::settle(hit, ray, t, scale)?;
    let inverse = known!(known.direction.inverse, P::inverse(scale));
    Ok(P::finish_by(hit, ray, [t, u, v], inverse))
}

/// OA in place of a, the edges, N.
#[inline(always)]
fn numbers<R: Real>(a: Vec3<R>, tri: &Frame<R>) -> [R; 12] {
    let ([ax, ay, az], [nx, ny, nz]) = (a.0, tri.n.0);
    let ([bx, by, bz], [cx, cy, cz]) = (tri.ab.0, tri.ca.0);
    [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz]
}

/// What [`numbers`] wrote.
#[inline(always)]
fn frame<R: Real, O: Source<R>>(shared: &O) -> Frame<R> {
    Frame { a: shared.vector(0), ab: shared.vector(3), ca: shared.vector(6), n: shared.vector(9) }
}

impl<S: Stored> Shares<CommonOrigin> for KenslerShirley<S> {
    /// OA, the edges, N, N . OA.
    type Shared<R: Real> = [R; 13];

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Frame<R>) -> [R; 13] {
        let oa = seen(tri, ray);
        let [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz] = numbers(oa, tri);
        [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz, depth::<P, R>(tri, oa)]
    }

    shared_in_one_piece!();

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, O: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &O,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        let tri = frame(shared);
        let origin = FromOrigin { oa: tri.a, depth: shared.number(12) };
        test_knowing::<P, R>(ray, &tri, Known { origin: Some(origin), direction: None })
    }
}

impl<S: Stored> Shares<Parallel> for KenslerShirley<S> {
    /// The corner, the edges, N, det and its inverse.
    type Shared<R: Real> = [R; 14];

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Frame<R>) -> [R; 14] {
        let det = determinant::<P, R>(tri, ray);
        let [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz] = numbers(tri.a, tri);
        let inverse = P::inverse(P::divide(det));
        [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz, det, inverse]
    }

    shared_in_one_piece!();

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, O: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &O,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        let direction = FromDirection { det: shared.number(12), inverse: shared.number(13) };
        let known = Known { origin: None, direction: Some(direction) };
        test_knowing::<P, R>(ray, &frame(shared), known)
    }
}

#[inline(always)]
fn keep_inside<P: Policy, R: Real>(
    hit: R::Mask,
    ray: &Ray<R>,
    oa: Vec3<R>,
    tri: &Frame<R>,
    scale: Scale<R>,
) -> Result<(R::Mask, R, R), Miss> {
    let i = P::cross(oa, ray.direction);
    let u = P::signed(P::dot(i, tri.ca), scale);
    let v = P::signed(P::dot(i, tri.ab), scale);
    Ok((P::keep(hit & P::inside(u, v, scale), 3)?, u, v))
}

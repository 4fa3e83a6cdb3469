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

use super::stored::Frame;
use super::{About, Corners, Kernel, Source, Stored};
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

    #[inline(always)]
    fn test<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Frame<R>) -> Result<Found<R>, Miss> {
        let det = P::dot(ray.direction, tri.n);
        let scale = P::divide(det);
        let hit = P::keep(P::divisible(det), 1)?;
        let oa = tri.a - ray.origin;
        if P::Leading::DISTANCE {
            let t = P::signed(P::dot(tri.n, oa), scale);
            let hit = P::keep_range(hit, ray, t, scale, 2)?;
            let (hit, u, v) = keep_inside::<P, R>(hit, ray, oa, tri, scale)?;
            P::finish(hit, ray, [t, u, v], scale)
        } else {
            let (hit, u, v) = keep_inside::<P, R>(hit, ray, oa, tri, scale)?;
            let t = P::signed(P::dot(tri.n, oa), scale);
            let hit = P::keep_range(hit, ray, t, scale, 2)?;
            P::finish(hit, ray, [t, u, v], scale)
        }
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Frame<R>) -> Vec3<R> {
        P::cross(tri.ca, tri.ab)
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

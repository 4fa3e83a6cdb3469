//! Moeller-Trumbore: T. Moeller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection",
//! Journal of Graphics Tools 2(1), 1997; thesis H, 3.3.1; the coursebook (which prints e1 x p for
//! the dot product, and tests no t).
//!
//! Formula: p = d x e2, det = e1 . p, s = o - a, u = s . p / det, q = s x e1, v = d . q / det,
//! t = e2 . q / det.
//! Stored: 9 numbers (36 bytes in f32). Operations of a hit, divided first: 27 x, 24 +-, 1 /;
//! divided last 28 x.
//! Known weakness: no shared edge is evaluated the same from both sides, so rays through edges
//! leak; d x e2 cancels for directions along an edge.

use super::{About, Corners, Kernel, Source};
use crate::number::{Element, Real, Vec3, spread};
use crate::policy::{Found, Leading, Miss, Policy, Ray, Scale};

/// See the module's text.
pub struct MollerTrumbore;

/// A corner and the two edges from it.
#[derive(Clone, Copy)]
pub struct Met<R> {
    a: Vec3<R>,
    e1: Vec3<R>,
    e2: Vec3<R>,
}

spread!(Met { a, e1, e2 });

impl<R: Real> Met<R> {
    /// Of a triangle's corners.
    #[inline(always)]
    pub fn of(corners: &Corners<R>) -> Self {
        let (e1, e2) = corners.edges();
        Met { a: corners.a, e1, e2 }
    }
}

impl Kernel for MollerTrumbore {
    const ABOUT: About = About {
        id: "moller-trumbore",
        name: "Möller-Trumbore",
        year: 1997,
        source: "Möller and Trumbore, Journal of Graphics Tools 2(1), 1997",
        setup: "none: three vertices",
        stored: "vertices",
        watertight: false,
        codes: &["det is 0", "u outside", "v or u + v outside", "t outside"],
    };
    type Record<E: Element> = [E; 9];
    type Met<R: Real> = Met<R>;
    type Aim<R: Real> = ();

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 9] {
        corners.numbers()
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Met<T> {
        Met::of(&Corners::read(stored, 0))
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    #[inline(always)]
    fn test<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Met<R>) -> Result<Found<R>, Miss> {
        let p = P::cross(ray.direction, tri.e2);
        let det = P::dot(tri.e1, p);
        let scale = P::divide(det);
        let hit = P::keep(P::divisible(det), 1)?;
        let s = ray.origin - tri.a;
        if P::Leading::DISTANCE {
            let q = P::cross(s, tri.e1);
            let t = P::signed(P::dot(tri.e2, q), scale);
            let hit = P::keep_range(hit, ray, t, scale, 4)?;
            let (hit, u) = keep_u::<P, R>(hit, s, p, scale)?;
            let (hit, v) = keep_v::<P, R>(hit, ray, q, u, scale)?;
            P::finish(hit, ray, [t, u, v], scale)
        } else {
            let (hit, u) = keep_u::<P, R>(hit, s, p, scale)?;
            let q = P::cross(s, tri.e1);
            let (hit, v) = keep_v::<P, R>(hit, ray, q, u, scale)?;
            let t = P::signed(P::dot(tri.e2, q), scale);
            let hit = P::keep_range(hit, ray, t, scale, 4)?;
            P::finish(hit, ray, [t, u, v], scale)
        }
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        P::cross(tri.e1, tri.e2)
    }
}

#[inline(always)]
fn keep_u<P: Policy, R: Real>(
    hit: R::Mask,
    s: Vec3<R>,
    p: Vec3<R>,
    scale: Scale<R>,
) -> Result<(R::Mask, R), Miss> {
    let u = P::signed(P::dot(s, p), scale);
    Ok((P::keep(hit & P::share(u, scale), 2)?, u))
}

#[inline(always)]
fn keep_v<P: Policy, R: Real>(
    hit: R::Mask,
    ray: &Ray<R>,
    q: Vec3<R>,
    u: R,
    scale: Scale<R>,
) -> Result<(R::Mask, R), Miss> {
    let v = P::signed(P::dot(ray.direction, q), scale);
    Ok((P::keep(hit & P::beside(u, v, scale), 3)?, v))
}

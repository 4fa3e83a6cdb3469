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

use super::begun::in_one_piece;
use super::shares::known;
use super::{About, Begun, CommonOrigin, Corners, Kernel, Parallel, Shares, Source};
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

    in_one_piece!();

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Met<R>,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        let begun = begin_knowing::<P, R>(ray, tri, None)?;
        end_knowing::<P, R>(ray, tri, &begun, None)
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        P::cross(tri.e1, tri.e2)
    }
}

/// What follows from the origin: s, q, and e2 . q.
#[derive(Clone, Copy)]
struct FromOrigin<R> {
    s: Vec3<R>,
    q: Vec3<R>,
    depth: R,
}

/// What follows from the direction: p, det and the division by it.
#[derive(Clone, Copy)]
struct FromDirection<R> {
    p: Vec3<R>,
    det: R,
    divided: R,
}

/// What the first part of a test leaves to the second: the determinant's division, and p.
#[derive(Clone, Copy)]
pub struct Halfway<R: Real> {
    begun: Begun<R>,
    p: Vec3<R>,
}

impl<R: Real> Met<R> {
    #[inline(always)]
    fn s(&self, ray: &Ray<R>) -> Vec3<R> {
        ray.origin - self.a
    }
    #[inline(always)]
    fn q<P: Policy>(&self, s: Vec3<R>) -> Vec3<R> {
        P::cross(s, self.e1)
    }
    #[inline(always)]
    fn depth<P: Policy>(&self, q: Vec3<R>) -> R {
        P::dot(self.e2, q)
    }
    #[inline(always)]
    fn p<P: Policy>(&self, ray: &Ray<R>) -> Vec3<R> {
        P::cross(ray.direction, self.e2)
    }
    #[inline(always)]
    fn det<P: Policy>(&self, p: Vec3<R>) -> R {
        P::dot(self.e1, p)
    }
}

/// The first part of the test, of which some is known.
#[inline(always)]
fn begin_knowing<P: Policy, R: Real>(
    ray: &Ray<R>,
    tri: &Met<R>,
    direction: Option<FromDirection<R>>,
) -> Result<Halfway<R>, Miss> {
    let p = known!(direction.p, tri.p::<P>(ray));
    let det = known!(direction.det, tri.det::<P>(p));
    let begun = Begun::dividing::<P>(P::divisible(det), det, known!(direction.divided));
    Ok(Halfway { begun: begun.keep::<P>(1)?, p })
}

/// The rest of it.
#[inline(always)]
fn end_knowing<P: Policy, R: Real>(
    ray: &Ray<R>,
    tri: &Met<R>,
    halfway: &Halfway<R>,
    origin: Option<FromOrigin<R>>,
) -> Result<Found<R>, Miss> {
    let Halfway { begun, p } = *halfway;
    let Begun { hit, scale, .. } = begun;
    let s = known!(origin.s, tri.s(ray));
    let (hit, [t, u, v]) = if P::Leading::DISTANCE {
        let q = known!(origin.q, tri.q::<P>(s));
        let t = P::signed(known!(origin.depth, tri.depth::<P>(q)), scale);
        let hit = P::keep_range(hit, ray, t, scale, 4)?;
        let (hit, u) = keep_u::<P, R>(hit, s, p, scale)?;
        let (hit, v) = keep_v::<P, R>(hit, ray, q, u, scale)?;
        (hit, [t, u, v])
    } else {
        let (hit, u) = keep_u::<P, R>(hit, s, p, scale)?;
        let q = known!(origin.q, tri.q::<P>(s));
        let (hit, v) = keep_v::<P, R>(hit, ray, q, u, scale)?;
        let t = P::signed(known!(origin.depth, tri.depth::<P>(q)), scale);
        (P::keep_range(hit, ray, t, scale, 4)?, [t, u, v])
    };
    begun.finish::<P>(hit, ray, [t, u, v])
}

impl Shares<CommonOrigin> for MollerTrumbore {
    /// s, q, the edges, e2 . q.
    type Shared<R: Real> = [R; 13];
    type Begun<R: Real> = Halfway<R>;

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Met<R>) -> [R; 13] {
        let s = tri.s(ray);
        let q = tri.q::<P>(s);
        let ([sx, sy, sz], [qx, qy, qz]) = (s.0, q.0);
        let ([ax, ay, az], [bx, by, bz]) = (tri.e1.0, tri.e2.0);
        [sx, sy, sz, qx, qy, qz, ax, ay, az, bx, by, bz, tri.depth::<P>(q)]
    }

    #[inline(always)]
    fn begin_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
    ) -> Result<Halfway<R>, Miss> {
        begin_knowing::<P, R>(ray, &from_one_point(shared), None)
    }

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
        begun: &Halfway<R>,
    ) -> Result<Found<R>, Miss> {
        let tri = from_one_point(shared);
        let origin = FromOrigin { s: tri.a, q: shared.vector(3), depth: shared.number(12) };
        end_knowing::<P, R>(ray, &tri, begun, Some(origin))
    }
}

/// The edges, of what rays with one origin share; in the place of the corner, which is behind s, stands s.
#[inline(always)]
fn from_one_point<R: Real, S: Source<R>>(shared: &S) -> Met<R> {
    Met { a: shared.vector(0), e1: shared.vector(6), e2: shared.vector(9) }
}

impl Shares<Parallel> for MollerTrumbore {
    /// The corner, the edges, p, det and the division by it.
    type Shared<R: Real> = [R; 14];
    type Begun<R: Real> = Halfway<R>;

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Met<R>) -> [R; 14] {
        let p = tri.p::<P>(ray);
        let det = tri.det::<P>(p);
        let ([ax, ay, az], [px, py, pz]) = (tri.a.0, p.0);
        let ([bx, by, bz], [cx, cy, cz]) = (tri.e1.0, tri.e2.0);
        let divided = P::divided(det);
        [ax, ay, az, bx, by, bz, cx, cy, cz, px, py, pz, det, divided]
    }

    #[inline(always)]
    fn begin_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
    ) -> Result<Halfway<R>, Miss> {
        let (p, det, divided) = (shared.vector(9), shared.number(12), shared.number(13));
        let direction = FromDirection { p, det, divided };
        begin_knowing::<P, R>(ray, &in_one_direction(shared), Some(direction))
    }

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
        begun: &Halfway<R>,
    ) -> Result<Found<R>, Miss> {
        end_knowing::<P, R>(ray, &in_one_direction(shared), begun, None)
    }
}

/// The corner and the edges, of what rays with one direction share.
#[inline(always)]
fn in_one_direction<R: Real, S: Source<R>>(shared: &S) -> Met<R> {
    Met { a: shared.vector(0), e1: shared.vector(3), e2: shared.vector(6) }
}

#[inline(always)]
fn keep_u<P: Policy, R: Real>(
    hit: R::Mask,
    s: Vec3<R>,
    p: Vec3<R>,
    scale: Scale<R>,
) -> Result<(R::Mask, R), Miss> {
    let u = P::signed(P::dot(s, p), scale);
    Ok((P::keep(P::share(hit, u, scale), 2)?, u))
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
    Ok((P::keep(P::beside(hit, u, v, scale), 3)?, v))
}

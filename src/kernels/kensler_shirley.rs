//! Kensler-Shirley: A. Kensler, P. Shirley, "Optimizing Ray-Triangle Intersection via Automated
//! Search", IEEE Symposium on Interactive Ray Tracing, 2006; thesis H, 3.3.2 and 4.3.1.
//!
//! Formula, with AB = b - a, CA = a - c, N = AB x CA, OA = a - o and I = OA x D: det = D . N,
//! t = N . OA / det, u = I . CA / det, v = I . AB / det.
//! Stored: 9 numbers (vertices), 12 (with normal), 12 (precomputed). Operations of a hit with
//! everything stored, divided first: 21 x, 15 +-, 1 / (divided last 22 x); the edges cost 6 -, N costs 6 x and 3 -.
//! With [`WithEdges`](super::WithEdges) u = (CA x OA) . D / det and v = (AB x OA) . D / det, 6 x and 3 -
//! more, all of which rays with one origin share.
//! Known weakness: as Moeller-Trumbore, whose algebra it is, and t inherits the rounding of N,
//! which is large for needles.

use std::marker::PhantomData;

use super::half_spaces::Depth;
use super::shares::known;
use super::stored::Frame;
use super::triple::{Triple, WithDirection};
use super::{About, Begun, CommonOrigin, Corners, Kernel, Parallel, Shares, Source, Stored};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Found, Leading, Miss, Policy, Ray, Scale};

/// See the module's text. `S` says what is stored, `O` in which order triple products are multiplied.
pub struct KenslerShirley<S, O = WithDirection>(PhantomData<(S, O)>);

impl<S: Stored, O: Triple> Kernel for KenslerShirley<S, O> {
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
    /// Nothing where N is computed: both parts would compute it.
    type Begun<R: Real> = Option<Begun<R>>;

    fn prepare<E: Element>(corners: &Corners<E>) -> S::Record<E> {
        S::prepare(corners)
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, M: Source<T>>(stored: &M) -> Frame<T> {
        S::read::<P, T, M>(stored)
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    #[inline(always)]
    fn begin<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Frame<R>,
    ) -> Result<Option<Begun<R>>, Miss> {
        Ok(if S::STORES_NORMAL { Some(begin::<P, R>(ray, tri.n, None)?) } else { None })
    }

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Frame<R>,
        begun: &Option<Begun<R>>,
    ) -> Result<Found<R>, Miss> {
        let begun = match begun {
            Some(begun) => *begun,
            None => begin::<P, R>(ray, tri.n, None)?,
        };
        let oa = tri.a - ray.origin;
        let seen = O::seen::<P, R>(oa, tri);
        end::<O, P, R>(ray, &begun, &seen, (tri.n, Depth::To(oa)))
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Frame<R>) -> Vec3<R> {
        P::cross(tri.ca, tri.ab)
    }
}

/// What follows from the direction: det and the division by it.
#[derive(Clone, Copy)]
struct FromDirection<R> {
    det: R,
    divided: R,
}

/// The first part of the test, of which some may be known.
#[inline(always)]
fn begin<P: Policy, R: Real>(
    ray: &Ray<R>,
    n: Vec3<R>,
    direction: Option<FromDirection<R>>,
) -> Result<Begun<R>, Miss> {
    let det = known!(direction.det, P::dot(ray.direction, n));
    Begun::dividing::<P>(P::divisible(det), det, known!(direction.divided)).keep::<P>(1)
}

/// The rest of it.
#[inline(always)]
fn end<O: Triple, P: Policy, R: Real>(
    ray: &Ray<R>,
    begun: &Begun<R>,
    seen: &O::Seen<R>,
    (n, depth): (Vec3<R>, Depth<R>),
) -> Result<Found<R>, Miss> {
    let Begun { hit, scale, .. } = *begun;
    let (hit, [t, u, v]) = if P::Leading::DISTANCE {
        let t = P::signed(depth.along::<P>(n), scale);
        let hit = P::keep_range(hit, ray, t, scale, 2)?;
        let (hit, [u, v]) = keep_inside::<O, P, R>(hit, ray, seen, scale)?;
        (hit, [t, u, v])
    } else {
        let (hit, [u, v]) = keep_inside::<O, P, R>(hit, ray, seen, scale)?;
        let t = P::signed(depth.along::<P>(n), scale);
        (P::keep_range(hit, ray, t, scale, 2)?, [t, u, v])
    };
    begun.finish::<P>(hit, ray, [t, u, v])
}

#[inline(always)]
fn keep_inside<O: Triple, P: Policy, R: Real>(
    hit: R::Mask,
    ray: &Ray<R>,
    seen: &O::Seen<R>,
    scale: Scale<R>,
) -> Result<(R::Mask, [R; 2]), Miss> {
    let [u, v] = O::weights::<P, R>(seen, ray.direction);
    let [u, v] = [P::signed(u, scale), P::signed(v, scale)];
    Ok((P::keep(P::inside(hit, u, v, scale), 3)?, [u, v]))
}

impl<S: Stored, O: Triple> Shares<CommonOrigin> for KenslerShirley<S, O> {
    type Shared<R: Real> = O::Numbers<R>;
    type Begun<R: Real> = Begun<R>;

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Frame<R>) -> O::Numbers<R> {
        let oa = tri.a - ray.origin;
        O::numbers(tri.n, P::dot(tri.n, oa), &O::seen::<P, R>(oa, tri))
    }

    #[inline(always)]
    fn begin_shared<P: Policy, R: Real, M: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &M,
    ) -> Result<Begun<R>, Miss> {
        begin::<P, R>(ray, shared.vector(0), None)
    }

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, M: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &M,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        let depth = Depth::Known(shared.number(3));
        end::<O, P, R>(ray, begun, &O::read(shared), (shared.vector(0), depth))
    }
}

impl<S: Stored> Shares<Parallel> for KenslerShirley<S> {
    /// The corner, the edges, N, det and the division by it.
    type Shared<R: Real> = [R; 14];
    type Begun<R: Real> = Begun<R>;

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Frame<R>) -> [R; 14] {
        let ([ax, ay, az], [nx, ny, nz]) = (tri.a.0, tri.n.0);
        let ([bx, by, bz], [cx, cy, cz]) = (tri.ab.0, tri.ca.0);
        let det = P::dot(ray.direction, tri.n);
        [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz, det, P::divided(det)]
    }

    #[inline(always)]
    fn begin_shared<P: Policy, R: Real, M: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &M,
    ) -> Result<Begun<R>, Miss> {
        let direction = FromDirection { det: shared.number(12), divided: shared.number(13) };
        begin::<P, R>(ray, shared.vector(9), Some(direction))
    }

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, M: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &M,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        let (a, n) = (shared.vector(0), shared.vector(9));
        let tri = Frame { a, ab: shared.vector(3), ca: shared.vector(6), n };
        let oa = a - ray.origin;
        let seen = WithDirection::seen::<P, R>(oa, &tri);
        end::<WithDirection, P, R>(ray, begun, &seen, (n, Depth::To(oa)))
    }
}

//! Perpendicular planes: thesis H, 3.5 (2008); J. Havel, A. Herout, "Yet Faster Ray-Triangle
//! Intersection (Using SSE4)", IEEE TVCG 16(3), 2010, is this kernel divided last.
//!
//! Formula: t = (n . a - o . n) / (d . n), P = o + t d, u = P . n_b + b_d, v = P . n_c + c_d, with
//! n_b = (AC x N) / |N|^2 and n_c = (N x AB) / |N|^2: planes through two edges, perpendicular to
//! the triangle, in which the opposite vertex is at distance 1.
//! Stored: 12 numbers (48 bytes in f32). Operations of a hit, divided first: 15 x, 15 +-, 1 /;
//! divided last 24 x (21 before the last test).
//! Known weakness: the planes' constants cancel far from the origin; |N|^2 has degree 4, so it
//! leaves the range of f32 for triangles below 1e-10 and above 1e9.

use super::shares::{Known, known};
use super::stored::{plain_cross, plain_dot};
use super::{About, Begun, CommonOrigin, Corners, Kernel, Parallel, Shares, Source};
use crate::number::{Element, Real, Vec3, spread};
use crate::policy::{Found, Miss, Policy, Ray, Scale};

/// See the module's text.
pub struct PerpendicularPlanes;

/// The triangle's plane and two perpendicular ones: n . p = d, b . p + b_d = u, c . p + c_d = v.
/// The record holds them in this order.
#[derive(Clone, Copy)]
pub struct Planes<R> {
    n: Vec3<R>,
    nd: R,
    b: Vec3<R>,
    bd: R,
    c: Vec3<R>,
    cd: R,
}

spread!(Planes { n, nd, b, bd, c, cd });

impl Kernel for PerpendicularPlanes {
    const ABOUT: About = About {
        id: "perpendicular-planes",
        name: "Perpendicular planes",
        year: 2008,
        source: "thesis H, 3.5 (2008); Havel and Herout, IEEE TVCG 16(3), 2010",
        setup: "three planes",
        stored: "precomputed",
        watertight: false,
        codes: &["det is 0", "t outside", "u, v or u + v outside"],
    };
    type Record<E: Element> = [E; 12];
    type Met<R: Real> = Planes<R>;
    type Aim<R: Real> = ();
    type Begun<R: Real> = Begun<R>;

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 12] {
        let (ab, ac) = corners.edges();
        let n = plain_cross(ab, ac);
        let inverse = E::ONE / plain_dot(n, n);
        let b = plain_cross(ac, n).scaled(inverse);
        let c = plain_cross(n, ab).scaled(inverse);
        planes([
            (n, plain_dot(n, corners.a)),
            (b, -plain_dot(b, corners.a)),
            (c, -plain_dot(c, corners.a)),
        ])
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Planes<T> {
        Planes::of(stored)
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    #[inline(always)]
    fn begin<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Planes<R>) -> Result<Begun<R>, Miss> {
        begin_knowing::<P, R>(ray, tri, Known::NOTHING)
    }

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Planes<R>,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        let point = point_on::<P, R>(ray, begun.t, begun.scale);
        let u = share::<P, R>(point, tri.b, tri.bd, begun.scale);
        let v = share::<P, R>(point, tri.c, tri.cd, begun.scale);
        let hit = P::keep(P::inside(begun.hit, u, v, begun.scale), 3)?;
        begun.finish::<P>(hit, ray, [begun.t, u, v])
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Planes<R>) -> Vec3<R> {
        tri.n
    }
}

/// What follows from the origin: how far it is from the plane.
#[derive(Clone, Copy)]
struct FromOrigin<R> {
    height: R,
}

/// What follows from the direction: det and, divided last, its inverse.
#[derive(Clone, Copy)]
struct FromDirection<R> {
    det: R,
    inverse: R,
}

impl<R: Real> Planes<R> {
    #[inline(always)]
    fn of<S: Source<R>>(stored: &S) -> Self {
        Planes {
            n: stored.vector(0),
            nd: stored.number(3),
            b: stored.vector(4),
            bd: stored.number(7),
            c: stored.vector(8),
            cd: stored.number(11),
        }
    }
    #[inline(always)]
    fn height<P: Policy>(&self, ray: &Ray<R>) -> R {
        self.nd - P::dot(ray.origin, self.n)
    }
    #[inline(always)]
    fn det<P: Policy>(&self, ray: &Ray<R>) -> R {
        P::dot(ray.direction, self.n)
    }
    /// `nd` in the place of the plane's own distance.
    #[inline(always)]
    fn numbers(&self, nd: R) -> [R; 12] {
        let ([nx, ny, nz], [bx, by, bz], [cx, cy, cz]) = (self.n.0, self.b.0, self.c.0);
        [nx, ny, nz, nd, bx, by, bz, self.bd, cx, cy, cz, self.cd]
    }
}

/// The first part of the test, of which some is known.
#[inline(always)]
fn begin_knowing<P: Policy, R: Real>(
    ray: &Ray<R>,
    tri: &Planes<R>,
    known: Known<FromOrigin<R>, FromDirection<R>>,
) -> Result<Begun<R>, Miss> {
    let det = known!(known.direction.det, tri.det::<P>(ray));
    let hit = P::keep(P::divisible(det), 1)?;
    let (t, scale) = P::quotient(known!(known.origin.height, tri.height::<P>(ray)), det);
    let hit = P::keep_range(hit, ray, t, scale, 2)?;
    let direction = known.direction;
    Ok(Begun::knowing::<P>(hit, t, scale, known!(direction.inverse)))
}

impl Shares<CommonOrigin> for PerpendicularPlanes {
    /// The planes, the first one's distance counted from the origin of the rays.
    type Shared<R: Real> = [R; 12];
    type Begun<R: Real> = Begun<R>;

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Planes<R>) -> [R; 12] {
        tri.numbers(tri.height::<P>(ray))
    }

    #[inline(always)]
    fn begin_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
    ) -> Result<Begun<R>, Miss> {
        let tri = Planes::of(shared);
        let origin = FromOrigin { height: tri.nd };
        begin_knowing::<P, R>(ray, &tri, Known { origin: Some(origin), direction: None })
    }

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        Self::end::<P, R>(ray, &(), &Planes::of(shared), begun)
    }
}

impl Shares<Parallel> for PerpendicularPlanes {
    /// The planes, det and, divided last, its inverse.
    type Shared<R: Real> = [R; 14];
    type Begun<R: Real> = Begun<R>;

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Planes<R>) -> [R; 14] {
        let det = tri.det::<P>(ray);
        let [nx, ny, nz, nd, bx, by, bz, bd, cx, cy, cz, cd] = tri.numbers(tri.nd);
        let inverse = P::inverse(P::divide(det));
        [nx, ny, nz, nd, bx, by, bz, bd, cx, cy, cz, cd, det, inverse]
    }

    #[inline(always)]
    fn begin_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
    ) -> Result<Begun<R>, Miss> {
        let direction = FromDirection { det: shared.number(12), inverse: shared.number(13) };
        let known = Known { origin: None, direction: Some(direction) };
        begin_knowing::<P, R>(ray, &Planes::of(shared), known)
    }

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        Self::end::<P, R>(ray, &(), &Planes::of(shared), begun)
    }
}

/// A record of three planes, each a vector and a number.
pub fn planes<E: Element>(planes: [(Vec3<E>, E); 3]) -> [E; 12] {
    let [(p, pd), (q, qd), (r, rd)] = planes;
    let ([px, py, pz], [qx, qy, qz], [rx, ry, rz]) = (p.0, q.0, r.0);
    [px, py, pz, pd, qx, qy, qz, qd, rx, ry, rz, rd]
}

/// o + t d, in `scale`.
#[inline(always)]
pub fn point_on<P: Policy, R: Real>(ray: &Ray<R>, t: R, scale: Scale<R>) -> Vec3<R> {
    let (o, d) = (ray.origin, ray.direction);
    Vec3([
        P::along(o.x(), d.x(), t, scale),
        P::along(o.y(), d.y(), t, scale),
        P::along(o.z(), d.z(), t, scale),
    ])
}

/// n . p + d, in `scale`.
#[inline(always)]
pub fn share<P: Policy, R: Real>(p: Vec3<R>, n: Vec3<R>, d: R, scale: Scale<R>) -> R {
    let xy = P::multiply_add(p.y(), n.y(), P::multiply_add(p.x(), n.x(), P::scaled(d, scale)));
    P::multiply_add(p.z(), n.z(), xy)
}

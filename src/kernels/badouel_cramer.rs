//! Badouel in Cramer's form: D. Badouel, "An Efficient Ray-Polygon Intersection", Graphics Gems,
//! 1990, p. 390 (Snyder and Barr, 1987); thesis H, 3.4.1 and 4.3.3, which prefers Cramer's rule to
//! the published substitution (see [`super::listings`] for that): no branch, one denominator.
//!
//! Formula: t = (n . a - o . n) / (d . n); along the axis w of n's largest component, (u, v) the
//! next two in the cycle, Q = o + t d - a: g = AB_u AC_v - AC_u AB_v,
//! u = (Q_u AC_v - AC_u Q_v) / g, v = (AB_u Q_v - Q_u AB_v) / g.
//! Stored: the vertices, n, n . a and the axis: 14 words (56 bytes in f32).
//! Operations of a hit, divided first: 16 x, 17 +-, 2 /; divided last 23 x.
//! Known weakness: the plane's constant cancels far from the origin; slivers lose u and v twice.

use super::begun::in_one_piece;
use super::stored::{plain_cross, with_plane};
use super::{About, Corners, Kernel, PointTest, Source};
use crate::number::{Axis, Element, Real, Vec3, spread};
use crate::policy::{Division, Found, Miss, Policy, Ray, Scale};

/// See the module's text.
pub struct BadouelCramer;

/// The plane, and a and the two edges along u and v. The record is corners, n, n . a and the axis w.
#[derive(Clone, Copy)]
pub struct Met<R: Real> {
    w: Axis<R::Mask>,
    n: Vec3<R>,
    nd: R,
    a: [R; 2],
    ab: [R; 2],
    ac: [R; 2],
}

spread!(Met { w, n, nd, a, ab, ac });

impl Kernel for BadouelCramer {
    const ABOUT: About = About {
        id: "badouel-cramer",
        name: "Badouel, Cramer form",
        year: 1990,
        source: "Badouel, Graphics Gems, 1990; thesis H, 3.4.1 and 4.3.3",
        setup: "plane and axis",
        stored: "precomputed",
        watertight: false,
        codes: &["det is 0", "t outside", "u, v or u + v outside"],
    };
    type Record<E: Element> = [E; 14];
    type Met<R: Real> = Met<R>;
    type Aim<R: Real> = ();

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 14] {
        let (e1, e2) = corners.edges();
        let n = plain_cross(e1, e2);
        with_plane(corners, n)
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Met<T> {
        // Picking before broadcasting: the axis is the triangle's, whatever the rays are.
        let w = stored.axis(13);
        let (u, v) = (w.next(), w.next().next());
        let Corners { a, b, c } = &Corners::read(stored, 0);
        let (au, av) = (u.pick(a), v.pick(a));
        Met {
            w,
            n: stored.vector(9),
            nd: stored.number(12),
            a: [au, av],
            ab: [u.pick(b) - au, v.pick(b) - av],
            ac: [u.pick(c) - au, v.pick(c) - av],
        }
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
        let det = P::dot(ray.direction, tri.n);
        let hit = P::keep(P::divisible(det), 1)?;
        let (t, scale) = P::quotient(tri.nd - P::dot(ray.origin, tri.n), det);
        let hit = P::keep_range(hit, ray, t, scale, 2)?;
        let (u, v) = (tri.w.next(), tri.w.next().next());
        let q = [
            along::<P, R>(ray, u, t, scale) - P::scaled(tri.a[0], scale),
            along::<P, R>(ray, v, t, scale) - P::scaled(tri.a[1], scale),
        ];
        let (inside, shares, shares_scale) = contains::<P, R>(q, tri, scale);
        let hit = P::keep(hit & inside, 3)?;
        P::finish_apart(hit, ray, (t, scale), (shares, shares_scale))
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.n
    }
}

impl PointTest for BadouelCramer {
    #[inline(always)]
    fn contains<P: Policy, R: Real>(
        point: &Vec3<R>,
        tri: &Met<R>,
    ) -> Result<(R::Mask, R, R), Miss> {
        let (u, v) = (tri.w.next(), tri.w.next().next());
        let one = Scale { factor: tri.nd.one(), one: tri.nd.one() };
        let q = [u.pick(point) - tri.a[0], v.pick(point) - tri.a[1]];
        let (inside, [beta, gamma], scale) = contains::<P, R>(q, tri, one);
        let hit = P::keep(inside, 3)?;
        let inverse = P::inverse(scale);
        Ok((hit, P::Division::resolve(beta, inverse), P::Division::resolve(gamma, inverse)))
    }
}

/// The shares of b and c at `q` from a, where both are inside, and the scale they are in.
#[inline(always)]
fn contains<P: Policy, R: Real>(
    q: [R; 2],
    tri: &Met<R>,
    scale: Scale<R>,
) -> (R::Mask, [R; 2], Scale<R>) {
    let g = P::difference(tri.ab[0], tri.ac[1], tri.ac[0], tri.ab[1]);
    let area = P::divide(g);
    let beta = P::signed(P::difference(q[0], tri.ac[1], tri.ac[0], q[1]), area);
    let gamma = P::signed(P::difference(tri.ab[0], q[1], q[0], tri.ab[1]), area);
    let both = P::joined(scale, area);
    let divisible = P::divisible(g) & P::divisible(both.one) & P::finite(both.one);
    (P::inside(divisible, beta, gamma, both), [beta, gamma], both)
}

#[inline(always)]
fn along<P: Policy, R: Real>(ray: &Ray<R>, axis: Axis<R::Mask>, t: R, scale: Scale<R>) -> R {
    P::along(axis.pick(&ray.origin), axis.pick(&ray.direction), t, scale)
}

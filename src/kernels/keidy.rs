//! Keidy: the point test by dot products of Keidy (Mr. Gamemaker forum, about 2001), spread by
//! K. Fauerby, "Improved Collision Detection and Response", 2003; thesis H, 3.4.3 and text 1.
//!
//! Formula: t = N . (a - o) / (N . d), Q = o + t d - a; with AB, AC: a = AB . AB, b = AB . AC,
//! c = AC . AC, d = Q . AB, e = Q . AC, g = a c - b b, u = (d c - e b) / g, v = (e a - d b) / g.
//! CA = -AC is what is stored; both of its signs cancel in u, and in v the difference turns round.
//! `tests=sign-bits` is the published test (strict: u + v < 1); `compare` the closed form.
//! Stored: 9 numbers, or 12 with the normal. Operations of a hit, divided first, with the normal:
//! 32 x, 33 +-, 2 /; divided last 41 x; the normal costs 6 x and 3 -.
//! Known weakness: a c - b b cancels for slivers, where the error grows with the square of the aspect.

use std::marker::PhantomData;

use super::begun::in_one_piece;
use super::perpendicular_planes::point_on;
use super::stored::Frame;
use super::{About, Corners, Kernel, PointTest, Source, Stored};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Division, Found, Leading, Miss, Policy, Ray, Scale, Tests};

/// See the module's text. `S` says what is stored.
pub struct Keidy<S>(PhantomData<S>);

impl<S: Stored> Kernel for Keidy<S> {
    const ABOUT: About = About {
        id: "keidy",
        name: "Keidy",
        year: 2001,
        source: "Keidy, forum; Fauerby, 2003; thesis H, 3.4.3",
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
        let det = P::dot(ray.direction, tri.n);
        let mut hit = P::keep(P::divisible(det), 1)?;
        let oa = tri.a - ray.origin;
        let (t, scale) = P::quotient(P::dot(tri.n, oa), det);
        if P::Leading::DISTANCE {
            hit = P::keep_range(hit, ray, t, scale, 2)?;
        }
        let point = point_on::<P, R>(ray, t, scale);
        let a = Vec3([
            P::scaled(tri.a.x(), scale),
            P::scaled(tri.a.y(), scale),
            P::scaled(tri.a.z(), scale),
        ]);
        let (inside, shares, shares_scale) = contains::<P, R>(point - a, tri, scale);
        let mut hit = P::keep(hit & inside, 3)?;
        if !P::Leading::DISTANCE {
            hit = P::keep_range(hit, ray, t, scale, 2)?;
        }
        P::finish_apart(hit, ray, (t, scale), (shares, shares_scale))
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Frame<R>) -> Vec3<R> {
        P::cross(tri.ca, tri.ab)
    }
}

impl<S: Stored> PointTest for Keidy<S> {
    #[inline(always)]
    fn contains<P: Policy, R: Real>(
        point: &Vec3<R>,
        tri: &Frame<R>,
    ) -> Result<(R::Mask, R, R), Miss> {
        let one = tri.a.x().one();
        let (inside, [x, y], scale) =
            contains::<P, R>(*point - tri.a, tri, Scale { factor: one, one });
        let hit = P::keep(inside, 3)?;
        let inverse = P::inverse(scale);
        Ok((hit, P::Division::resolve(x, inverse), P::Division::resolve(y, inverse)))
    }
}

/// The shares of b and c at `q` from a, where both are inside, and the scale they are in.
#[inline(always)]
fn contains<P: Policy, R: Real>(
    q: Vec3<R>,
    tri: &Frame<R>,
    scale: Scale<R>,
) -> (R::Mask, [R; 2], Scale<R>) {
    let (q, scale) = if P::Tests::SIGN_BITS { upright(q, scale) } else { (q, scale) };
    let (a, b, c) = (P::dot(tri.ab, tri.ab), P::dot(tri.ab, tri.ca), P::dot(tri.ca, tri.ca));
    let (d, e) = (P::dot(q, tri.ab), P::dot(q, tri.ca));
    let g = P::difference(a, c, b, b);
    let area = P::divide(g);
    let x = P::signed(P::difference(d, c, e, b), area);
    let y = P::signed(P::difference(d, b, e, a), area);
    let both = P::joined(scale, area);
    let inside = if P::Tests::SIGN_BITS {
        // Text 1: the sign of z must be set and those of x and y must not: u + v < 1, strictly.
        let z = x + y - both.one;
        z.sign_bit() & !(x.sign_bit() | y.sign_bit())
    } else {
        let divisible = P::divisible(g) & P::divisible(both.one) & P::finite(both.one);
        P::inside(divisible, x, y, both)
    };
    (inside, [x, y], both)
}

/// A point under a positive scale. Text 1 has a point that is not scaled; the sign of the scale must
/// be undone before the shares are computed, since a share of 0 that is flipped afterwards is -0.
#[inline(always)]
fn upright<R: Real>(q: Vec3<R>, scale: Scale<R>) -> (Vec3<R>, Scale<R>) {
    let sign = scale.one;
    let q = Vec3([q.x().signed_by(sign), q.y().signed_by(sign), q.z().signed_by(sign)]);
    (q, Scale { factor: scale.factor, one: sign.signed_by(sign) })
}

//! Moeller-Trumbore on f32 data in f64 arithmetic: what a renderer can do that stores floats and
//! wants no more of their error than the data themselves have.
//!
//! Formula, stored, operations and codes: [`super::moller_trumbore`], which is called with every
//! number widened; t, u and v are rounded once, at the end. The wide ray is prepared once per ray.
//! Single rays only: a register holds half as many f64 as f32, so a packet would be of another width.
//! Known weakness: as of Moeller-Trumbore, 2^29 times smaller; range and decisions are those of f64.

use super::begun::in_one_piece;
use super::moller_trumbore::{self, MollerTrumbore};
use super::{About, Corners, Kernel, Source};
use crate::number::{Element, Real, Spread, Vec3};
use crate::policy::{Found, Miss, Policy, Ray};

/// See the module's text.
pub struct MollerTrumboreInF64;

/// What the numbers are widened to.
type Wide<R> = <<R as Real>::Element as Element>::Wide;

/// The wide triangle, and a number to know the token by.
#[derive(Clone, Copy)]
pub struct Met<R: Real> {
    wide: moller_trumbore::Met<Wide<R>>,
    zero: R,
}

impl<R: Real> Spread<R> for Met<R> {
    type One = Met<R::Element>;
    #[inline(always)]
    fn spread(token: R::Token, one: Met<R::Element>) -> Self {
        Met { wide: one.wide, zero: R::splat(token, one.zero) }
    }
}

impl Kernel for MollerTrumboreInF64 {
    const ABOUT: About = About {
        id: "moller-trumbore-in-f64",
        name: "Möller-Trumbore in f64",
        ..MollerTrumbore::ABOUT
    };
    type Record<E: Element> = [E; 9];
    type Met<R: Real> = Met<R>;
    /// The wide ray; its t_max is not read.
    type Aim<R: Real> = Ray<Wide<R>>;

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 9] {
        corners.numbers()
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Met<T> {
        let Corners { a, b, c } = Corners::read(stored, 0);
        let corners = Corners { a: wide_ray(a), b: wide_ray(b), c: wide_ray(c) };
        Met { wide: moller_trumbore::Met::of(&corners), zero: a.x().zero() }
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(ray: &Ray<R>) -> Ray<Wide<R>> {
        Ray {
            origin: wide_ray(ray.origin),
            direction: wide_ray(ray.direction),
            end: wide_ray(ray.end),
            t_min: only(ray.t_min).widened(),
            t_max: Wide::<R>::ZERO,
        }
    }

    in_one_piece!();

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        aim: &Ray<Wide<R>>,
        tri: &Met<R>,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        let wide = Ray { t_max: only(ray.t_max).widened(), ..*aim };
        let found = MollerTrumbore::test::<P, Wide<R>>(&wide, &(), &tri.wide)?;
        Ok(Found {
            hit: R::mask(tri.zero.token(), found.hit),
            t: narrow(tri, found.t),
            u: narrow(tri, found.u),
            v: narrow(tri, found.v),
        })
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        let [x, y, z] = MollerTrumbore::normal::<P, Wide<R>>(&tri.wide).0;
        Vec3([narrow(tri, x), narrow(tri, y), narrow(tri, z)])
    }
}

#[inline(always)]
fn wide<E: Element>(v: Vec3<E>) -> Vec3<E::Wide> {
    Vec3([v.x().widened(), v.y().widened(), v.z().widened()])
}

#[inline(always)]
fn wide_ray<R: Real>(v: Vec3<R>) -> Vec3<Wide<R>> {
    wide(Vec3([only(v.x()), only(v.y()), only(v.z())]))
}

/// The one lane that there is.
#[inline(always)]
fn only<R: Real>(x: R) -> R::Element {
    let mut place = [R::Element::ZERO];
    x.store(&mut place);
    place[0]
}

#[inline(always)]
fn narrow<R: Real>(tri: &Met<R>, x: Wide<R>) -> R {
    tri.zero.like(R::Element::narrowed(x))
}

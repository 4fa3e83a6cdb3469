//! Signed areas: folklore; thesis H, 3.4.4.3.
//!
//! Formula: t = N . (a - o) / (N . d), P = o + t d; the weights of c, a, b are N . (AB x AP),
//! N . (BC x BP), N . (CA x CP), over N . N; with a unit N they are twice the areas of the parts.
//! Stored: the vertices and N: 12 numbers (48 bytes in f32). Operations of a hit: 41 x, 45 +-, 2 /.
//! `first` is about t: the weights are divided by N . N behind the test, which needs their signs only.
//! Known weakness: the same determinant as the perpendicular planes at twice their price; slivers
//! lose u and v twice.

use super::begun::in_one_piece;
use super::half_spaces::contains_shares;
use super::perpendicular_planes::point_on;
use super::stored::{plain_cross, with_normal};
use super::{About, Corners, Kernel, PointTest, Source};
use crate::number::{Element, Real, Vec3, spread};
use crate::policy::{Found, Miss, Policy, Ray, Scale};

/// See the module's text.
pub struct SignedAreas;

/// Corners and normal, in this order in the record.
#[derive(Clone, Copy)]
pub struct Met<R> {
    corners: Corners<R>,
    n: Vec3<R>,
}

spread!(Met { corners, n });

impl Kernel for SignedAreas {
    const ABOUT: About = About {
        id: "signed-areas",
        name: "Signed areas",
        year: 2008,
        source: "folklore; thesis H, 3.4.4.3",
        setup: "the normal",
        stored: "normal",
        watertight: false,
        codes: &["det is 0", "t outside", "on the outer side of an edge"],
    };
    type Record<E: Element> = [E; 12];
    type Met<R: Real> = Met<R>;
    type Aim<R: Real> = ();

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 12] {
        let (e1, e2) = corners.edges();
        with_normal(corners, plain_cross(e1, e2))
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Met<T> {
        Met { corners: Corners::read(stored, 0), n: stored.vector(9) }
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
        let (t, scale) = P::quotient(P::dot(tri.n, tri.corners.a - ray.origin), det);
        let hit = P::keep_range(hit, ray, t, scale, 2)?;
        let point = point_on::<P, R>(ray, t, scale);
        let (inside, u, v) = Self::contains::<P, R>(&point, tri)?;
        let one = Scale { factor: det.one(), one: det.one() };
        P::finish_apart(hit & inside, ray, (t, scale), ([u, v], one))
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.n
    }
}

impl PointTest for SignedAreas {
    #[inline(always)]
    fn contains<P: Policy, R: Real>(
        point: &Vec3<R>,
        tri: &Met<R>,
    ) -> Result<(R::Mask, R, R), Miss> {
        let Corners { a, b, c } = tri.corners;
        let sides = [
            area::<P, R>(tri.n, b, c, *point),
            area::<P, R>(tri.n, c, a, *point),
            area::<P, R>(tri.n, a, b, *point),
        ];
        contains_shares::<P, R>(sides, tri.n)
    }
}

/// N . ((to - from) x (p - from))
#[inline(always)]
fn area<P: Policy, R: Real>(n: Vec3<R>, from: Vec3<R>, to: Vec3<R>, p: Vec3<R>) -> R {
    P::dot(n, P::cross(to - from, p - from))
}

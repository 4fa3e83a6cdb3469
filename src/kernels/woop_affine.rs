//! Woop's affine transformation: S. Woop, "A Ray Tracing Hardware Architecture for Dynamic Scenes",
//! diploma thesis, Saarland University, 2004; T. Aila, S. Laine, "Understanding the Efficiency of Ray
//! Traversal on GPUs", High Performance Graphics, 2009.
//!
//! Formula: the transformation that takes the triangle to (0, 0, 0), (1, 0, 0), (0, 1, 0), with
//! n = AB x AC: rows X = (AC x n) / |n|^2, Y = (n x AB) / |n|^2, Z = n / |n|^2 and offsets -(row . a).
//! o' = M o + offset, d' = M d, t = -o'_z / d'_z, u = o'_x + t d'_x, v = o'_y + t d'_y.
//! The planes are those of Havel's perpendicular planes; only what is transformed differs.
//! Stored: 12 numbers (48 bytes in f32). Operations of a hit, divided first: 20 x, 18 +-, 1 unary
//! minus, 1 /; divided last 26 x.
//! Known weakness: the offsets cancel far from the origin; |n|^2 has degree 4, so it leaves the range
//! of f32 for triangles below 1e-10 and above 1e9.

use super::perpendicular_planes::planes;
use super::shares::{Known, known};
use super::stored::{plain_cross, plain_dot};
use super::{About, Begun, CommonOrigin, Corners, Kernel, Parallel, Shares, Source};
use crate::number::{Element, Real, Vec3, spread};
use crate::policy::{Found, Miss, Policy, Ray};

/// See the module's text.
pub struct WoopAffine;

/// A row of the transformation: three factors and the offset.
#[derive(Clone, Copy)]
pub struct Row<R> {
    factors: Vec3<R>,
    offset: R,
}

spread!(Row { factors, offset });

/// The row with these factors that takes vertex a to 0.
fn through<E: Element>(factors: Vec3<E>, corners: &Corners<E>) -> (Vec3<E>, E) {
    (factors, -plain_dot(factors, corners.a))
}

impl<R: Real> Row<R> {
    #[inline(always)]
    fn read<S: Source<R>>(stored: &S, place: usize) -> Self {
        Row { factors: stored.vector(place), offset: stored.number(place + 3) }
    }
    /// The component of the origin.
    #[inline(always)]
    fn of_origin<P: Policy>(&self, ray: &Ray<R>) -> R {
        P::dot(ray.origin, self.factors) + self.offset
    }
    /// The component of the direction.
    #[inline(always)]
    fn of_direction<P: Policy>(&self, ray: &Ray<R>) -> R {
        P::dot(ray.direction, self.factors)
    }
}

/// The rows, z first, as in the record: it decides first.
#[derive(Clone, Copy)]
pub struct Rows<R> {
    z: Row<R>,
    x: Row<R>,
    y: Row<R>,
}

spread!(Rows { z, x, y });

impl Kernel for WoopAffine {
    const ABOUT: About = About {
        id: "woop-affine",
        name: "Woop, affine transformation",
        year: 2004,
        source: "Woop, diploma thesis, Saarland University, 2004; Aila and Laine, HPG 2009",
        setup: "a transformation to the unit triangle",
        stored: "precomputed",
        watertight: false,
        codes: &["det is 0", "t outside", "u outside", "v or u + v outside"],
    };
    type Record<E: Element> = [E; 12];
    type Met<R: Real> = Rows<R>;
    type Aim<R: Real> = ();
    type Begun<R: Real> = Begun<R>;

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 12] {
        let (ab, ac) = corners.edges();
        let n = plain_cross(ab, ac);
        let inverse = E::ONE / plain_dot(n, n);
        planes([
            through(n.scaled(inverse), corners),
            through(plain_cross(ac, n).scaled(inverse), corners),
            through(plain_cross(n, ab).scaled(inverse), corners),
        ])
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Rows<T> {
        Rows::of(stored)
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    #[inline(always)]
    fn begin<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Rows<R>) -> Result<Begun<R>, Miss> {
        begin_knowing::<P, R>(ray, tri, Known::NOTHING)
    }

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Rows<R>,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        end_knowing::<P, R>(ray, tri, begun, Known::NOTHING)
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Rows<R>) -> Vec3<R> {
        tri.z.factors
    }
}

/// What follows from the origin: its place in the triangle's coordinates.
#[derive(Clone, Copy)]
struct FromOrigin<R> {
    x: R,
    y: R,
    z: R,
}

/// What follows from the direction: its components there and, divided last, the inverse of that of z.
#[derive(Clone, Copy)]
struct FromDirection<R> {
    x: R,
    y: R,
    z: R,
    inverse: R,
}

impl<R: Real> Rows<R> {
    #[inline(always)]
    fn of<S: Source<R>>(stored: &S) -> Self {
        Rows { z: Row::read(stored, 0), x: Row::read(stored, 4), y: Row::read(stored, 8) }
    }
    /// `z`, `x` and `y` in the places of the rows' own offsets.
    #[inline(always)]
    fn numbers(&self, [z, x, y]: [R; 3]) -> [R; 12] {
        let ([zx, zy, zz], [xx, xy, xz]) = (self.z.factors.0, self.x.factors.0);
        let [yx, yy, yz] = self.y.factors.0;
        [zx, zy, zz, z, xx, xy, xz, x, yx, yy, yz, y]
    }
}

/// The first part of the test, of which some is known.
#[inline(always)]
fn begin_knowing<P: Policy, R: Real>(
    ray: &Ray<R>,
    tri: &Rows<R>,
    known: Known<FromOrigin<R>, FromDirection<R>>,
) -> Result<Begun<R>, Miss> {
    let det = known!(known.direction.z, tri.z.of_direction::<P>(ray));
    let hit = P::keep(P::divisible(det), 1)?;
    let (t, scale) = P::quotient(-known!(known.origin.z, tri.z.of_origin::<P>(ray)), det);
    let hit = P::keep_range(hit, ray, t, scale, 2)?;
    let direction = known.direction;
    Ok(Begun::knowing::<P>(hit, t, scale, known!(direction.inverse)))
}

/// The rest of it.
#[inline(always)]
fn end_knowing<P: Policy, R: Real>(
    ray: &Ray<R>,
    tri: &Rows<R>,
    begun: &Begun<R>,
    known: Known<FromOrigin<R>, FromDirection<R>>,
) -> Result<Found<R>, Miss> {
    let Begun { hit, t, scale, .. } = *begun;
    let o = known!(known.origin.x, tri.x.of_origin::<P>(ray));
    let d = known!(known.direction.x, tri.x.of_direction::<P>(ray));
    let u = P::along(o, d, t, scale);
    let hit = P::keep(P::share(hit, u, scale), 3)?;
    let o = known!(known.origin.y, tri.y.of_origin::<P>(ray));
    let d = known!(known.direction.y, tri.y.of_direction::<P>(ray));
    let v = P::along(o, d, t, scale);
    let hit = P::keep(P::beside(hit, u, v, scale), 4)?;
    begun.finish::<P>(hit, ray, [t, u, v])
}

/// Of what is shared by rays with one origin.
#[inline(always)]
fn origin<R: Real>(tri: &Rows<R>) -> Known<FromOrigin<R>, FromDirection<R>> {
    let origin = FromOrigin { x: tri.x.offset, y: tri.y.offset, z: tri.z.offset };
    Known { origin: Some(origin), direction: None }
}

/// Of what is shared by rays with one direction.
#[inline(always)]
fn direction<R: Real, S: Source<R>>(shared: &S) -> Known<FromOrigin<R>, FromDirection<R>> {
    let (z, inverse) = (shared.number(12), shared.number(15));
    let [x, y] = shared.pair(13);
    Known { origin: None, direction: Some(FromDirection { x, y, z, inverse }) }
}

impl Shares<CommonOrigin> for WoopAffine {
    /// The rows, with the origin's components in the places of the offsets.
    type Shared<R: Real> = [R; 12];
    type Begun<R: Real> = Begun<R>;

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Rows<R>) -> [R; 12] {
        let [z, x, y] = [&tri.z, &tri.x, &tri.y];
        tri.numbers([z.of_origin::<P>(ray), x.of_origin::<P>(ray), y.of_origin::<P>(ray)])
    }

    #[inline(always)]
    fn begin_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
    ) -> Result<Begun<R>, Miss> {
        let tri = Rows::of(shared);
        begin_knowing::<P, R>(ray, &tri, origin(&tri))
    }

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        let tri = Rows::of(shared);
        end_knowing::<P, R>(ray, &tri, begun, origin(&tri))
    }
}

impl Shares<Parallel> for WoopAffine {
    /// The rows, the direction's components and, divided last, the inverse of that of z.
    type Shared<R: Real> = [R; 16];
    type Begun<R: Real> = Begun<R>;

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Rows<R>) -> [R; 16] {
        let offsets = [tri.z.offset, tri.x.offset, tri.y.offset];
        let [zx, zy, zz, z, xx, xy, xz, x, yx, yy, yz, y] = tri.numbers(offsets);
        let det = tri.z.of_direction::<P>(ray);
        let (dx, dy) = (tri.x.of_direction::<P>(ray), tri.y.of_direction::<P>(ray));
        let inverse = P::inverse(P::divide(det));
        [zx, zy, zz, z, xx, xy, xz, x, yx, yy, yz, y, det, dx, dy, inverse]
    }

    #[inline(always)]
    fn begin_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
    ) -> Result<Begun<R>, Miss> {
        begin_knowing::<P, R>(ray, &Rows::of(shared), direction(shared))
    }

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        end_knowing::<P, R>(ray, &Rows::of(shared), begun, direction(shared))
    }
}

//! Baldwin-Weber: D. Baldwin, M. Weber, "Fast Ray-Triangle Intersections by Coordinate
//! Transformation", Journal of Computer Graphics Techniques 5(3), 2016: the form of 12 numbers.
//!
//! Formula: three rows of a 3 x 4 matrix take a point to its weights of b and c and its distance from
//! the plane. Along the axis k of n's largest component, (p, q) the next two in the cycle:
//! B_p = e2_q / n_k, B_q = -e2_p / n_k, B_k = 0; C_p = -e1_q / n_k, C_q = e1_p / n_k, C_k = 0;
//! N = n / n_k. t = -(N . o + N_4) / (N . d), P = o + t d, u = B . P + B_4, v = C . P + C_4.
//! The fourth column as published is made of positions: B_4 = (c x a)_k / n_k,
//! C_4 = -(b x a)_k / n_k, N_4 = -(n . a) / n_k; `stored=row-offsets` has -(row . a), which is the same
//! in exact arithmetic and cancels less.
//! Stored: 12 numbers (48 bytes in f32); B_k and C_k are zeros with the sign of n_k, which costs
//! nothing and keeps the side of the normal. Operations of a hit, divided first: 15 x, 15 +-, 1 unary
//! minus, 1 /; divided last 24 x.
//! Known weakness: the plane's constant cancels far from the origin, and the published column with the
//! square of the offset. Where coordinates across axis k are about L, each of its two products rounds by
//! up to u L^2, so B_4 and C_4 are off by up to 2 u L^2 / |n_k|; what roundings of the corners do to u and
//! v is about u L / sqrt |n_k|. That is L / sqrt |n_k| times too much, for triangles that are small beside
//! their coordinates, even if nothing is steep or thin. In f32, a landscape over a square of side 2 with
//! 317 squares a side has outputs that are off by 88 condition numbers times u, beyond the 64 that are
//! excused: such a search is a `wrong-result`, in every drive, because drives share the record. With
//! `row-offsets`, whose error is about u L |B|, the same in kind as that of the corners, they are within 3.

use std::marker::PhantomData;

use super::perpendicular_planes::{planes, point_on, share};
use super::shevtsov::cycle;
use super::stored::{plain_cross, plain_dot};
use super::{About, Begun, Corners, Kernel, Source};
use crate::number::{Axis, Element, Real, Vec3, dominant, spread};
use crate::policy::{Found, Miss, Policy, Ray};

/// See the module's text. `C` says how the fourth column is made.
pub struct BaldwinWeber<C>(PhantomData<C>);

/// The fourth column as published, from positions.
pub struct FromPositions;
/// The fourth column as what brings vertex a to 0.
pub struct FromRows;

/// How the fourth column is made.
pub trait Column: 'static {
    /// The column `stored`.
    const NAME: &'static str;
    /// What is prepared, in words.
    const SETUP: &'static str;
    /// It is the published one.
    const AS_PUBLISHED: bool;
    /// The fourth numbers of `rows`; k and the two axes behind it, and n_k.
    fn offsets<E: Element>(
        rows: &[Vec3<E>; 3],
        corners: &Corners<E>,
        axes: [usize; 3],
        n: Vec3<E>,
    ) -> [E; 3];
}

impl Column for FromPositions {
    const NAME: &'static str = "precomputed";
    const SETUP: &'static str = "a matrix into the triangle's own coordinates";
    const AS_PUBLISHED: bool = true;
    fn offsets<E: Element>(
        _: &[Vec3<E>; 3],
        corners: &Corners<E>,
        [k, p, q]: [usize; 3],
        n: Vec3<E>,
    ) -> [E; 3] {
        let Corners { a, b, c } = corners;
        let turn = |from: &Vec3<E>| from.0[p] * a.0[q] - from.0[q] * a.0[p];
        [turn(c) / n.0[k], -turn(b) / n.0[k], -plain_dot(n, *a) / n.0[k]]
    }
}

impl Column for FromRows {
    const NAME: &'static str = "row-offsets";
    const SETUP: &'static str =
        "a matrix into the triangle's own coordinates, offsets from its rows";
    const AS_PUBLISHED: bool = false;
    fn offsets<E: Element>(
        rows: &[Vec3<E>; 3],
        corners: &Corners<E>,
        _: [usize; 3],
        _: Vec3<E>,
    ) -> [E; 3] {
        rows.map(|row| -plain_dot(row, corners.a))
    }
}

/// The rows for b, c and the plane, in this order in the record.
#[derive(Clone, Copy)]
pub struct Matrix<R> {
    b: Vec3<R>,
    b_offset: R,
    c: Vec3<R>,
    c_offset: R,
    n: Vec3<R>,
    n_offset: R,
}

spread!(Matrix { b, b_offset, c, c_offset, n, n_offset });

impl<C: Column> Kernel for BaldwinWeber<C> {
    const ABOUT: About = About {
        id: "baldwin-weber",
        name: "Baldwin-Weber",
        year: 2016,
        source: "Baldwin and Weber, Journal of Computer Graphics Techniques 5(3), 2016",
        setup: C::SETUP,
        stored: C::NAME,
        watertight: false,
        codes: &["det is 0", "t outside", "u outside", "v or u + v outside"],
    };
    type Record<E: Element> = [E; 12];
    type Met<R: Real> = Matrix<R>;
    type Aim<R: Real> = ();
    type Begun<R: Real> = Begun<R>;

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 12] {
        let (e1, e2) = corners.edges();
        let n = plain_cross(e1, e2);
        let axes @ [k, p, q] = cycle(dominant(n));
        let nk = n.0[k];
        let zero = E::ZERO.signed_by(nk);
        let (mut b, mut c, mut plane) = (Vec3([zero; 3]), Vec3([zero; 3]), Vec3([E::ONE; 3]));
        (b.0[p], b.0[q]) = (e2.0[q] / nk, -e2.0[p] / nk);
        (c.0[p], c.0[q]) = (-e1.0[q] / nk, e1.0[p] / nk);
        (plane.0[p], plane.0[q]) = (n.0[p] / nk, n.0[q] / nk);
        let [b_offset, c_offset, n_offset] = C::offsets(&[b, c, plane], corners, axes, n);
        planes([(b, b_offset), (c, c_offset), (plane, n_offset)])
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Matrix<T> {
        Matrix {
            b: stored.vector(0),
            b_offset: stored.number(3),
            c: stored.vector(4),
            c_offset: stored.number(7),
            n: stored.vector(8),
            n_offset: stored.number(11),
        }
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    #[inline(always)]
    fn begin<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Matrix<R>) -> Result<Begun<R>, Miss> {
        let det = P::dot(ray.direction, tri.n);
        let hit = P::keep(P::divisible(det), 1)?;
        let (t, scale) = P::quotient(-(P::dot(ray.origin, tri.n) + tri.n_offset), det);
        let hit = P::keep_range(hit, ray, t, scale, 2)?;
        Ok(Begun::new::<P>(hit, t, scale))
    }

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Matrix<R>,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        let Begun { hit, t, scale, .. } = *begun;
        let point = point_on::<P, R>(ray, t, scale);
        let u = share::<P, R>(point, tri.b, tri.b_offset, scale);
        let hit = P::keep(P::share(hit, u, scale), 3)?;
        let v = share::<P, R>(point, tri.c, tri.c_offset, scale);
        let hit = P::keep(P::beside(hit, u, v, scale), 4)?;
        begun.finish::<P>(hit, ray, [t, u, v])
    }

    /// n / |n_k|: the axis k is the one where both other rows are 0, and their zeros have its sign.
    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Matrix<R>) -> Vec3<R> {
        let zero = tri.b_offset.zero();
        let is_x = !(tri.b.x().ne(zero) | tri.c.x().ne(zero));
        let is_y = !(tri.b.y().ne(zero) | tri.c.y().ne(zero));
        let sign = Axis::Lanes(is_x, is_y).pick(&tri.b);
        Vec3([tri.n.x().signed_by(sign), tri.n.y().signed_by(sign), tri.n.z().signed_by(sign)])
    }
}

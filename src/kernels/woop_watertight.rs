//! Woop-Benthin-Wald: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", Journal
//! of Computer Graphics Techniques 2(1), 2013.
//!
//! Formula, per ray: along the axis z of d's largest component, (x, y) the next two in the cycle,
//! the shear s = (d_x, d_y, 1) / d_z. Per triangle, with the vertices relative to o: every vertex p
//! is sheared to p' = (p_x - s_x p_z, p_y - s_y p_z), so that the ray becomes the z axis; the edge
//! functions U = c'_x b'_y - c'_y b'_x, V = a'_x c'_y - a'_y c'_x, W = b'_x a'_y - b'_y a'_x are the
//! weights of a, b and c; inside none is negative, or none positive; det = U + V + W,
//! t = (U s_z a_z + V s_z b_z + W s_z c_z) / det. What is reported: u = V / det, v = W / det.
//! Each vertex is sheared the same in every triangle that has it, and the signs of the edge
//! functions are kept exact ([`super::edges`], the axis `edges`), so a ray cannot slip between two
//! triangles. The swap of x and y for negative d_z, which keeps the winding, is left out: it turns
//! the signs of U, V, W and det together. p' is computed with its sign turned, which turns no product.
//! `rounding=plain` is watertight. `fused` fuses the edge functions too, and leaks, but with
//! `edges=exact-sign`.
//! Stored: 9 numbers (36 bytes in f32). Prepared per ray: an axis, the origin along it, 3 /.
//! Operations of a hit, divided first, without what is prepared: 21 x, 22 +-, 1 /; divided last 22 x.
//! `exact-sign` costs 30 x and 45 +- more (fused 6 x and 9 +-), and so does the fallback where it is taken.
//! Known weakness: det of triangles smaller than 1e-19 is subnormal in f32, and divided last they are
//! lost; so is everything for directions below 1e-38, where s_z overflows. What is exact is the
//! inside of the sheared vertices, which are rounded: a hit may be off by that.

use std::marker::PhantomData;

use super::begun::in_one_piece;
use super::shares::shared_in_one_piece;
use super::{About, CommonOrigin, Corners, Edges, Kernel, Shares, Source};
use crate::number::{Axis, Element, Real, Vec3};
use crate::policy::{Found, Miss, Policy, Ray, Rounding};

/// See the module's text. `E` says how the edge functions are computed.
pub struct WoopWatertight<E>(PhantomData<E>);

/// The ray's axis z, the origin along (x, y, z), and the shear.
#[derive(Clone, Copy)]
pub struct Aim<R: Real> {
    z: Axis<R::Mask>,
    origin: [R; 3],
    shear: [R; 3],
}

impl<R: Real> Aim<R> {
    /// A vertex relative to the origin, along (x, y, z).
    #[inline(always)]
    fn seen(&self, vertex: &Vec3<R>) -> [R; 3] {
        let [x, y, z] = self.turned(vertex);
        [x - self.origin[0], y - self.origin[1], z - self.origin[2]]
    }
    /// A vector along (x, y, z).
    #[inline(always)]
    fn turned(&self, vector: &Vec3<R>) -> [R; 3] {
        let (x, y) = (self.z.next(), self.z.next().next());
        [x.pick(vector), y.pick(vector), self.z.pick(vector)]
    }
    /// Sheared: (-x', -y'), and z in units of t.
    #[inline(always)]
    fn sheared<P: Policy>(&self, p: [R; 3]) -> ([R; 2], R) {
        let across = [
            P::Rounding::multiply_subtract(self.shear[0], p[2], p[0]),
            P::Rounding::multiply_subtract(self.shear[1], p[2], p[1]),
        ];
        (across, self.shear[2] * p[2])
    }
}

impl<E: Edges> Kernel for WoopWatertight<E> {
    const ABOUT: About = About {
        id: "woop-watertight",
        name: "Woop-Benthin-Wald, watertight",
        year: 2013,
        source: "Woop, Benthin and Wald, Journal of Computer Graphics Techniques 2(1), 2013",
        setup: "none: three vertices",
        stored: "vertices",
        watertight: true,
        codes: &["on different sides of two edges, or det is 0", "t outside"],
    };
    type Record<T: Element> = [T; 9];
    type Met<R: Real> = Corners<R>;
    type Aim<R: Real> = Aim<R>;

    fn prepare<T: Element>(corners: &Corners<T>) -> [T; 9] {
        corners.numbers()
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Corners<T> {
        Corners::read(stored, 0)
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(ray: &Ray<R>) -> Aim<R> {
        let (o, d) = (&ray.origin, &ray.direction);
        let z = Axis::largest(d);
        let (x, y) = (z.next(), z.next().next());
        // 0 for a direction of no length: the shear is no number then, and no test passes.
        let along = z.pick(d);
        Aim {
            z,
            origin: [x.pick(o), y.pick(o), z.pick(o)],
            shear: [x.pick(d) / along, y.pick(d) / along, along.one() / along],
        }
    }

    in_one_piece!();

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        aim: &Aim<R>,
        tri: &Corners<R>,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        test_seen::<E, P, R>(ray, aim, [aim.seen(&tri.a), aim.seen(&tri.b), aim.seen(&tri.c)])
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Corners<R>) -> Vec3<R> {
        let (e1, e2) = tri.edges();
        P::cross(e1, e2)
    }
}

/// The test of three corners relative to the origin, along the ray's axes.
#[inline(always)]
fn test_seen<E: Edges, P: Policy, R: Real>(
    ray: &Ray<R>,
    aim: &Aim<R>,
    [a, b, c]: [[R; 3]; 3],
) -> Result<Found<R>, Miss> {
    let ((a, az), (b, bz), (c, cz)) =
        (aim.sheared::<P>(a), aim.sheared::<P>(b), aim.sheared::<P>(c));
    let [wa, wb, wc] = E::functions::<P, R>([a, b, c]);
    let zero = wa.zero();
    let inside =
        (wa.ge(zero) & wb.ge(zero) & wc.ge(zero)) | (wa.le(zero) & wb.le(zero) & wc.le(zero));
    let det = wa + wb + wc;
    let hit = P::keep(inside & P::divisible(det) & P::finite(det), 1)?;
    let scale = P::divide(det);
    let depth = P::multiply_add(wc, cz, P::multiply_add(wb, bz, wa * az));
    let t = P::signed(depth, scale);
    let hit = P::keep_range(hit, ray, t, scale, 2)?;
    P::finish(hit, ray, [t, P::signed(wb, scale), P::signed(wc, scale)], scale)
}

impl<E: Edges> Shares<CommonOrigin> for WoopWatertight<E> {
    /// The corners relative to the origin: each ray has axes of its own to see them along.
    type Shared<R: Real> = [R; 9];

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Corners<R>) -> [R; 9] {
        let o = ray.origin;
        let ([ax, ay, az], [bx, by, bz]) = ((tri.a - o).0, (tri.b - o).0);
        let [cx, cy, cz] = (tri.c - o).0;
        [ax, ay, az, bx, by, bz, cx, cy, cz]
    }

    shared_in_one_piece!();

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        aim: &Aim<R>,
        shared: &S,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        let Corners { a, b, c } = Corners::read(shared, 0);
        test_seen::<E, P, R>(ray, aim, [aim.turned(&a), aim.turned(&b), aim.turned(&c)])
    }
}

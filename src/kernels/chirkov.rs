//! Chirkov: N. Chirkov, "Fast 3D Line Segment-Triangle Intersection Test", Journal of Graphics
//! Tools 10(3), 2005; thesis B, 4.5.3, whose listing (a line test) is in [`super::listings`].
//!
//! Formula, with n = AB x AC and the plane's distances p = n . o - n . a of the origin and
//! q = n . end - n . a of the end: the segment crosses the plane where p and q do not have the same
//! sign. Along n's largest component, (y, z) the next two axes in the cycle, with dd = p - q and
//! s = end - o: f(e, from) = p (e_y s_z - e_z s_y) + dd (e_y r_z - e_z r_y), r = o - from. The
//! three values of f for AB, AC and BC have signs (+, -, +) or (-, +, -) inside.
//! v = f_AB / (dd n_w), u = -f_AC / (dd n_w), t = -p / (d . n).
//! `tests=products` is the published comparison of two products with >= and <; `compare` asks for
//! all three signs and obeys the law on boundaries.
//! Stored: the vertices, n, n . a and the axis: 14 words (56 bytes in f32; the paper's record has 64).
//! Operations of a hit: 32 x, 39 +-, 2 unary minuses, 2 /.
//! Known weakness: f has degree 6 in the size of the triangle, so it leaves the range of f32 first.

use super::stored::{plain_cross, plain_dot};
use super::{About, Corners, Kernel};
use crate::number::{Axis, Element, Real, Vec3, dominant};
use crate::policy::{Found, Miss, Policy, Ray, Scale, Tests};

/// See the module's text. Judged on (origin, end); the range of t is that of the segment and t_max.
pub struct Chirkov;

/// Corners, plane and axis.
#[derive(Clone, Copy)]
pub struct Record<R> {
    corners: Corners<R>,
    n: Vec3<R>,
    nd: R,
    w: u32,
}

impl Kernel for Chirkov {
    const ABOUT: About = About {
        id: "chirkov",
        name: "Chirkov, segment",
        year: 2005,
        source: "Chirkov, Journal of Graphics Tools 10(3), 2005",
        setup: "plane and axis",
        stored: "precomputed",
        watertight: false,
        codes: &["the segment does not cross the plane", "outside an edge", "t outside"],
    };
    type Record<E: Element> = Record<E>;
    type Met<R: Real> = Record<R>;

    fn prepare<E: Element>(corners: &Corners<E>) -> Record<E> {
        let (e1, e2) = corners.edges();
        let n = plain_cross(e1, e2);
        Record { corners: *corners, n, nd: plain_dot(n, corners.a), w: dominant(n) }
    }

    #[inline(always)]
    fn meet<P: Policy, R: Real>(token: R::Token, record: &Record<R::Element>) -> Record<R> {
        Record {
            corners: Corners::splat(token, &record.corners),
            n: Vec3::splat(token, record.n),
            nd: R::splat(token, record.nd),
            w: record.w,
        }
    }

    #[inline(always)]
    fn test<P: Policy, R: Real>(ray: &Ray<R>, tri: &Record<R>) -> Result<Found<R>, Miss> {
        let zero = tri.nd.zero();
        let p = P::dot(tri.n, ray.origin) - tri.nd;
        let q = P::dot(tri.n, ray.end) - tri.nd;
        let dd = p - q;
        let apart = (p.ge(zero) & q.le(zero)) | (p.le(zero) & q.ge(zero));
        let hit = P::keep(apart & dd.ne(zero), 1)?;

        let y = Axis::<R::Mask>::stored(tri.w).next();
        let z = y.next();
        let line = Line { y, z, p, dd, s: ray.end - ray.origin };
        let Corners { a, b, c } = tri.corners;
        let ab = line.side::<P>(b - a, ray.origin - a);
        let ac = line.side::<P>(c - a, ray.origin - a);
        let bc = line.side::<P>(c - b, ray.origin - b);
        let inside = if P::Tests::PRODUCTS {
            // The listing has the other sign for AC and BC, hence <= here for its >= and > for its <.
            (ab * ac).le(zero) & (ab * bc).gt(zero)
        } else {
            (ab.ge(zero) & ac.le(zero) & bc.ge(zero)) | (ab.le(zero) & ac.ge(zero) & bc.le(zero))
        };
        let hit = P::keep(hit & inside, 2)?;

        let (t, t_scale) = P::quotient(-p, P::dot(ray.direction, tri.n));
        let hit = P::keep_range(hit, ray, t, t_scale, 3)?;
        let w = Axis::<R::Mask>::stored(tri.w);
        let area = dd * w.pick(&tri.n);
        P::finish_apart(hit, ray, (t, t_scale), ([-ac, ab], Scale { factor: area, one: area }))
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Record<R>) -> Vec3<R> {
        tri.n
    }
}

/// What the three edges share: two axes, the origin's distance, that of origin and end, and the
/// segment.
struct Line<R: Real> {
    y: Axis<R::Mask>,
    z: Axis<R::Mask>,
    p: R,
    dd: R,
    s: Vec3<R>,
}

impl<R: Real> Line<R> {
    /// f of the module's text; `r` is the origin seen from a point of the edge.
    #[inline(always)]
    fn side<P: Policy>(&self, edge: Vec3<R>, r: Vec3<R>) -> R {
        let (ey, ez) = (self.y.pick(&edge), self.z.pick(&edge));
        let turn = P::difference(ey, self.z.pick(&self.s), ez, self.y.pick(&self.s));
        let base = P::difference(ey, self.z.pick(&r), ez, self.y.pick(&r));
        P::multiply_add(self.p, turn, self.dd * base)
    }
}

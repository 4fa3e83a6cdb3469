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
//! Operations of a hit: 32 x, 30 +-, 2 unary minuses, 2 /.
//! Known weakness: f has degree 6 in the size of the triangle, so it leaves the range of f32 first.

use super::begun::in_one_piece;
use super::stored::{plain_cross, with_plane};
use super::{About, Corners, Kernel, Source};
use crate::number::{Axis, Element, Real, Vec3, spread};
use crate::policy::{Found, Miss, Policy, Ray, Scale, Tests};

/// See the module's text. Judged on (origin, end); the range of t is that of the segment and t_max.
pub struct Chirkov;

/// What the test needs along y and z. The record is corners, n, n . a and the axis x.
#[derive(Clone, Copy)]
pub struct Met<R: Real> {
    y: Axis<R::Mask>,
    n: Vec3<R>,
    nd: R,
    nw: R,
    a: [R; 2],
    b: [R; 2],
    ab: [R; 2],
    ac: [R; 2],
    bc: [R; 2],
}

spread!(Met { y, n, nd, nw, a, b, ab, ac, bc });

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
        // Picking before broadcasting: the axis is the triangle's, and a component of a vector that
        // is computed in a test would have to go through memory.
        let (n, w) = (stored.vector(9), stored.axis(13));
        let (y, z) = (w.next(), w.next().next());
        let Corners { a, b, c } = &Corners::read(stored, 0);
        let [a, b, c] = [[y.pick(a), z.pick(a)], [y.pick(b), z.pick(b)], [y.pick(c), z.pick(c)]];
        Met {
            y,
            n,
            nd: stored.number(12),
            nw: w.pick(&n),
            a,
            b,
            ab: between(a, b),
            ac: between(a, c),
            bc: between(b, c),
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
        let zero = tri.nd.zero();
        let p = P::dot(tri.n, ray.origin) - tri.nd;
        let q = P::dot(tri.n, ray.end) - tri.nd;
        let dd = p - q;
        let apart = (p.ge(zero) & q.le(zero)) | (p.le(zero) & q.ge(zero));
        let hit = P::keep(apart & dd.ne(zero), 1)?;

        let (y, z) = (tri.y, tri.y.next());
        let o = [y.pick(&ray.origin), z.pick(&ray.origin)];
        let line = Line { p, dd, s: between(o, [y.pick(&ray.end), z.pick(&ray.end)]) };
        let from_a = between(tri.a, o);
        let ab = line.side::<P>(tri.ab, from_a);
        let ac = line.side::<P>(tri.ac, from_a);
        let bc = line.side::<P>(tri.bc, between(tri.b, o));
        let inside = if P::Tests::PRODUCTS {
            // The listing has the other sign for AC and BC, hence <= here for its >= and > for its <.
            (ab * ac).le(zero) & (ab * bc).gt(zero)
        } else {
            (ab.ge(zero) & ac.le(zero) & bc.ge(zero)) | (ab.le(zero) & ac.ge(zero) & bc.le(zero))
        };
        let hit = P::keep(hit & inside, 2)?;

        let (t, t_scale) = P::quotient(-p, P::dot(ray.direction, tri.n));
        let hit = P::keep_range(hit, ray, t, t_scale, 3)?;
        let area = dd * tri.nw;
        let area = Scale { factor: area, one: area };
        let mut found = P::finish_apart(hit, ray, (t, t_scale), ([-ac, ab], area))?;
        if !P::Tests::AS_PUBLISHED {
            // The numerators are not computed from the area, so it does not bound them.
            found.hit = found.hit & P::finite(found.u) & P::finite(found.v);
        }
        Ok(found)
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.n
    }
}

/// From one point to another, along two axes.
#[inline(always)]
fn between<R: Real>(from: [R; 2], to: [R; 2]) -> [R; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

/// What the three edges share: the origin's distance, that of origin and end, and the segment
/// along y and z.
struct Line<R: Real> {
    p: R,
    dd: R,
    s: [R; 2],
}

impl<R: Real> Line<R> {
    /// f of the module's text; `r` is the origin seen from a point of the edge.
    #[inline(always)]
    fn side<P: Policy>(&self, [ey, ez]: [R; 2], [ry, rz]: [R; 2]) -> R {
        let turn = P::difference(ey, self.s[1], ez, self.s[0]);
        let base = P::difference(ey, rz, ez, ry);
        P::multiply_add(self.p, turn, self.dd * base)
    }
}

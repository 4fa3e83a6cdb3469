//! Half-spaces: folklore; M. Segura, F. Feito, 1998; thesis H, 3.4.4.2, which names the two planes
//! through an edge that are of use: the one through the ray's origin, and the one perpendicular to
//! the triangle. Rays are tested with the first, points of the plane with the second.
//!
//! Formula, all vertices relative to the origin: the weights of a, b, c are d . (b x c),
//! d . (c x a), d . (a x b); inside they have one sign; their sum is d . n; t = n . a / (d . n).
//! A point q: weight of c is ((n x AB) . (q - a)) / n . n, and so on round the triangle.
//! Stored: 9 numbers. Operations of a hit: 37 x, 30 +-, 2 /, and per packet 6 x, 9 -.
//! Known weakness: a x b cancels with the square of the distance between origin and triangle.

use super::begun::in_one_piece;
use super::shares::shared_in_one_piece;
use super::{About, CommonOrigin, Corners, Kernel, PointTest, Shares, Source};
use crate::number::{Element, Real, Vec3, spread};
use crate::policy::{Division, Found, Last, Miss, Policy, Ray, Scale};

/// See the module's text.
pub struct HalfSpaces;

/// The corners and the normal, in lanes.
#[derive(Clone, Copy)]
pub struct Met<R> {
    corners: Corners<R>,
    n: Vec3<R>,
}

spread!(Met { corners, n });

impl Kernel for HalfSpaces {
    const ABOUT: About = About {
        id: "half-spaces",
        name: "Half-spaces",
        year: 2008,
        source: "folklore; thesis H, 3.4.4.2",
        setup: "none: three vertices",
        stored: "vertices",
        watertight: false,
        codes: &["on different sides of two edges, or det is 0", "t outside"],
    };
    type Record<E: Element> = [E; 9];
    type Met<R: Real> = Met<R>;
    type Aim<R: Real> = ();

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 9] {
        corners.numbers()
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Met<T> {
        let corners = Corners::read(stored, 0);
        let (e1, e2) = corners.edges();
        Met { corners, n: P::cross(e1, e2) }
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
        Seen::of::<P>(ray, tri).test::<P>(ray)
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.n
    }
}

/// The triangle as seen from the origin: the normals of the planes through it and the edges opposite
/// to a, b and c, that of the triangle, and how far the triangle's plane is.
#[derive(Clone, Copy)]
struct Seen<R> {
    sides: [Vec3<R>; 3],
    n: Vec3<R>,
    depth: Depth<R>,
}

/// n . (a - o): a common origin has it, others compute it when a test comes so far.
#[derive(Clone, Copy)]
pub enum Depth<R> {
    /// The number.
    Known(R),
    /// a - o.
    To(Vec3<R>),
}

impl<R: Real> Depth<R> {
    /// The number, by the normal `n`.
    #[inline(always)]
    pub fn along<P: Policy>(self, n: Vec3<R>) -> R {
        match self {
            Depth::Known(depth) => depth,
            Depth::To(oa) => P::dot(n, oa),
        }
    }
}

impl<R: Real> Seen<R> {
    #[inline(always)]
    fn of<P: Policy>(ray: &Ray<R>, tri: &Met<R>) -> Self {
        let Corners { a, b, c } = tri.corners;
        let (a, b, c) = (a - ray.origin, b - ray.origin, c - ray.origin);
        let sides = [P::cross(b, c), P::cross(c, a), P::cross(a, b)];
        Seen { sides, n: tri.n, depth: Depth::To(a) }
    }
    #[inline(always)]
    fn test<P: Policy>(&self, ray: &Ray<R>) -> Result<Found<R>, Miss> {
        let [a, b, c] = self.sides;
        let d = ray.direction;
        let sides = [P::dot(d, a), P::dot(d, b), P::dot(d, c)];
        finish_sides::<P, R>(ray, sides, self.n, self.depth)
    }
}

impl Shares<CommonOrigin> for HalfSpaces {
    /// Three sides, the normal, and the distance of the plane.
    type Shared<R: Real> = [R; 13];

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Met<R>) -> [R; 13] {
        let Seen { sides: [a, b, c], n, depth } = Seen::of::<P>(ray, tri);
        let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a.0, b.0, c.0);
        let [nx, ny, nz] = n.0;
        [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz, depth.along::<P>(n)]
    }

    shared_in_one_piece!();

    #[inline(always)]
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        (): &(),
        shared: &S,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        let sides = [shared.vector(0), shared.vector(3), shared.vector(6)];
        let depth = Depth::Known(shared.number(12));
        Seen { sides, n: shared.vector(9), depth }.test::<P>(ray)
    }
}

impl PointTest for HalfSpaces {
    #[inline(always)]
    fn contains<P: Policy, R: Real>(
        point: &Vec3<R>,
        tri: &Met<R>,
    ) -> Result<(R::Mask, R, R), Miss> {
        let Corners { a, b, c } = tri.corners;
        let sides = [
            height::<P, R>(tri.n, b, c, *point),
            height::<P, R>(tri.n, c, a, *point),
            height::<P, R>(tri.n, a, b, *point),
        ];
        contains_shares::<P, R>(sides, tri.n)
    }
}

/// How far `p` is above the plane through an edge, perpendicular to the triangle, times its normal.
#[inline(always)]
fn height<P: Policy, R: Real>(n: Vec3<R>, from: Vec3<R>, to: Vec3<R>, p: Vec3<R>) -> R {
    P::dot(P::cross(n, to - from), p - from)
}

/// The test by the signs of three weights, whose sum is d . n, and t from the plane.
#[inline(always)]
pub fn finish_sides<P: Policy, R: Real>(
    ray: &Ray<R>,
    [wa, wb, wc]: [R; 3],
    n: Vec3<R>,
    depth: Depth<R>,
) -> Result<Found<R>, Miss> {
    let (zero, sum) = (wa.zero(), wa + wb + wc);
    let all = (wa.ge(zero) & wb.ge(zero) & wc.ge(zero)) | (wa.le(zero) & wb.le(zero) & wc.le(zero));
    let hit = P::keep(all & P::divisible(sum), 1)?;
    let det = P::dot(ray.direction, n);
    let (t, t_scale) = P::quotient(depth.along::<P>(n), det);
    let hit = P::keep_range(hit & P::divisible(det), ray, t, t_scale, 2)?;
    P::finish_apart(hit, ray, (t, t_scale), ([wb, wc], Scale { factor: sum, one: sum }))
}

/// A point's weights times n . n, which is positive: inside where none is negative.
#[inline(always)]
pub fn contains_shares<P: Policy, R: Real>(
    [wa, wb, wc]: [R; 3],
    n: Vec3<R>,
) -> Result<(R::Mask, R, R), Miss> {
    let zero = wa.zero();
    let area = P::dot(n, n);
    // Divided last in every form.
    let divisible = Last::divisible::<P, R>(area) & P::finite(area);
    let hit = P::keep(wa.ge(zero) & wb.ge(zero) & wc.ge(zero) & divisible, 3)?;
    let inverse = Last::inverse::<P, R>(Scale { factor: area, one: area });
    let (u, v) = (wb * inverse, wc * inverse);
    Ok((hit & P::finite(u) & P::finite(v), u, v))
}

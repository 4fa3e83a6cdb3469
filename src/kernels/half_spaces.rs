//! Half-spaces: folklore; M. Segura, F. Feito, 1998; thesis H, 3.4.4.2, which names the two planes
//! through an edge that are of use: the one through the ray's origin, and the one perpendicular to
//! the triangle. Rays are tested with the first, points of the plane with the second.
//!
//! Formula, all vertices relative to the origin: the weights of a, b, c are d . (b x c),
//! d . (c x a), d . (a x b); inside they have one sign; their sum is d . n; t = n . a / (d . n).
//! A point q: weight of c is ((n x AB) . (q - a)) / n . n, and so on round the triangle.
//! Stored: 9 numbers. Operations of a hit: 37 x, 30 +-, 2 /, and per packet 6 x, 9 -.
//! Known weakness: a x b cancels with the square of the distance between origin and triangle.

use super::{About, Corners, Kernel, PointTest, Source};
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

    #[inline(always)]
    fn test<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Met<R>) -> Result<Found<R>, Miss> {
        let (o, d) = (ray.origin, ray.direction);
        let (a, b, c) = (tri.corners.a - o, tri.corners.b - o, tri.corners.c - o);
        let sides =
            [P::dot(d, P::cross(b, c)), P::dot(d, P::cross(c, a)), P::dot(d, P::cross(a, b))];
        finish_sides::<P, R>(ray, sides, tri.n, a)
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.n
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
/// `oa` is a vertex as seen from the origin.
#[inline(always)]
pub fn finish_sides<P: Policy, R: Real>(
    ray: &Ray<R>,
    [wa, wb, wc]: [R; 3],
    n: Vec3<R>,
    oa: Vec3<R>,
) -> Result<Found<R>, Miss> {
    let (zero, sum) = (wa.zero(), wa + wb + wc);
    let all = (wa.ge(zero) & wb.ge(zero) & wc.ge(zero)) | (wa.le(zero) & wb.le(zero) & wc.le(zero));
    let hit = P::keep(all & P::divisible(sum), 1)?;
    let det = P::dot(ray.direction, n);
    let (t, t_scale) = P::quotient(P::dot(n, oa), det);
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
    let inverse = Last::inverse(Scale { factor: area, one: area });
    let (u, v) = (wb * inverse, wc * inverse);
    Ok((hit & P::finite(u) & P::finite(v), u, v))
}

//! Embree's Pluecker form, the one of its robust mode: C. Benthin, S. Woop and others, Embree,
//! kernels/geometry/triangle_intersector_pluecker.h (since 2012; the tolerance since 2018).
//!
//! Formula, all vertices relative to the origin: e0 = c - a, e1 = a - b, e2 = b - c;
//! U = (e0 x (c + a)) . d, V = (e1 x (a + b)) . d, W = (e2 x (b + c)) . d are the weights of b, c and
//! a; inside none is below -e, or none above e, with e = epsilon |U + V + W|. The normal is, component
//! by component, that of e0 x e1 and e1 x e2 whose second product is smaller; t = (a . n) / (d . n);
//! u = min(U / (U + V + W), 1), v likewise.
//! Embree doubles both terms of t, which changes no bit, and takes u = v = 0 where |U + V + W| is
//! below 1e-18, for its approximate reciprocal; here where it is subnormal.
//! Stored: 9 numbers (36 bytes in f32). Operations of a hit: 48 x, 54 +-, 1 unary minus, 2 /.
//! `first` is about t: the weights are divided behind the test, which needs their signs only.
//! Known weakness: shared edges are kept, but the tolerance depends on the triangle, so that a ray
//! through a vertex can pass between tiny ones; on edges it hits both.

use super::begun::in_one_piece;
use super::shares::shared_in_one_piece;
use super::{About, CommonOrigin, Corners, Kernel, Shares, Source};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Division, Exit, Found, Last, Miss, Policy, Ray, Rounding, Scale};

/// See the module's text.
pub struct EmbreePlucker;

impl Kernel for EmbreePlucker {
    const ABOUT: About = About {
        id: "embree-plucker",
        name: "Embree, Plücker form",
        year: 2012,
        source: "Embree, triangle_intersector_pluecker.h",
        setup: "none: three vertices",
        stored: "vertices",
        watertight: false,
        codes: &["the sides differ beyond the tolerance", "det is 0, or t outside"],
    };
    type Record<E: Element> = [E; 9];
    type Met<R: Real> = Corners<R>;
    type Aim<R: Real> = ();

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 9] {
        corners.numbers()
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Corners<T> {
        Corners::read(stored, 0)
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    in_one_piece!();

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Corners<R>,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        let seen = Seen::of(ray, tri);
        test_seen::<P, R>(ray, seen.sides::<P>(), Plane::Of(seen))
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Corners<R>) -> Vec3<R> {
        let (e1, e2) = tri.edges();
        P::cross(e1, e2)
    }
}

/// The corners as seen from the origin, and the edges e0, e1 and e2.
#[derive(Clone, Copy)]
struct Seen<R> {
    corners: Corners<R>,
    edges: [Vec3<R>; 3],
}

impl<R: Real> Seen<R> {
    #[inline(always)]
    fn of(ray: &Ray<R>, tri: &Corners<R>) -> Self {
        let o = ray.origin;
        let (a, b, c) = (tri.a - o, tri.b - o, tri.c - o);
        Seen { corners: Corners { a, b, c }, edges: [c - a, a - b, b - c] }
    }
    /// Twice the normals of the planes through the origin and an edge.
    #[inline(always)]
    fn sides<P: Policy>(&self) -> [Vec3<R>; 3] {
        let (Corners { a, b, c }, [e0, e1, e2]) = (self.corners, self.edges);
        [P::cross(e0, c + a), P::cross(e1, a + b), P::cross(e2, b + c)]
    }
    /// The triangle's plane: its normal, and a . n.
    #[inline(always)]
    fn plane<P: Policy>(&self) -> (Vec3<R>, R) {
        let [e0, e1, e2] = self.edges;
        let n = stable_normal::<P, R>(e0, e1, e2);
        (n, P::dot(n, self.corners.a))
    }
}

/// The triangle's plane: a common origin has it, others compute it when a test comes so far.
#[derive(Clone, Copy)]
enum Plane<R> {
    /// Normal, and a . n.
    Known(Vec3<R>, R),
    /// Of these corners.
    Of(Seen<R>),
}

#[inline(always)]
fn test_seen<P: Policy, R: Real>(
    ray: &Ray<R>,
    [u_side, v_side, w_side]: [Vec3<R>; 3],
    plane: Plane<R>,
) -> Result<Found<R>, Miss> {
    let d = ray.direction;
    let (u, v, w) = (P::dot(u_side, d), P::dot(v_side, d), P::dot(w_side, d));
    let sum = u + v + w;
    let above = sum.signed_by(sum) * sum.like(R::Element::EPSILON);
    let below = -above;
    let inside =
        (u.ge(below) & v.ge(below) & w.ge(below)) | (u.le(above) & v.le(above) & w.le(above));
    let hit = P::keep(inside, 1)?;

    let (n, depth) = match plane {
        Plane::Known(n, depth) => (n, depth),
        Plane::Of(seen) => seen.plane::<P>(),
    };
    let det = P::dot(n, d);
    let (t, scale) = P::quotient(depth, det);
    let hit = P::keep_range(hit & P::divisible(det), ray, t, scale, 2)?;
    let [u, v] = shares::<P, R>([u, v], sum);
    let one = Scale { factor: sum.one(), one: sum.one() };
    P::finish_apart(hit, ray, (t, scale), ([u, v], one))
}

impl Shares<CommonOrigin> for EmbreePlucker {
    /// Three sides, the normal and a . n.
    type Shared<R: Real> = [R; 13];

    #[inline(always)]
    fn share<P: Policy, R: Real>(ray: &Ray<R>, tri: &Corners<R>) -> [R; 13] {
        let seen = Seen::of(ray, tri);
        let [a, b, c] = seen.sides::<P>();
        let (n, depth) = seen.plane::<P>();
        let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a.0, b.0, c.0);
        let [nx, ny, nz] = n.0;
        [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz, depth]
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
        test_seen::<P, R>(ray, sides, Plane::Known(shared.vector(9), shared.number(12)))
    }
}

/// Both weights over their sum, at most 1.
#[inline(always)]
fn shares<P: Policy, R: Real>(weights: [R; 2], sum: R) -> [R; 2] {
    let inverse = Last::inverse::<P, R>(Scale { factor: sum, one: sum });
    let whole = Last::divisible::<P, R>(sum);
    let [inverse] = P::Exit::select(whole, [inverse], [sum.zero()]);
    let (u, v, one) = (weights[0] * inverse, weights[1] * inverse, sum.one());
    let [u] = P::Exit::select(u.lt(one), [u], [one]);
    let [v] = P::Exit::select(v.lt(one), [v], [one]);
    [u, v]
}

/// e0 x e1, or e1 x e2, which is the same vector: each component from where less cancels.
#[inline(always)]
fn stable_normal<P: Policy, R: Real>(e0: Vec3<R>, e1: Vec3<R>, e2: Vec3<R>) -> Vec3<R> {
    Vec3([
        steadier::<P, R>([e0.y(), e0.z()], [e1.y(), e1.z()], [e2.y(), e2.z()]),
        steadier::<P, R>([e0.z(), e0.x()], [e1.z(), e1.x()], [e2.z(), e2.x()]),
        steadier::<P, R>([e0.x(), e0.y()], [e1.x(), e1.y()], [e2.x(), e2.y()]),
    ])
}

/// p q's determinant, or q r's: that whose second product is smaller.
#[inline(always)]
fn steadier<P: Policy, R: Real>(p: [R; 2], q: [R; 2], r: [R; 2]) -> R {
    let (pq, qr) = (p[1] * q[0], q[1] * r[0]);
    let first = P::Rounding::multiply_subtract(p[0], q[1], pq);
    let second = P::Rounding::multiply_subtract(q[0], r[1], qr);
    let [chosen] = P::Exit::select(pq.signed_by(pq).lt(qr.signed_by(qr)), [first], [second]);
    chosen
}

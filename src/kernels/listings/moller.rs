//! The four published placements of the division in Moeller and Trumbore's test: T. Moeller,
//! raytri.c, May 2000 (variants 0 to 3); thesis B, 4.1 (0, 1 and 3) and 4.5.1 (1).
//!
//! Epsilon 1e-6 on det, no test of t. Variant 1 is thesis B's `moller`: the branch on the sign of
//! det comes first and the division last. 2 divides before the branch, 3 also computes q there.
//! Stored: 9 numbers (36 bytes in f32). Operations of a hit of variant 1, t only: 25 x, 9 +,
//! 15 -, 1 unary minus, 1 /, 4 conditions.
//! Known weakness: the epsilon loses millimetre triangles; a NaN of the origin is a hit, and in variant 0 every NaN is.

use super::{Listing, Returned, Script, epsilon};
use crate::kernels::{About, Corners};
use crate::number::{Element, Vec3};
use crate::policy::Ray;

/// Where the division stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placement {
    /// 0: as soon as det is known, every numerator is multiplied.
    AtOnce,
    /// 1: behind all tests.
    AtTheEnd,
    /// 2: before the branch on the sign of det.
    BeforeTheBranch,
    /// 3: as 2, and q before the branch, too.
    BeforeTheBranchWithQ,
}

impl Placement {
    /// The column `division`.
    pub const fn division(self) -> &'static str {
        match self {
            Placement::AtTheEnd => "last",
            _ => "first",
        }
    }
}

/// `moller0` to `moller3`.
pub struct Moller<const VARIANT: usize>;

impl<const VARIANT: usize> Moller<VARIANT> {
    const ID: &'static str = ["moller0", "moller1", "moller2", "moller3"][VARIANT];
    const PLACEMENT: Placement = [
        Placement::AtOnce,
        Placement::AtTheEnd,
        Placement::BeforeTheBranch,
        Placement::BeforeTheBranchWithQ,
    ][VARIANT];
}

impl<const VARIANT: usize> Listing for Moller<VARIANT> {
    const ABOUT: About = About {
        id: Self::ID,
        name: ["Möller 0", "Möller 1", "Möller 2", "Möller 3"][VARIANT],
        year: 2000,
        source: "Möller, raytri.c, 2000; thesis B, 4.1 and 4.5.1",
        setup: "none: three vertices",
        stored: "vertices",
        watertight: false,
        codes: &[
            "det > eps and u < 0 or u > det",
            "det > eps and v < 0 or u + v > det",
            "det < -eps and u > 0 or u < det",
            "det < -eps and v > 0 or u + v < det",
            "|det| <= eps",
        ],
    };
    type Record<E: Element> = Corners<E>;

    fn prepare<E: Element>(corners: &Corners<E>) -> Corners<E> {
        *corners
    }

    #[inline(always)]
    fn run<E: Element, S: Script, const UV: bool>(ray: &Ray<E>, tri: &Corners<E>) -> Returned<E> {
        let edge1 = S::difference(tri.b, tri.a);
        let edge2 = S::difference(tri.c, tri.a);
        let pvec = S::cross(ray.direction, edge2);
        let det = S::dot(edge1, pvec);
        match Self::PLACEMENT {
            Placement::AtOnce => at_once::<E, S>(ray, tri, [edge1, edge2, pvec], det),
            _ => Self::by_sign::<E, S, UV>(ray, tri, [edge1, edge2, pvec], det),
        }
    }
}

/// What a listing has found when it did not return.
const GO_ON: u8 = 0;

fn missed<E: Element>(code: u8) -> Returned<E> {
    (code, E::ZERO, E::ZERO, E::ZERO)
}

/// Variant 0. Its codes are numbered as variant 1's with det > eps.
#[inline(always)]
fn at_once<E: Element, S: Script>(
    ray: &Ray<E>,
    tri: &Corners<E>,
    [edge1, edge2, pvec]: [Vec3<E>; 3],
    det: E,
) -> Returned<E> {
    if S::condition::<E>(det.gt(-epsilon::<E>()) && det.lt(epsilon())) {
        return missed(5);
    }
    let inv_det = S::divide(E::ONE, det);
    let tvec = S::difference(ray.origin, tri.a);
    let u = S::dot(tvec, pvec) * inv_det;
    if S::condition::<E>(u.lt(E::ZERO) || u.gt(E::ONE)) {
        return missed(1);
    }
    let qvec = S::cross(tvec, edge1);
    let v = S::dot(ray.direction, qvec) * inv_det;
    if S::condition::<E>(v.lt(E::ZERO) || (u + v).gt(E::ONE)) {
        return missed(2);
    }
    (0, S::dot(edge2, qvec) * inv_det, u, v)
}

impl<const VARIANT: usize> Moller<VARIANT> {
    /// Variants 1 to 3: the tests stand in two branches by the sign of det.
    #[inline(always)]
    fn by_sign<E: Element, S: Script, const UV: bool>(
        ray: &Ray<E>,
        tri: &Corners<E>,
        [edge1, edge2, pvec]: [Vec3<E>; 3],
        det: E,
    ) -> Returned<E> {
        let early = Self::PLACEMENT != Placement::AtTheEnd;
        let with_q = Self::PLACEMENT == Placement::BeforeTheBranchWithQ;
        let mut tvec = tri.a;
        let (mut qvec, mut inv_det) = (tri.a, det);
        if early {
            tvec = S::difference(ray.origin, tri.a);
            inv_det = S::divide(E::ONE, det);
        }
        if with_q {
            qvec = S::cross(tvec, edge1);
        }
        let (u, v);
        // Variants 2 and 3 divide before this test, so det = 0 must, and does, miss here.
        if S::condition::<E>(det.gt(epsilon())) {
            if !early {
                tvec = S::difference(ray.origin, tri.a);
            }
            u = S::dot(tvec, pvec);
            if S::condition::<E>(u.lt(E::ZERO) || u.gt(det)) {
                return missed(1);
            }
            if !with_q {
                qvec = S::cross(tvec, edge1);
            }
            v = S::dot(ray.direction, qvec);
            if S::condition::<E>(v.lt(E::ZERO) || (u + v).gt(det)) {
                return missed(2);
            }
        } else if S::condition::<E>(det.lt(-epsilon::<E>())) {
            if !early {
                tvec = S::difference(ray.origin, tri.a);
            }
            u = S::dot(tvec, pvec);
            if S::condition::<E>(u.gt(E::ZERO) || u.lt(det)) {
                return missed(3);
            }
            if !with_q {
                qvec = S::cross(tvec, edge1);
            }
            v = S::dot(ray.direction, qvec);
            if S::condition::<E>(v.gt(E::ZERO) || (u + v).lt(det)) {
                return missed(4);
            }
        } else {
            return missed(5);
        }
        if !early {
            inv_det = S::divide(E::ONE, det);
        }
        let t = S::dot(edge2, qvec) * inv_det;
        if UV { (GO_ON, t, u * inv_det, v * inv_det) } else { (GO_ON, t, E::ZERO, E::ZERO) }
    }
}

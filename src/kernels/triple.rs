//! Which cross product the weights of Kensler-Shirley are computed by.
//!
//! Both weights are triple products of OA = a - o, the direction D and an edge E, which can be multiplied
//! in either order: (OA x D) . E = (E x OA) . D. Which one costs least depends on what rays have in
//! common, and such orders are what Kensler and Shirley searched among (section 3).

use super::Source;
use super::stored::Frame;
use crate::number::{Real, Vec3};
use crate::policy::Policy;

/// An order of the triple products.
pub trait Triple: 'static {
    /// The column `cross`: empty for the kernel's own order.
    const NAME: &'static str;
    /// What the weights need of a ray's origin and a triangle.
    type Seen<R: Real>: Copy;
    /// N, N . OA and what [`Triple::Seen`] holds: what a common origin shares.
    type Numbers<R: Real>: AsRef<[R]> + Copy;
    /// From OA.
    fn seen<P: Policy, R: Real>(oa: Vec3<R>, tri: &Frame<R>) -> Self::Seen<R>;
    /// The numerators of u and v.
    fn weights<P: Policy, R: Real>(seen: &Self::Seen<R>, direction: Vec3<R>) -> [R; 2];
    /// In the places 0 to 2, 3, and from 4 on.
    fn numbers<R: Real>(n: Vec3<R>, depth: R, seen: &Self::Seen<R>) -> Self::Numbers<R>;
    /// What [`Triple::numbers`] wrote from place 4 on.
    fn read<R: Real, S: Source<R>>(numbers: &S) -> Self::Seen<R>;
}

/// I = OA x D, one cross product for both weights, as Kensler and Shirley found it best for rays that have
/// nothing in common, and as thesis H has it.
pub struct WithDirection;
/// CA x OA and AB x OA, which rays with a common origin share: two dot products are left of both weights.
pub struct WithEdges;

/// OA, and the edges AB and CA.
#[derive(Clone, Copy)]
pub struct OriginAndEdges<R> {
    oa: Vec3<R>,
    ab: Vec3<R>,
    ca: Vec3<R>,
}

impl Triple for WithDirection {
    const NAME: &'static str = "";
    type Seen<R: Real> = OriginAndEdges<R>;
    type Numbers<R: Real> = [R; 13];

    #[inline(always)]
    fn seen<P: Policy, R: Real>(oa: Vec3<R>, tri: &Frame<R>) -> OriginAndEdges<R> {
        OriginAndEdges { oa, ab: tri.ab, ca: tri.ca }
    }
    #[inline(always)]
    fn weights<P: Policy, R: Real>(seen: &OriginAndEdges<R>, direction: Vec3<R>) -> [R; 2] {
        let i = P::cross(seen.oa, direction);
        [P::dot(i, seen.ca), P::dot(i, seen.ab)]
    }
    #[inline(always)]
    fn numbers<R: Real>(n: Vec3<R>, depth: R, seen: &OriginAndEdges<R>) -> [R; 13] {
        let ([nx, ny, nz], [ox, oy, oz]) = (n.0, seen.oa.0);
        let ([bx, by, bz], [cx, cy, cz]) = (seen.ab.0, seen.ca.0);
        [nx, ny, nz, depth, ox, oy, oz, bx, by, bz, cx, cy, cz]
    }
    #[inline(always)]
    fn read<R: Real, S: Source<R>>(numbers: &S) -> OriginAndEdges<R> {
        OriginAndEdges { oa: numbers.vector(4), ab: numbers.vector(7), ca: numbers.vector(10) }
    }
}

impl Triple for WithEdges {
    const NAME: &'static str = "edges";
    type Seen<R: Real> = [Vec3<R>; 2];
    type Numbers<R: Real> = [R; 10];

    #[inline(always)]
    fn seen<P: Policy, R: Real>(oa: Vec3<R>, tri: &Frame<R>) -> [Vec3<R>; 2] {
        [P::cross(tri.ca, oa), P::cross(tri.ab, oa)]
    }
    #[inline(always)]
    fn weights<P: Policy, R: Real>([u, v]: &[Vec3<R>; 2], direction: Vec3<R>) -> [R; 2] {
        [P::dot(direction, *u), P::dot(direction, *v)]
    }
    #[inline(always)]
    fn numbers<R: Real>(n: Vec3<R>, depth: R, [u, v]: &[Vec3<R>; 2]) -> [R; 10] {
        let ([nx, ny, nz], [ux, uy, uz], [vx, vy, vz]) = (n.0, u.0, v.0);
        [nx, ny, nz, depth, ux, uy, uz, vx, vy, vz]
    }
    #[inline(always)]
    fn read<R: Real, S: Source<R>>(numbers: &S) -> [Vec3<R>; 2] {
        [numbers.vector(4), numbers.vector(7)]
    }
}

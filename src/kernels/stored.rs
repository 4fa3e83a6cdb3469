//! What a kernel keeps of a triangle, where it has the choice (thesis H compares the three).
//!
//! The edges are those of Kensler and Shirley, AB = b - a and CA = a - c, and N = AB x CA: with
//! them no formula needs a unary minus. N points away from the side from which a, b, c is
//! counter-clockwise.

use super::Corners;
use crate::number::{Element, Real, Vec3};
use crate::policy::Policy;

/// A storage form: from corners to a record, and back to corner, edges and N in lanes.
pub trait Stored: 'static {
    /// The column `stored`.
    const NAME: &'static str;
    /// What is prepared, in words.
    const SETUP: &'static str;
    /// The record.
    type Record<E: Element>: Copy + 'static;
    /// Fills the record.
    fn prepare<E: Element>(corners: &Corners<E>) -> Self::Record<E>;
    /// What a test needs of it.
    fn meet<P: Policy, R: Real>(token: R::Token, record: &Self::Record<R::Element>) -> Frame<R>;
}

/// A corner, two edges and their cross product.
#[derive(Clone, Copy)]
pub struct Frame<R> {
    /// Vertex a.
    pub a: Vec3<R>,
    /// AB = b - a.
    pub ab: Vec3<R>,
    /// CA = a - c.
    pub ca: Vec3<R>,
    /// N = AB x CA.
    pub n: Vec3<R>,
}

impl<R: Real> Frame<R> {
    #[inline(always)]
    fn of(corners: &Corners<R>, n: Vec3<R>) -> Self {
        Frame { a: corners.a, ab: corners.b - corners.a, ca: corners.a - corners.c, n }
    }
    #[inline(always)]
    fn splat(token: R::Token, f: Frame<R::Element>) -> Self {
        Frame {
            a: Vec3::splat(token, f.a),
            ab: Vec3::splat(token, f.ab),
            ca: Vec3::splat(token, f.ca),
            n: Vec3::splat(token, f.n),
        }
    }
}

/// a x b, rounded at every operation, for what is prepared once.
pub fn plain_cross<E: Element>(a: Vec3<E>, b: Vec3<E>) -> Vec3<E> {
    Vec3([
        a.y() * b.z() - a.z() * b.y(),
        a.z() * b.x() - a.x() * b.z(),
        a.x() * b.y() - a.y() * b.x(),
    ])
}

/// a . b, rounded at every operation, for what is prepared once.
pub fn plain_dot<E: Element>(a: Vec3<E>, b: Vec3<E>) -> E {
    a.z() * b.z() + (a.y() * b.y() + a.x() * b.x())
}

/// Three vertices: 9 numbers.
pub struct Vertices;
/// Three vertices and the normal: 12 numbers.
pub struct WithNormal;
/// One vertex, two edges and the normal: 12 numbers.
pub struct Precomputed;

impl Stored for Vertices {
    const NAME: &'static str = "vertices";
    const SETUP: &'static str = "none: three vertices";
    type Record<E: Element> = Corners<E>;

    fn prepare<E: Element>(corners: &Corners<E>) -> Corners<E> {
        *corners
    }
    #[inline(always)]
    fn meet<P: Policy, R: Real>(token: R::Token, record: &Corners<R::Element>) -> Frame<R> {
        let (ab, ca) = (record.b - record.a, record.a - record.c);
        Frame::splat(token, Frame { a: record.a, ab, ca, n: P::cross(ab, ca) })
    }
}

impl Stored for WithNormal {
    const NAME: &'static str = "normal";
    const SETUP: &'static str = "the normal";
    type Record<E: Element> = (Corners<E>, Vec3<E>);

    fn prepare<E: Element>(corners: &Corners<E>) -> (Corners<E>, Vec3<E>) {
        (*corners, plain_cross(corners.b - corners.a, corners.a - corners.c))
    }
    #[inline(always)]
    fn meet<P: Policy, R: Real>(
        token: R::Token,
        (corners, n): &(Corners<R::Element>, Vec3<R::Element>),
    ) -> Frame<R> {
        Frame::splat(token, Frame::of(corners, *n))
    }
}

impl Stored for Precomputed {
    const NAME: &'static str = "precomputed";
    const SETUP: &'static str = "two edges and the normal";
    type Record<E: Element> = Frame<E>;

    fn prepare<E: Element>(corners: &Corners<E>) -> Frame<E> {
        Frame::of(corners, plain_cross(corners.b - corners.a, corners.a - corners.c))
    }
    #[inline(always)]
    fn meet<P: Policy, R: Real>(token: R::Token, record: &Frame<R::Element>) -> Frame<R> {
        Frame::splat(token, *record)
    }
}

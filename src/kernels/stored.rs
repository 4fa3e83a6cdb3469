//! What a kernel keeps of a triangle, where it has the choice (thesis H compares the three).
//!
//! The edges are those of Kensler and Shirley, AB = b - a and CA = a - c, and N = AB x CA: with
//! them no formula needs a unary minus. N points away from the side from which a, b, c is
//! counter-clockwise.

use super::{Corners, Source};
use crate::number::{Element, Real, Vec3, dominant, spread};
use crate::policy::Policy;

/// A storage form: from corners to a record, and back to corner, edges and N in lanes.
pub trait Stored: 'static {
    /// The column `stored`.
    const NAME: &'static str;
    /// Whether N is in the record.
    const STORES_NORMAL: bool;
    /// What is prepared, in words.
    const SETUP: &'static str;
    /// The record.
    type Record<E: Element>: AsRef<[E]> + Copy + 'static;
    /// Fills the record.
    fn prepare<E: Element>(corners: &Corners<E>) -> Self::Record<E>;
    /// What a test needs of it.
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Frame<T>;
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

spread!(Frame { a, ab, ca, n });

/// The edges AB and CA.
#[inline(always)]
fn edges<R: Real>(corners: &Corners<R>) -> (Vec3<R>, Vec3<R>) {
    (corners.b - corners.a, corners.a - corners.c)
}

/// A record of three corners and a normal.
pub fn with_normal<E: Element>(corners: &Corners<E>, n: Vec3<E>) -> [E; 12] {
    let ([ax, ay, az, bx, by, bz, cx, cy, cz], [nx, ny, nz]) = (corners.numbers(), n.0);
    [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz]
}

/// A record of three corners, their plane n . p = n . a, and the axis of n's largest component.
pub fn with_plane<E: Element>(corners: &Corners<E>, n: Vec3<E>) -> [E; 14] {
    let [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz] = with_normal(corners, n);
    let (nd, w) = (plain_dot(n, corners.a), E::from_index(dominant(n)));
    [ax, ay, az, bx, by, bz, cx, cy, cz, nx, ny, nz, nd, w]
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
    const STORES_NORMAL: bool = false;
    const SETUP: &'static str = "none: three vertices";
    type Record<E: Element> = [E; 9];

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 9] {
        corners.numbers()
    }
    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Frame<T> {
        let corners = Corners::read(stored, 0);
        let (ab, ca) = edges(&corners);
        Frame { a: corners.a, ab, ca, n: P::cross(ab, ca) }
    }
}

impl Stored for WithNormal {
    const NAME: &'static str = "normal";
    const STORES_NORMAL: bool = true;
    const SETUP: &'static str = "the normal";
    type Record<E: Element> = [E; 12];

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 12] {
        let (ab, ca) = edges(corners);
        with_normal(corners, plain_cross(ab, ca))
    }
    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Frame<T> {
        let corners = Corners::read(stored, 0);
        let (ab, ca) = edges(&corners);
        Frame { a: corners.a, ab, ca, n: stored.vector(9) }
    }
}

impl Stored for Precomputed {
    const NAME: &'static str = "precomputed";
    const STORES_NORMAL: bool = true;
    const SETUP: &'static str = "two edges and the normal";
    type Record<E: Element> = [E; 12];

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 12] {
        let (b, c) = edges(corners);
        with_normal(&Corners { a: corners.a, b, c }, plain_cross(b, c))
    }
    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Frame<T> {
        Frame {
            a: stored.vector(0),
            ab: stored.vector(3),
            ca: stored.vector(6),
            n: stored.vector(9),
        }
    }
}

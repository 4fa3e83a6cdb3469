//! What a kernel of one's own is: a function from a ray and a prepared triangle to a hit.

use crate::kernels::Corners;
use crate::number::Element;
use crate::policy;

/// What such a kernel computes in.
pub trait Number: Element {}

impl Number for f32 {}
impl Number for f64 {}

/// A ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<N> {
    /// Where t = 0.
    pub origin: [N; 3],
    /// Its direction, of any length; t is counted in units of it.
    pub direction: [N; 3],
    /// Smallest t that counts (it does itself); finite.
    pub t_min: N,
    /// Largest t that counts (it does itself); finite.
    pub t_max: N,
}

/// A triangle, of any shape, degenerate ones too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle<N> {
    /// Vertex a.
    pub a: [N; 3],
    /// Vertex b.
    pub b: [N; 3],
    /// Vertex c.
    pub c: [N; 3],
}

/// Where a triangle is hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<N> {
    /// Distance along the ray, in units of its direction.
    pub t: N,
    /// Weight of vertex b, from 0 to 1.
    pub u: N,
    /// Weight of vertex c, from 0 to 1; that of a is 1 - u - v.
    pub v: N,
}

/// A ray-triangle test to be held to the exact answer and measured. The triangle is closed: its edges
/// and vertices belong to it, and so do both ends of the ray's range of t.
pub trait OwnKernel: 'static {
    /// Its id in tables, other than those of the others; 20 characters at most are shown.
    const NAME: &'static str;
    /// Whether a ray that meets the back of a triangle is meant to miss it. The front is the side
    /// from which a, b, c run counter-clockwise.
    const CULLS: bool = false;
    /// What it computes in: `f32` or `f64`.
    type Number: Number;
    /// What is stored of a triangle.
    type Record: Copy + 'static;

    /// What is stored of a triangle. Not part of the timed loop.
    fn prepare(triangle: &Triangle<Self::Number>) -> Self::Record;

    /// The test. It is compiled into the timed loop if it is `#[inline]`, as ours are; if not, its
    /// call is part of its time.
    fn test(ray: &Ray<Self::Number>, record: &Self::Record) -> Option<Hit<Self::Number>>;
}

impl<N: Number> Ray<N> {
    pub(super) fn of(ray: &policy::Ray<N>) -> Self {
        let policy::Ray { origin, direction, t_min, t_max, .. } = *ray;
        Ray { origin: origin.0, direction: direction.0, t_min, t_max }
    }
}

impl<N: Number> Triangle<N> {
    pub(super) fn of(corners: &Corners<N>) -> Self {
        Triangle { a: corners.a.0, b: corners.b.0, c: corners.c.0 }
    }
}

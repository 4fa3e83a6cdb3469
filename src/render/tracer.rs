//! What finds hits, and what it finds.

use crate::workload::Ray;

/// A hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the triangle.
    pub triangle: u32,
    /// Distance in units of the ray's direction; of a kernel of segments, in units of the segment.
    pub t: f64,
}

impl Hit {
    /// Whether it is nearer, or as near and of a triangle that comes first.
    pub fn precedes(&self, other: &Hit) -> bool {
        self.t < other.t || (self.t == other.t && self.triangle < other.triangle)
    }
}

/// What finds hits: a kernel with a structure around its triangles, the exact answer, or a recording.
/// A picture is made with any of them, by the same code.
pub trait Tracer {
    /// The rays that follow belong to this pixel, counted by rows from the top left.
    fn begin(&mut self, _pixel: usize) {}
    /// The hit with the smallest t in the ray's range; of several at one distance the triangle with
    /// the lowest index.
    fn nearest(&mut self, ray: &Ray) -> Option<Hit>;
    /// Any hit in the ray's range.
    fn any(&mut self, ray: &Ray) -> Option<Hit>;
    /// Tests of a ray against a triangle so far.
    fn triangles_tested(&self) -> u64;
}

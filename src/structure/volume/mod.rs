//! Bounding volumes: a test that is cheaper than what is inside, and that misses nothing.
//!
//! Every test here is conservative: where the exact ray meets a point of the volume at an exact t within
//! the ray's range, the volume is hit, and the distance that is told is not beyond that t. The numbers
//! of rays and triangles are f32 and tests are in f64, so neither overflow nor underflow has to be
//! thought of, and what rounding does is bounded in each file. Ize's argument ("Robust BVH Ray
//! Traversal", JCGT 2(2), 2013) is the model: a false hit costs some time, a false miss a hole.

mod both;
mod bounds;
mod slabs;
mod sphere;
#[cfg(test)]
mod tests;

pub use both::Both;
pub use bounds::Bounds;
pub use slabs::Slabs;
pub use sphere::Sphere;

use super::Beam;

/// The part of a ray that is in a volume, never smaller than it exactly is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Where the ray enters, or begins.
    pub near: f64,
    /// Where the ray leaves, or ends.
    pub far: f64,
}

impl Crossing {
    /// `None` where nothing is left.
    #[inline(always)]
    fn new(near: f64, far: f64) -> Option<Self> {
        (near <= far).then_some(Crossing { near, far })
    }
}

/// A convex volume around some points.
pub trait Volume: Copy + 'static {
    /// Its name in tables.
    const NAME: &'static str;
    /// What is prepared of a ray; `()` for nothing.
    type Aim: Copy;
    /// Around points, of which there is at least one; all are finite.
    fn around(points: &[[f32; 3]]) -> Self;
    /// What is done once per ray.
    fn aim(beam: &Beam) -> Self::Aim;
    /// Which part of the ray is inside, within the ray's range.
    fn crossing(&self, beam: &Beam, aim: &Self::Aim) -> Option<Crossing>;
    /// Where the ray enters, if that is no farther than `bound`.
    #[inline(always)]
    fn hit(&self, beam: &Beam, aim: &Self::Aim, bound: f64) -> Option<f64> {
        let crossing = self.crossing(beam, aim)?;
        (crossing.near <= bound).then_some(crossing.near)
    }
}

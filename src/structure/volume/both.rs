//! The intersection of two volumes.

use super::{Beam, Crossing, Volume};

/// What is in both. The second is looked at only where the first is met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Both<A, B>(pub A, pub B);

/// Names of intersections.
trait Named {
    const NAME: &'static str;
}

impl Named for Both<super::Sphere, super::Bounds> {
    const NAME: &'static str = "sphere-and-box";
}

impl Named for Both<super::Sphere, super::Slabs> {
    const NAME: &'static str = "sphere-and-slabs";
}

impl<A: Volume, B: Volume> Volume for Both<A, B>
where
    Both<A, B>: Named,
{
    const NAME: &'static str = <Self as Named>::NAME;
    type Aim = (A::Aim, B::Aim);

    fn around(points: &[[f32; 3]]) -> Self {
        Both(A::around(points), B::around(points))
    }

    #[inline(always)]
    fn aim(beam: &Beam) -> Self::Aim {
        (A::aim(beam), B::aim(beam))
    }

    /// A convex volume is crossed in one piece, so both together are crossed where the pieces overlap.
    #[inline(always)]
    fn crossing(&self, beam: &Beam, (a, b): &Self::Aim) -> Option<Crossing> {
        let (one, other) = (self.0.crossing(beam, a)?, self.1.crossing(beam, b)?);
        Crossing::new(one.near.max(other.near), one.far.min(other.far))
    }
}

//! The box along the axes.

use super::{Beam, Crossing, Volume};
use crate::structure::beam::WIDER;

/// The least box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lowest coordinates.
    pub low: [f32; 3],
    /// Highest coordinates.
    pub high: [f32; 3],
}

impl Bounds {
    /// Around nothing: what is joined with it stays as it is.
    pub const NOTHING: Bounds = Bounds { low: [f32::MAX; 3], high: [-f32::MAX; 3] };

    /// Around a triangle; `None` where a corner is not finite.
    pub fn of(triangle: &crate::workload::Triangle) -> Option<Self> {
        let corners = [triangle.a, triangle.b, triangle.c];
        let is_finite = corners.iter().all(|corner| corner.is_finite());
        is_finite.then(|| Bounds::around(&corners.map(|corner| corner.to_array())))
    }

    /// Around both.
    #[inline(always)]
    pub fn joined(&self, other: &Bounds) -> Bounds {
        let mut joined = *self;
        for axis in 0..3 {
            joined.low[axis] = joined.low[axis].min(other.low[axis]);
            joined.high[axis] = joined.high[axis].max(other.high[axis]);
        }
        joined
    }

    /// Whether they have a point in common; both are closed.
    pub fn touches(&self, other: &Bounds) -> bool {
        (0..3).all(|i| self.low[i] <= other.high[i] && other.low[i] <= self.high[i])
    }

    /// Twice the middle along an axis.
    #[inline(always)]
    pub fn doubled_middle(&self, axis: usize) -> f64 {
        f64::from(self.low[axis]) + f64::from(self.high[axis])
    }

    /// Length along an axis; negative of [`Bounds::NOTHING`].
    #[inline(always)]
    pub fn extent(&self, axis: usize) -> f64 {
        f64::from(self.high[axis]) - f64::from(self.low[axis])
    }

    /// Surface, in squares of the coordinates' unit; 0 of [`Bounds::NOTHING`].
    #[inline(always)]
    pub fn area(&self) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|axis| self.extent(axis).max(0.0));
        2.0 * (x * y + y * z + z * x)
    }
}

impl Volume for Bounds {
    const NAME: &'static str = "box";
    type Aim = ();

    fn around(points: &[[f32; 3]]) -> Self {
        let one = |point: &[f32; 3]| Bounds { low: *point, high: *point };
        points.iter().fold(Bounds::NOTHING, |bounds, point| bounds.joined(&one(point)))
    }

    #[inline(always)]
    fn aim(_: &Beam) {}

    /// Kay and Kajiya's slabs (1986). Where a component of the direction is 0 or -0, the inverse is
    /// infinite: planes on the two sides of the origin are met at opposite infinities, planes on one side
    /// at the same, and a plane that holds the ray at 0 * infinity = NaN, which fails both comparisons, so
    /// that the slab bounds nothing: a ray in the plane of a face meets the box. `near` is not negative,
    /// and signs are exact, so both ends are widened away from each other by factors.
    #[inline(always)]
    fn crossing(&self, beam: &Beam, (): &()) -> Option<Crossing> {
        let (mut near, mut far) = (beam.t_min, beam.t_max);
        for axis in 0..3 {
            let [low, high] = [self.low[axis], self.high[axis]];
            let (first, last) = if beam.is_backward[axis] { (high, low) } else { (low, high) };
            let (enters, leaves) = (beam.at(axis, first.into()), beam.at(axis, last.into()));
            near = if enters > near { enters } else { near };
            far = if leaves < far { leaves } else { far };
        }
        Crossing::new(near * (1.0 - WIDER), far * (1.0 + WIDER))
    }
}

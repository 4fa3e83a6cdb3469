//! A ray as volumes and cells see it: in f64, so that no rounding of theirs can lose a hit.

use crate::workload::Ray;

/// A ray, or a segment, prepared for tests of volumes. Its numbers are those of an f32 ray, exactly;
/// what is computed from them is within a few roundings of f64, and far from its limits: sums, products
/// and quotients of two f32 neither overflow nor underflow.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// Where t = 0.
    pub origin: [f64; 3],
    /// Not zero. Of a segment: end - origin, rounded once.
    pub direction: [f64; 3],
    /// 1 / direction; infinite, with the sign of the zero, where that is 0.
    pub inverse: [f64; 3],
    /// Whether the direction's sign bit is set.
    pub is_backward: [bool; 3],
    /// Smallest t that counts, not negative: a search is along a ray, not along a line.
    pub t_min: f64,
    /// Largest t that counts; finite.
    pub t_max: f64,
}

/// What is computed of a plane across an axis, (p - o) / d, errs by at most four roundings: one each in
/// the direction of a segment, the difference, the reciprocal, the product. So
/// |error| <= 4.01 u |t| with u = 2^-53; this is 16 u, and leaves room for the product with it.
pub const WIDER: f64 = 16.0 * (f64::EPSILON / 2.0);

impl Beam {
    /// Of a ray; `None` where a number is not finite or the direction is zero: it hits nothing, by rule.
    /// A `t_min` below 0 counts as 0.
    pub fn of_ray(ray: &Ray) -> Option<Self> {
        let [origin, direction] = [ray.origin, ray.direction].map(|v| v.to_array().map(f64::from));
        // NaN makes the maximum or the minimum its other operand, so it is asked for.
        if ray.t_min.is_nan() || ray.t_max.is_nan() {
            return None;
        }
        let (t_min, t_max) = (f64::from(ray.t_min.max(0.0)), f64::from(ray.t_max.min(f32::MAX)));
        Beam::new(origin, direction, [t_min, t_max])
    }

    /// Of the segment from origin to end: t from 0 to 1. `None` as for rays.
    pub fn of_segment(ray: &Ray) -> Option<Self> {
        let [origin, end] = [ray.origin, ray.end].map(|v| v.to_array().map(f64::from));
        let direction = [end[0] - origin[0], end[1] - origin[1], end[2] - origin[2]];
        Beam::new(origin, direction, [0.0, 1.0])
    }

    fn new(origin: [f64; 3], direction: [f64; 3], [t_min, t_max]: [f64; 2]) -> Option<Self> {
        let is_finite = origin.iter().chain(&direction).all(|x| x.is_finite());
        if !is_finite || direction.iter().all(|x| *x == 0.0) || t_min > t_max {
            return None;
        }
        let is_backward = direction.map(f64::is_sign_negative);
        let inverse = direction.map(|x| 1.0 / x);
        Some(Beam { origin, direction, inverse, is_backward, t_min, t_max })
    }

    /// The same ray in a space that is larger by a power of two between 2^-200 and 2^200; t is the same.
    pub fn scaled(&self, scale: f64) -> Beam {
        Beam {
            origin: self.origin.map(|x| x * scale),
            direction: self.direction.map(|x| x * scale),
            inverse: self.inverse.map(|x| x / scale),
            ..*self
        }
    }

    /// Where the plane at `place` across `axis` is met; NaN for a ray that lies in it.
    #[inline(always)]
    pub fn at(&self, axis: usize, place: f64) -> f64 {
        (place - self.origin[axis]) * self.inverse[axis]
    }
}

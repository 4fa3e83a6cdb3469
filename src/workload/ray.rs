//! A ray as it is drawn.

use glam::Vec3;

/// One ray, or segment, or line, as drawn: f32 numbers, which f64 kernels get widened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where t = 0.
    pub origin: Vec3,
    /// Direction, normalised in f32 (so of length 1 within rounding).
    pub direction: Vec3,
    /// End of the segment that the ray was drawn from; only segment kernels look at it.
    pub end: Vec3,
    /// Smallest t that counts; -MAX for lines.
    pub t_min: f32,
    /// Largest t that counts; MAX for rays and lines.
    pub t_max: f32,
}

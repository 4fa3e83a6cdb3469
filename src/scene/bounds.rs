//! The smallest box around points, and the ball around the box.

use crate::number::Precision;
use glam::{DVec3, Vec3};

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest x, y, z.
    pub lowest: Vec3,
    /// Largest x, y, z.
    pub highest: Vec3,
}

impl Bounds {
    /// Around finite points. Around none it is empty: its lowest is above its highest.
    pub fn of(points: impl Iterator<Item = Vec3>) -> Self {
        let empty = Bounds { lowest: Vec3::MAX, highest: Vec3::MIN };
        points.fold(empty, |bounds, point| Bounds {
            lowest: bounds.lowest.min(point),
            highest: bounds.highest.max(point),
        })
    }

    /// Middle, in f64, where the sum of two f32 numbers of like size is exact.
    pub fn centre(&self) -> DVec3 {
        (self.lowest.as_dvec3() + self.highest.as_dvec3()) / 2.0
    }

    /// Length of the diagonal; twice the radius of the ball around the box.
    pub fn diagonal(&self) -> f64 {
        (self.highest.as_dvec3() - self.lowest.as_dvec3()).length()
    }

    /// Radius of the ball around the box. Where all points are one, the unit roundoff of f32 times
    /// the largest coordinate, or the smallest number: never 0.
    pub fn radius(&self) -> f64 {
        let rounding = Precision::F32.unit_roundoff() * self.largest_coordinate();
        (self.diagonal() / 2.0).max(rounding).max(f64::from(f32::MIN_POSITIVE))
    }

    /// Largest magnitude of a coordinate.
    pub fn largest_coordinate(&self) -> f64 {
        let most = self.lowest.abs().max(self.highest.abs());
        f64::from(most.max_element())
    }

    /// Whether the closed box holds a point.
    pub fn holds(&self, point: Vec3) -> bool {
        point.cmpge(self.lowest).all() && point.cmple(self.highest).all()
    }
}

//! Random geometry for the families, from one seeded generator.
//!
//! Rules of all of them: draw in f64, round the triangle to the precision, aim at the rounded
//! triangle, round origin and direction. The exact answer is that of the rounded inputs.

use super::precision::Precision;
use crate::oracle::Query;
use crate::workload::Pcg;
use crate::workload::hash::Fnv;
use glam::DVec3;

/// Rays meet a plane at no flatter angle than this, unless a family says so.
const LEAST_COSINE: f64 = 0.3;
/// Targets inside keep this distance from the edges, in weights; those outside, too.
const TARGET_MARGIN: f64 = 0.05;
/// Rays reach this many times as far as the plane.
pub const REACH: f64 = 8.0;

/// A source of random geometry.
pub struct Draw {
    pcg: Pcg,
    /// What inputs are rounded to.
    pub precision: Precision,
}

/// A triangle, already rounded, and how a ray is to meet it.
pub struct Pose {
    /// Vertices a, b, c.
    pub triangle: [DVec3; 3],
    /// Normal of length 1, as drawn: that of a needle cannot be computed from rounded vertices.
    pub normal: DVec3,
    /// Distance from origin to plane along the ray.
    pub distance: f64,
    /// Whether it is aimed inside.
    pub inside: bool,
}

impl Draw {
    /// The generator of one family, knob and precision: the stream of `seed` whose purpose is the
    /// hash (FNV-1a, 64 bits) of the family's id, the precision's name, and the bits of the knob.
    pub fn new(seed: u64, family: &str, knob: f64, precision: Precision) -> Self {
        let mut hash = Fnv::default();
        hash.bytes(family.as_bytes());
        hash.bytes(precision.name().as_bytes());
        hash.bytes(&knob.to_bits().to_le_bytes());
        Draw { pcg: Pcg::stream(seed, hash.finish()), precision }
    }

    /// Uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.pcg.unit_f64()
    }

    /// A whole number below `bound`.
    pub fn below(&mut self, bound: u64) -> u64 {
        self.pcg.below(bound)
    }

    /// A whole number from -`most` to `most`.
    pub fn whole(&mut self, most: u64) -> f64 {
        self.below(2 * most + 1) as f64 - most as f64
    }

    /// True in that share of the calls.
    pub fn chance(&mut self, share: f64) -> bool {
        self.pcg.unit_f64() < share
    }

    /// 1 or -1.
    pub fn sign(&mut self) -> f64 {
        if self.chance(0.5) { 1.0 } else { -1.0 }
    }

    /// A point of the cube [-1, 1)^3.
    pub fn cube(&mut self) -> DVec3 {
        DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }

    /// A direction of length 1, every one equally likely: a point of the ball, redrawn where it is
    /// outside or too near to the centre to be divided by its length.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let point = self.cube();
            let square = point.length_squared();
            if (1e-4..=1.0).contains(&square) {
                return point / square.sqrt();
            }
        }
    }

    /// A right-handed orthonormal frame.
    pub fn frame(&mut self) -> [DVec3; 3] {
        let x = self.direction();
        loop {
            let other = self.direction();
            let y = other - x * x.dot(other);
            if y.length_squared() > 0.1 {
                let y = y.normalize();
                return [x, y, x.cross(y)];
            }
        }
    }

    /// Rounded to the precision.
    pub fn round(&self, point: DVec3) -> DVec3 {
        DVec3::from_array(point.to_array().map(|x| self.precision.round(x)))
    }

    /// A well-shaped triangle, not rounded: vertices in [-1, 1)^3, the longest edge squared less
    /// than 4 times twice the area, a and b at least 0.5 apart.
    pub fn benign(&mut self) -> [DVec3; 3] {
        loop {
            let [a, b, c] = [self.cube(), self.cube(), self.cube()];
            let doubled = (b - a).cross(c - a).length();
            let edges = [b - a, c - a, c - b].map(DVec3::length_squared);
            let longest = edges.into_iter().fold(0.0, f64::max);
            if longest < 4.0 * doubled && edges[0] > 0.25 {
                return [a, b, c];
            }
        }
    }

    /// Weights of b and c: inside with every weight at least 0.05, or outside, in [-1, 2]^2, with
    /// the smallest weight at most -0.05.
    pub fn target(&mut self, inside: bool) -> (f64, f64) {
        loop {
            let range = if inside { (0.0, 1.0) } else { (-1.0, 2.0) };
            let (u, v) = (self.between(range.0, range.1), self.between(range.0, range.1));
            let least = u.min(v).min(1.0 - u - v);
            if (inside && least >= TARGET_MARGIN) || (!inside && least <= -TARGET_MARGIN) {
                return (u, v);
            }
        }
    }

    /// A direction that meets the plane of that normal at no flat angle.
    pub fn towards(&mut self, normal: DVec3) -> DVec3 {
        loop {
            let direction = self.direction();
            // A NaN normal, of a triangle without one, lets every direction through.
            if normal.is_nan() || direction.dot(normal).abs() >= LEAST_COSINE {
                return direction;
            }
        }
    }

    /// A distance of the usual size: in [0.5, 2).
    pub fn distance(&mut self) -> f64 {
        self.between(0.5, 2.0)
    }

    /// A pose of a triangle that is rounded here, with its own normal and the usual distance.
    pub fn pose(&mut self, triangle: [DVec3; 3], inside: bool) -> Pose {
        let normal = normal_of(&triangle);
        let triangle = triangle.map(|p| self.round(p));
        Pose { triangle, normal, distance: self.distance(), inside }
    }

    /// A ray that meets a pose.
    pub fn shoot(&mut self, pose: &Pose) -> Query {
        let direction = self.towards(pose.normal);
        self.shoot_along(pose, direction, direction)
    }

    /// A ray that meets a pose along `way` (of length 1), with another multiple of it, `direction`,
    /// for its direction.
    pub fn shoot_along(&mut self, pose: &Pose, way: DVec3, direction: DVec3) -> Query {
        let (u, v) = self.target(pose.inside);
        let point = weighted(&pose.triangle, u, v);
        let reach = REACH * pose.distance.abs() / direction.length();
        self.ray(point - way * pose.distance, direction, pose.triangle, (0.0, reach))
    }

    /// The query of a ray, whose parts are rounded here.
    pub fn ray(
        &self,
        origin: DVec3,
        direction: DVec3,
        triangle: [DVec3; 3],
        range: (f64, f64),
    ) -> Query {
        Query {
            origin: self.round(origin).to_array(),
            direction: self.round(direction).to_array(),
            end: None,
            triangle: triangle.map(|p| self.round(p).to_array()),
            t_min: self.precision.round(range.0),
            t_max: self.precision.round(range.1).min(self.precision.largest()),
        }
    }
}

/// The normal of length 1; NaN for a triangle without one.
pub fn normal_of([a, b, c]: &[DVec3; 3]) -> DVec3 {
    (*b - *a).cross(*c - *a).normalize()
}

/// The point of weights 1 - u - v, u, v.
pub fn weighted([a, b, c]: &[DVec3; 3], u: f64, v: f64) -> DVec3 {
    *a + (*b - *a) * u + (*c - *a) * v
}

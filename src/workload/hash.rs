//! The one hash that names a workload.

use super::{Ray, Triangle};
use glam::Vec3;

/// FNV-1a, 64 bits (Fowler, Noll, Vo), over raw little-endian bits.
#[derive(Clone, Debug)]
pub struct Fnv(u64);

impl Default for Fnv {
    fn default() -> Self {
        Fnv(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv {
    /// Adds bytes.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Adds a count.
    pub fn count(&mut self, count: usize) {
        self.bytes(&(count as u64).to_le_bytes());
    }

    /// Adds the bits of a number; 0 and -0 differ.
    pub fn number(&mut self, number: f32) {
        self.bytes(&number.to_bits().to_le_bytes());
    }

    fn point(&mut self, point: Vec3) {
        self.number(point.x);
        self.number(point.y);
        self.number(point.z);
    }

    /// The hash of what was added.
    pub fn finish(&self) -> u64 {
        self.0
    }
}

/// Hash of a workload: the number of rays, each ray's origin, direction, end, t_min, t_max, the
/// number of triangles, each triangle's a, b, c.
pub fn workload(rays: &[Ray], triangles: &[Triangle]) -> u64 {
    let mut hash = Fnv::default();
    hash.count(rays.len());
    for ray in rays {
        hash.point(ray.origin);
        hash.point(ray.direction);
        hash.point(ray.end);
        hash.number(ray.t_min);
        hash.number(ray.t_max);
    }
    hash.count(triangles.len());
    for triangle in triangles {
        hash.point(triangle.a);
        hash.point(triangle.b);
        hash.point(triangle.c);
    }
    hash.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fnv_matches_its_published_vectors() {
        let of = |text: &str| {
            let mut hash = Fnv::default();
            hash.bytes(text.as_bytes());
            hash.finish()
        };
        assert_eq!(of(""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(of("a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(of("foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn every_number_counts() {
        let ray = Ray {
            origin: Vec3::new(1.0, 2.0, 3.0),
            direction: Vec3::X,
            end: Vec3::Y,
            t_min: 0.0,
            t_max: 1.0,
        };
        let triangle = Triangle { a: Vec3::X, b: Vec3::Y, c: Vec3::Z };
        let base = workload(&[ray], &[triangle]);
        let rays = [
            Ray { origin: Vec3::new(1.0, 2.0, 4.0), ..ray },
            Ray { direction: Vec3::Z, ..ray },
            Ray { end: Vec3::Z, ..ray },
            Ray { t_min: -0.0, ..ray },
            Ray { t_max: 2.0, ..ray },
        ];
        for other in rays {
            assert_ne!(base, workload(&[other], &[triangle]));
        }
        let triangles = [
            Triangle { a: Vec3::Y, ..triangle },
            Triangle { b: Vec3::Z, ..triangle },
            Triangle { c: Vec3::X, ..triangle },
        ];
        for other in triangles {
            assert_ne!(base, workload(&[ray], &[other]));
        }
    }
}

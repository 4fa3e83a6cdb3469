//! The nearest hit so far, and how far a search has to go.

/// A kernel's hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the triangle.
    pub triangle: u32,
    /// Distance in units of the direction.
    pub t: f32,
    /// Weight of vertex b.
    pub u: f32,
    /// Weight of vertex c.
    pub v: f32,
}

impl Hit {
    /// Whether it is nearer, or as near and of a triangle that comes first. So the nearest of many hits
    /// does not depend on the order in which they are found.
    pub fn precedes(&self, other: &Hit) -> bool {
        self.t < other.t || (self.t == other.t && self.triangle < other.triangle)
    }
}

/// A search goes this much beyond the nearest hit so far, in parts of its distance.
///
/// Two things are asked of it. A triangle at the distance of the best hit must still be found: its
/// kernel compares a numerator with the bound times the determinant, and the distance of the best hit
/// is such a quotient, computed with at most three roundings, so 2^-22 would do. And a volume must not
/// be left out whose triangle a kernel reports nearer than it is: here 2^-14, a thousand roundings of
/// f32, is what a structure *promises*. A kernel that is wrong by more is on its own, see the module's
/// text.
pub const SLACK: f64 = 1.0 / 16_384.0;

/// The nearest hit so far, and the bounds that follow from it.
#[derive(Clone, Copy, Debug)]
pub struct Best {
    hit: Option<Hit>,
    limit: f32,
    bound: f64,
    t_max: f32,
}

impl Best {
    /// No hit; `t_max` bounds what counts.
    pub fn nothing(t_max: f32) -> Self {
        Best { hit: None, limit: t_max, bound: f64::from(t_max) * (1.0 + SLACK), t_max }
    }

    /// The hit, if there is one.
    pub fn hit(&self) -> Option<Hit> {
        self.hit
    }

    /// The largest t that a kernel is asked for: [`SLACK`] beyond the best, but no farther than the ray.
    #[inline(always)]
    pub fn limit(&self) -> f32 {
        self.limit
    }

    /// Volumes that begin beyond this need not be looked into.
    #[inline(always)]
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// Takes over a hit if it precedes the best one.
    #[inline(always)]
    pub fn offer(&mut self, hit: Hit) {
        if self.hit.is_none_or(|best| hit.precedes(&best)) {
            self.hit = Some(hit);
            self.bound = f64::from(hit.t) * (1.0 + SLACK);
            // Not below the bound, whichever way the conversion rounds.
            self.limit = (self.bound as f32).next_up().min(self.t_max);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hit(triangle: u32, t: f32) -> Hit {
        Hit { triangle, t, u: 0.0, v: 0.0 }
    }

    #[test]
    fn the_order_of_offers_does_not_matter() {
        let hits = [hit(3, 2.0), hit(1, 2.0), hit(0, 5.0), hit(2, 2.0)];
        for first in 0..4 {
            let mut best = Best::nothing(f32::MAX);
            for step in 0..4 {
                best.offer(hits[(first + step) % 4]);
            }
            assert_eq!(best.hit(), Some(hit(1, 2.0)));
        }
    }

    #[test]
    fn limits_are_beyond_the_best_and_within_the_ray() {
        for t in [0.0, f32::from_bits(1), 1e-30, 1.0, 1e30] {
            let mut best = Best::nothing(f32::MAX);
            best.offer(hit(0, t));
            assert!(best.limit() > t && f64::from(best.limit()) >= best.bound());
        }
        let mut best = Best::nothing(1.0);
        best.offer(hit(0, 0.99999));
        assert_eq!(best.limit(), 1.0);
    }
}

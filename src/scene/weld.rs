//! Which vertices are at the same place.

use glam::Vec3;
use std::collections::HashMap;

/// Numbers places in the order in which they are first met. 0 and -0 are one place.
#[derive(Default)]
pub struct Weld(HashMap<[u32; 3], u32>);

impl Weld {
    /// The number of a place, and whether it is new.
    pub fn index(&mut self, place: Vec3) -> (u32, bool) {
        // -0 + 0 is 0.
        let key = place.to_array().map(|x| (x + 0.0).to_bits());
        let next = self.0.len() as u32;
        let index = *self.0.entry(key).or_insert(next);
        (index, index == next)
    }

    /// The number of each place.
    pub fn of(places: &[Vec3]) -> Vec<u32> {
        let mut weld = Weld::default();
        places.iter().map(|place| weld.index(*place).0).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_numbered_as_they_come_and_zeros_have_no_sign() {
        let places = [Vec3::X, Vec3::ZERO, Vec3::new(1.0, -0.0, 0.0), -Vec3::ZERO, Vec3::Y];
        assert_eq!(Weld::of(&places), [0, 1, 0, 1, 2]);
    }
}

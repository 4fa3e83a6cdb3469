//! Mailboxes: a triangle that lies in several cells is tested once a ray (Amanatides and Woo, "A Fast
//! Voxel Traversal Algorithm for Ray Tracing", 1987; Arnaldi, Priol, Bouatouch, 1987).

/// The number of the last ray that was tested against each triangle.
#[derive(Debug, Default)]
pub struct Mailboxes {
    last: Vec<u32>,
    ray: u32,
    fresh: Vec<u32>,
}

impl Mailboxes {
    /// Of so many triangles, all empty.
    pub fn new(triangles: usize) -> Self {
        Mailboxes { last: vec![0; triangles], ray: 0, fresh: Vec::new() }
    }

    /// The next ray.
    pub fn begin(&mut self) {
        self.ray = self.ray.wrapping_add(1);
        if self.ray == 0 {
            // After 2^32 rays: old numbers must not be taken for new ones.
            self.last.fill(0);
            self.ray = 1;
        }
    }

    /// Those that the ray has not been tested against, which from now on it has.
    pub fn fresh(&mut self, indices: &[u32]) -> &[u32] {
        self.fresh.clear();
        for &index in indices {
            let last = &mut self.last[index as usize];
            if *last != self.ray {
                *last = self.ray;
                self.fresh.push(index);
            }
        }
        &self.fresh
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_fresh_once_a_ray() {
        let mut mailboxes = Mailboxes::new(4);
        for _ in 0..2 {
            mailboxes.begin();
            assert_eq!(mailboxes.fresh(&[0, 2]), [0, 2]);
            assert_eq!(mailboxes.fresh(&[2, 3, 0, 1]), [3, 1]);
        }
        mailboxes.ray = u32::MAX;
        mailboxes.begin();
        assert_eq!(mailboxes.fresh(&[1]), [1]);
    }
}

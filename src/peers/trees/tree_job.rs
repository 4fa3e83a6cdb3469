//! A hierarchy of another crate behind a [`Job`].

use super::Tree;
use crate::job::{Answer, Block, Job, Tally};
use crate::workload::{self, Triangle};

/// Rays, one after the other, through a hierarchy of another crate. Its tallies hold distances alone: the
/// walks of others do not tell u and v.
pub struct TreeJob<T: Tree> {
    tree: T,
    original: Vec<T::Ray>,
    rays: Vec<T::Ray>,
}

impl<T: Tree> TreeJob<T> {
    /// The nearest hit of each ray.
    pub fn new(triangles: &[Triangle], rays: &[workload::Ray]) -> Self {
        let rays: Vec<T::Ray> = rays.iter().map(T::ray).collect();
        TreeJob { tree: T::build(triangles), original: rays.clone(), rays }
    }
}

impl<T: Tree> Job for TreeJob<T> {
    fn items(&self) -> usize {
        self.rays.len()
    }

    /// Rays, not tests.
    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        let mut tally = Tally::default();
        let (passes, in_a_row) =
            if block.literal { (1, block.repeats) } else { (block.repeats, 1) };
        for _ in 0..passes {
            for ray in &self.rays[block.first..][..block.items] {
                for _ in 0..in_a_row {
                    if let Some((_, t)) = self.tree.nearest(ray) {
                        tally.hits += 1;
                        tally.bits[0] = tally.bits[0].wrapping_add(t.to_bits().into());
                    }
                }
            }
        }
        tally
    }

    fn permute(&mut self, permutation: &[u32]) {
        for (place, from) in self.rays.iter_mut().zip(permutation) {
            *place = self.original[*from as usize];
        }
    }

    fn answers(&mut self) -> Vec<Answer> {
        let answer = |ray: &T::Ray| {
            self.tree.nearest(ray).map_or_else(Answer::default, |(triangle, t)| Answer {
                triangle: Some(triangle as usize),
                t: t.into(),
                ..Answer::default()
            })
        };
        self.original.iter().map(answer).collect()
    }
}

//! A search: a ray on its way through a structure.

use super::best::{Best, Hit};
use super::mailbox::Mailboxes;
use super::volume::Volume;
use super::{Beam, Counts, Leaf, Structure};
use crate::workload::Ray;

/// A node or a cell that is still to be looked into.
#[derive(Clone, Copy, Debug)]
pub struct Visit {
    /// Where the ray enters it, at the latest.
    pub near: f64,
    /// Where the ray leaves it, at the earliest (subdivisions of space only).
    pub far: f64,
    /// Its index.
    pub node: u32,
}

/// The triangles of one kernel, the search for one ray among them, and what it costs. Memory that
/// searches need is kept from one to the next.
pub struct Search {
    leaf: Box<dyn Leaf>,
    counts: Counts,
    best: Best,
    ends_at_any: bool,
    mailboxes: Mailboxes,
    stack: Vec<Visit>,
}

impl Search {
    /// Of those triangles.
    pub fn new(leaf: Box<dyn Leaf>) -> Self {
        let mailboxes = Mailboxes::new(leaf.triangles());
        let best = Best::nothing(0.0);
        let (counts, stack) = (Counts::default(), Vec::new());
        Search { leaf, counts, best, ends_at_any: false, mailboxes, stack }
    }

    /// The triangles.
    pub fn leaf(&self) -> &dyn Leaf {
        self.leaf.as_ref()
    }

    /// Counts from nothing again.
    pub fn forget(&mut self) {
        self.counts = Counts::default();
    }

    /// What all searches so far did, or those since it was made to forget.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// The nearest hit: of those that the kernel finds the one with the smallest t, and of several at one
    /// distance the one with the lowest index. `structure` holds the triangles of the leaf.
    pub fn nearest(&mut self, structure: &dyn Structure, ray: &Ray) -> Option<Hit> {
        self.ends_at_any = false;
        self.run(structure, ray)
    }

    /// Whether there is any hit.
    pub fn any(&mut self, structure: &dyn Structure, ray: &Ray) -> bool {
        self.ends_at_any = true;
        self.run(structure, ray).is_some()
    }

    fn run(&mut self, structure: &dyn Structure, ray: &Ray) -> Option<Hit> {
        self.counts.rays += 1;
        let segment = self.leaf.is_segment();
        let beam = if segment { Beam::of_segment(ray) } else { Beam::of_ray(ray) }?;
        self.leaf.aim(ray);
        // It was an f32.
        self.best = Best::nothing(beam.t_max as f32);
        self.mailboxes.begin();
        structure.walk(&beam, self);
        let hit = self.best.hit();
        self.counts.hits += u64::from(hit.is_some());
        hit
    }

    /// Nothing that begins beyond this is wanted.
    #[inline(always)]
    pub fn bound(&self) -> f64 {
        self.best.bound()
    }

    /// Tests a volume: where the ray enters it, if it meets it where a hit is still wanted.
    #[inline(always)]
    pub fn enter<V: Volume>(&mut self, volume: &V, beam: &Beam, aim: &V::Aim) -> Option<f64> {
        self.enter_by(|bound| volume.hit(beam, aim, bound))
    }

    /// [`Search::enter`] of what is no [`Volume`]: where it is entered, if that is within the bound that
    /// it is given.
    #[inline(always)]
    pub fn enter_by(&mut self, hit: impl FnOnce(f64) -> Option<f64>) -> Option<f64> {
        let near = hit(self.best.bound());
        self.counts.volumes += 1;
        self.counts.passed += u64::from(near.is_some());
        near
    }

    /// Tests triangles. Whether the search is over.
    #[inline(always)]
    pub fn test(&mut self, indices: &[u32]) -> bool {
        self.counts.triangles += indices.len() as u64;
        self.leaf.test(indices, &mut self.best);
        self.ends_at_any && self.best.hit().is_some()
    }

    /// [`Search::test`] of those that this ray has not been tested against, in a cell.
    pub fn test_once(&mut self, indices: &[u32]) -> bool {
        self.counts.cells += 1;
        let fresh = self.mailboxes.fresh(indices);
        let fresh_count = fresh.len() as u64;
        self.counts.triangles += fresh_count;
        self.counts.mailed += indices.len() as u64 - fresh_count;
        self.leaf.test(fresh, &mut self.best);
        self.ends_at_any && self.best.hit().is_some()
    }

    /// Counts a node that is opened.
    #[inline(always)]
    pub fn open(&mut self) {
        self.counts.nodes += 1;
    }

    /// An empty stack; to be given back.
    pub fn take_stack(&mut self) -> Vec<Visit> {
        std::mem::take(&mut self.stack)
    }

    /// Keeps the stack for the next ray.
    pub fn give_back(&mut self, mut stack: Vec<Visit>) {
        stack.clear();
        self.stack = stack;
    }
}

/// Sorts so that the nearest is popped first; of several as near, the one that was pushed first.
#[inline(always)]
pub fn farthest_first(visits: &mut [Visit]) {
    // Few, and nearly always no more than eight.
    for end in 1..visits.len() {
        let mut place = end;
        while place > 0 && visits[place - 1].near <= visits[place].near {
            visits.swap(place - 1, place);
            place -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_is_last_and_ties_keep_their_order() {
        let visit = |near, node| Visit { near, far: 0.0, node };
        let mut visits = [visit(2.0, 0), visit(1.0, 1), visit(3.0, 2), visit(1.0, 3)];
        farthest_first(&mut visits);
        assert_eq!(visits.map(|visit| visit.node), [2, 0, 3, 1]);
    }
}

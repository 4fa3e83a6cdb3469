//! A structure, a kernel and rays behind a [`Job`]: what a clock is put to.

use super::{Counts, Leaf, Search, Structure};
use crate::job::{Answer, Block, Job, Tally};
use crate::workload::Ray;
use std::rc::Rc;

/// Rays, one after the other, through a structure.
pub struct StructureJob {
    structure: Rc<dyn Structure>,
    search: Search,
    original: Vec<Ray>,
    rays: Vec<Ray>,
    any: bool,
}

impl StructureJob {
    /// The nearest hit of each ray, or with `any` whether there is one. `structure` holds the triangles of
    /// `leaf`; jobs of other rays may share it.
    pub fn new(
        structure: impl Into<Rc<dyn Structure>>,
        leaf: Box<dyn Leaf>,
        rays: &[Ray],
        any: bool,
    ) -> Self {
        let (search, original) = (Search::new(leaf), rays.to_vec());
        StructureJob { structure: structure.into(), search, rays: original.clone(), original, any }
    }

    /// What one pass over all rays does.
    pub fn counts(&mut self) -> Counts {
        self.search.forget();
        for ray in &self.original {
            one(&mut self.search, self.structure.as_ref(), ray, self.any);
        }
        self.search.counts()
    }
}

/// A job that knows how much memory it searches.
pub trait SearchJob: Job {
    /// Bytes of the structure, and of what is stored of its triangles.
    fn bytes(&self) -> [usize; 2];
}

impl SearchJob for StructureJob {
    fn bytes(&self) -> [usize; 2] {
        [self.structure.bytes(), self.search.leaf().bytes()]
    }
}

/// The tally of one ray.
fn one(search: &mut Search, structure: &dyn Structure, ray: &Ray, any: bool) -> Tally {
    let mut tally = Tally::default();
    if any {
        tally.hits = u64::from(search.any(structure, ray));
    } else if let Some(hit) = search.nearest(structure, ray) {
        tally.hits = 1;
        let [t, u, v] = [hit.t, hit.u, hit.v].map(|number| u64::from(number.to_bits()));
        tally.bits = [t, u, v, 0, 0, 0, 0, 0, 0];
    }
    tally
}

impl Job for StructureJob {
    fn items(&self) -> usize {
        self.rays.len()
    }

    /// Rays, not tests: how many tests they take is what the structure is for.
    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        let rays = &self.rays[block.first..][..block.items];
        let (passes, in_a_row) =
            if block.literal { (1, block.repeats) } else { (block.repeats, 1) };
        let mut tally = Tally::default();
        for _ in 0..passes {
            for ray in rays {
                for _ in 0..in_a_row {
                    let found = one(&mut self.search, self.structure.as_ref(), ray, self.any);
                    tally = tally.plus(found);
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
        let (search, structure, any) = (&mut self.search, self.structure.as_ref(), self.any);
        let mut answer = |ray: &Ray| {
            if any {
                let triangle = search.any(structure, ray).then_some(0);
                return Answer { triangle, ..Answer::default() };
            }
            search.nearest(structure, ray).map_or_else(Answer::default, Answer::from)
        };
        self.original.iter().map(&mut answer).collect()
    }
}

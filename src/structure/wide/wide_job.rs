//! The fast path behind a [`Job`].

use super::group::records;
use super::tree::Wide;
use super::walk::{Batches, Waiting};
use crate::batch::Aligned;
use crate::job::{Answer, Block, Job, Tally};
use crate::kernels::Kernel;
use crate::policy::Ray;
use crate::structure::leaf::aimed;
use crate::structure::{Hit, SearchJob, from_obvhs};
use crate::workload::{self, Triangle};

/// A compiled loop over a batch of rays.
pub type WideLoop<const W: usize> = fn(Batches<'_, W>);

/// A wide tree, the records of one kernel, and rays.
pub struct WideJob<const W: usize> {
    tree: Wide<W>,
    records: Aligned<f32>,
    original: Vec<workload::Ray>,
    drawn: Vec<workload::Ray>,
    rays: Vec<Ray<f32>>,
    any: bool,
    answers: Vec<Option<Hit>>,
    stack: Vec<Waiting>,
    run: WideLoop<W>,
}

impl<const W: usize> WideJob<W> {
    /// The nearest hit of each ray, or with `any` whether there is one; `run` is that of kernel `K`.
    pub fn new<K: Kernel>(
        triangles: &[Triangle],
        rays: &[workload::Ray],
        any: bool,
        run: WideLoop<W>,
    ) -> Self {
        let tree = Wide::new(triangles, &from_obvhs(triangles));
        WideJob {
            records: Aligned::new(&records::<K, W>(&tree, triangles)),
            tree,
            original: rays.to_vec(),
            drawn: rays.to_vec(),
            rays: rays.iter().map(aimed).collect(),
            any,
            answers: vec![None; rays.len()],
            stack: Vec::new(),
            run,
        }
    }

    /// The tree.
    pub fn tree(&self) -> &Wide<W> {
        &self.tree
    }

    fn batch(&mut self, first: usize, items: usize) {
        (self.run)(Batches {
            tree: &self.tree,
            records: &self.records,
            drawn: &self.drawn[first..][..items],
            rays: &self.rays[first..][..items],
            any: self.any,
            answers: &mut self.answers[first..][..items],
            stack: &mut self.stack,
        });
    }
}

impl<const W: usize> SearchJob for WideJob<W> {
    fn bytes(&self) -> [usize; 2] {
        [self.tree.bytes(), size_of_val::<[f32]>(&self.records)]
    }
}

/// The tally of some answers.
fn tally(answers: &[Option<Hit>], any: bool) -> Tally {
    let mut tally = Tally::default();
    for hit in answers.iter().flatten() {
        tally.hits += 1;
        if !any {
            for (sum, number) in tally.bits.iter_mut().zip([hit.t, hit.u, hit.v]) {
                *sum = sum.wrapping_add(number.to_bits().into());
            }
        }
    }
    tally
}

impl<const W: usize> Job for WideJob<W> {
    fn items(&self) -> usize {
        self.rays.len()
    }

    /// Rays, not tests.
    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        let mut sum = Tally::default();
        if block.literal {
            for item in block.first..block.first + block.items {
                for _ in 0..block.repeats {
                    self.batch(item, 1);
                    sum = sum.plus(tally(&self.answers[item..][..1], self.any));
                }
            }
        } else {
            for _ in 0..block.repeats {
                self.batch(block.first, block.items);
                sum = sum.plus(tally(&self.answers[block.first..][..block.items], self.any));
            }
        }
        sum
    }

    fn permute(&mut self, permutation: &[u32]) {
        for (place, from) in permutation.iter().enumerate() {
            self.drawn[place] = self.original[*from as usize];
            self.rays[place] = aimed(&self.drawn[place]);
        }
    }

    fn answers(&mut self) -> Vec<Answer> {
        self.drawn.clone_from(&self.original);
        self.rays = self.drawn.iter().map(aimed).collect();
        self.batch(0, self.rays.len());
        self.answers.iter().map(|hit| hit.map_or_else(Answer::default, Answer::from)).collect()
    }
}

impl From<Hit> for Answer {
    fn from(hit: Hit) -> Self {
        Answer {
            triangle: Some(hit.triangle as usize),
            t: hit.t.into(),
            u: hit.u.into(),
            v: hit.v.into(),
            ..Answer::default()
        }
    }
}

//! Prepared pairs behind a [`Job`], generic over kernel and element only.

use std::hint::black_box;
use std::marker::PhantomData;

use super::aligned::Aligned;
use super::pairs::Walk;
use crate::job::{Answer, Block, Job, Tally};
use crate::number::{Element, Vec3};
use crate::policy::Ray;
use crate::workload;

/// A ray of a workload in the precision `E`; infinite bounds become the largest finite number.
pub fn widened<E: Element>(ray: &workload::Ray) -> Ray<E> {
    let vector = |v: glam::Vec3| Vec3(v.to_array().map(E::from_f32));
    let bound = |t: f32| {
        if t >= f32::MAX {
            E::MAX
        } else if t <= -f32::MAX {
            -E::MAX
        } else {
            E::from_f32(t)
        }
    };
    Ray {
        origin: vector(ray.origin),
        direction: vector(ray.direction),
        end: vector(ray.end),
        t_min: bound(ray.t_min),
        t_max: bound(ray.t_max),
    }
}

/// A compiled loop over pairs of any kind.
pub type LoopOver<I> = fn(Walk<'_, I>) -> Tally;

/// The compiled loop of a form over pairs.
pub type PairsLoop<E, T> = LoopOver<(Ray<E>, T)>;

/// Pairs of rays `Q` and records `T` with the loop that tests them, in numbers of the precision `E`.
pub struct PairsJob<E, Q, T> {
    original: Vec<(Q, T)>,
    laid_out: Aligned<(Q, T)>,
    run: LoopOver<(Q, T)>,
    code: fn(&Q, &T) -> u8,
    precision: PhantomData<E>,
}

impl<E: Element, Q: Copy, T: Copy> PairsJob<E, Q, T> {
    /// A job over `pairs`; `code` gives the exit of one test, for answers only.
    pub fn new(pairs: Vec<(Q, T)>, run: LoopOver<(Q, T)>, code: fn(&Q, &T) -> u8) -> Self {
        let laid_out = Aligned::new(&pairs);
        PairsJob { original: pairs, laid_out, run, code, precision: PhantomData }
    }
}

impl<E: Element, Q: Copy, T: Copy> Job for PairsJob<E, Q, T> {
    fn items(&self) -> usize {
        self.original.len()
    }

    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        let mut tally = Tally::default();
        let pairs = &*self.laid_out;
        if block.literal {
            for pair in pairs[block.first..][..block.items].chunks_exact(1) {
                tally = tally.plus((self.run)(Walk { pairs: pair, times: block.repeats }));
            }
        } else {
            let pairs = &pairs[block.first..][..block.items];
            tally = (self.run)(Walk { pairs, times: block.repeats });
        }
        tally
    }

    fn permute(&mut self, permutation: &[u32]) {
        for (place, &from) in self.laid_out.iter_mut().zip(permutation) {
            *place = self.original[from as usize];
        }
    }

    fn relocate(&mut self) {
        self.laid_out.relocate();
    }

    fn touch(&mut self, block: Block) {
        for pair in &self.laid_out[block.first..][..block.items] {
            black_box(*pair);
        }
    }

    fn answers(&mut self) -> Vec<Answer> {
        let mut answers = Vec::with_capacity(self.original.len());
        for (first, (ray, record)) in self.original.iter().enumerate() {
            let pairs = &self.original[first..=first];
            let tally = (self.run)(Walk { pairs, times: 1 });
            let number = |i: usize| E::from_bits(tally.bits[i]).to_f64();
            answers.push(Answer {
                triangle: (tally.hits > 0).then_some(first),
                t: number(0),
                u: number(1),
                v: number(2),
                point: [number(3), number(4), number(5)],
                normal: [number(6), number(7), number(8)],
                code: (self.code)(ray, record),
            });
        }
        answers
    }
}

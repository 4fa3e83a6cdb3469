//! Prepared rays and triangles behind a [`Job`], generic over kernel and element only.

use std::hint::black_box;

use super::batches::lay_out_batches;
use super::best::ANSWER_NUMBERS;
use super::layout::{Aos, Layout, lay_out, length};
use super::nearest::{RAY_NUMBERS, Scene};
use super::nearest_data::{NearestData, Parts};
use super::packed::{self, pack, unpack};
use crate::job::{Answer, Block, Job, Tally};
use crate::number::Element;
use crate::policy::Ray;

/// The compiled loop of a form over rays and all triangles.
pub type NearestLoop<E> = fn(Scene<'_, E>);

/// How a loop over rays and all triangles wants its data.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Rays whose numbers lie side by side: those of a packet.
    pub lanes: usize,
    /// Rays of an item: those of a packet, or of a bundle.
    pub rays: usize,
    /// How many numbers of an answer are reported: 0, t, with u and v, or all 9.
    pub outputs: usize,
}

/// How records are written in a layout.
#[derive(Clone, Copy)]
pub struct Storing<E, T> {
    /// How many numbers records take.
    pub length: fn(&[T]) -> usize,
    /// Writes records into numbers, as many as `length` says.
    pub lay_out: fn(&[T], &mut [E]),
    /// As [`Layout::runs`].
    pub runs: fn(usize) -> usize,
}

impl<E: Element, T: AsRef<[E]>> Storing<E, T> {
    /// In layout `Y`.
    pub fn of<Y: Layout>() -> Self {
        Storing { length: length::<E, T, Y>, lay_out: lay_out::<E, T, Y>, runs: Y::runs }
    }
    /// Triangle by triangle, in batches by the axis of their projection.
    pub fn batches() -> Self {
        Storing { lay_out: lay_out_batches::<E, T>, ..Self::of::<Aos>() }
    }
}

/// Rays and records with the loop that tests them.
pub struct NearestJob<E, T> {
    shape: Shape,
    original: Vec<E>,
    original_records: Vec<T>,
    permuted: Vec<T>,
    storing: Storing<E, T>,
    data: NearestData<E>,
    run: NearestLoop<E>,
}

impl<E: Element, T: Copy> NearestJob<E, T> {
    /// A job over `rays`, whose number is a multiple of the shape's, and `records`.
    pub fn new(
        shape: Shape,
        rays: &[Ray<E>],
        records: Vec<T>,
        storing: Storing<E, T>,
        run: NearestLoop<E>,
    ) -> Self {
        let original = pack(rays, shape.lanes);
        let data = NearestData::new(original.len(), rays.len(), (storing.length)(&records));
        let permuted = records.clone();
        let original_records = records;
        let mut job =
            NearestJob { shape, original, original_records, permuted, storing, data, run };
        job.restore();
        job
    }

    /// Rays and records in their original order.
    fn restore(&mut self) {
        let Parts { rays, records, .. } = self.data.parts();
        rays.copy_from_slice(&self.original);
        (self.storing.lay_out)(&self.original_records, records);
    }
}

impl<E: Element, T: Copy> Job for NearestJob<E, T> {
    fn items(&self) -> usize {
        self.original.len() / (RAY_NUMBERS * self.shape.rays)
    }

    fn tests_per_item(&self) -> u64 {
        (self.shape.rays * self.original_records.len()) as u64
    }

    fn run(&mut self, block: Block) -> Tally {
        let (ray, answer) = (RAY_NUMBERS * self.shape.rays, ANSWER_NUMBERS * self.shape.rays);
        let mut tally = Tally::default();
        let Parts { rays, answers, records } = self.data.parts();
        let mut run = |first: usize, items: usize| {
            let scene = Scene {
                rays: &rays[first * ray..(first + items) * ray],
                numbers: records,
                triangles: self.original_records.len(),
                answers: &mut answers[first * answer..(first + items) * answer],
            };
            (self.run)(scene);
            let found = &answers[first * answer..(first + items) * answer];
            tally = tally.plus(packed::tally(found, self.shape.lanes, self.shape.outputs));
        };
        if block.literal {
            for first in block.first..block.first + block.items {
                (0..block.repeats).for_each(|_| run(first, 1));
            }
        } else {
            (0..block.repeats).for_each(|_| run(block.first, block.items));
        }
        tally
    }

    fn permute(&mut self, permutation: &[u32]) {
        let ray = RAY_NUMBERS * self.shape.rays;
        let rays = self.data.parts().rays;
        for (place, &from) in rays.chunks_exact_mut(ray).zip(permutation) {
            place.copy_from_slice(&self.original[from as usize * ray..][..ray]);
        }
    }

    fn shared_records(&self) -> usize {
        self.original_records.len()
    }

    fn permute_shared(&mut self, permutation: &[u32]) {
        for (place, &from) in self.permuted.iter_mut().zip(permutation) {
            *place = self.original_records[from as usize];
        }
        (self.storing.lay_out)(&self.permuted, self.data.parts().records);
    }

    fn relocate(&mut self) {
        self.data.relocate();
    }

    fn touch(&mut self, block: Block) {
        let ray = RAY_NUMBERS * self.shape.rays;
        let Parts { rays, records, .. } = self.data.parts();
        for number in rays[block.first * ray..][..block.items * ray].iter().chain(&*records) {
            black_box(*number);
        }
    }

    fn answers(&mut self) -> Vec<Answer> {
        self.restore();
        self.run(Block::whole(self));
        unpack(self.data.parts().answers, self.shape.lanes)
    }
}

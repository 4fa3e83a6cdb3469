//! Prepared rays and triangles behind a [`Job`], generic over kernel and element only.

use std::hint::black_box;

use super::aligned::Aligned;
use super::batches::lay_out_batches;
use super::best::ANSWER_NUMBERS;
use super::layout::{Aos, Layout, lay_out, length};
use super::nearest::{RAY_NUMBERS, Scene};
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
    laid_out: Aligned<E>,
    original_records: Vec<T>,
    permuted: Vec<T>,
    storing: Storing<E, T>,
    numbers: Aligned<E>,
    answers: Aligned<E>,
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
        let mut numbers = vec![E::ZERO; (storing.length)(&records)];
        (storing.lay_out)(&records, &mut numbers);
        NearestJob {
            shape,
            laid_out: Aligned::new(&original),
            original,
            numbers: Aligned::new(&numbers),
            permuted: records.clone(),
            original_records: records,
            storing,
            answers: Aligned::new(&vec![E::ZERO; rays.len() * ANSWER_NUMBERS]),
            run,
        }
    }
}

impl<E: Element, T: Copy> Job for NearestJob<E, T> {
    fn items(&self) -> usize {
        self.laid_out.len() / (RAY_NUMBERS * self.shape.rays)
    }

    fn tests_per_item(&self) -> u64 {
        (self.shape.rays * self.original_records.len()) as u64
    }

    fn run(&mut self, block: Block) -> Tally {
        let (ray, answer) = (RAY_NUMBERS * self.shape.rays, ANSWER_NUMBERS * self.shape.rays);
        let mut tally = Tally::default();
        let mut run = |first: usize, items: usize| {
            let scene = Scene {
                rays: &self.laid_out[first * ray..(first + items) * ray],
                numbers: &self.numbers,
                triangles: self.original_records.len(),
                answers: &mut self.answers[first * answer..(first + items) * answer],
            };
            (self.run)(scene);
            let found = &self.answers[first * answer..(first + items) * answer];
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
        for (place, &from) in self.laid_out.chunks_exact_mut(ray).zip(permutation) {
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
        (self.storing.lay_out)(&self.permuted, &mut self.numbers);
    }

    fn touch(&mut self, block: Block) {
        let ray = RAY_NUMBERS * self.shape.rays;
        for number in &self.laid_out[block.first * ray..][..block.items * ray] {
            black_box(*number);
        }
        for number in self.numbers.iter() {
            black_box(*number);
        }
    }

    fn answers(&mut self) -> Vec<Answer> {
        self.laid_out.copy_from_slice(&self.original);
        (self.storing.lay_out)(&self.original_records, &mut self.numbers);
        self.run(Block::whole(self));
        unpack(&self.answers, self.shape.lanes)
    }
}

//! The preparing of triangles as a [`Job`]: what a kernel stores, made of the corners.

use std::hint::black_box;

use super::aligned::Aligned;
use crate::job::{Answer, Block, Job, Tally};
use crate::kernels::{Corners, Kernel};
use crate::number::Element;

/// Fills the records of triangles, one after the other.
pub type PrepareLoop<E, T> = fn(&[Corners<E>], &mut [T]);

/// The loop of a kernel.
pub fn prepare_all<K: Kernel, E: Element>(corners: &[Corners<E>], records: &mut [K::Record<E>]) {
    for (record, corners) in records.iter_mut().zip(corners) {
        // Several triangles must not be prepared at once, lane by lane.
        black_box(());
        *record = K::prepare(corners);
    }
}

/// Corners, and a buffer for the records made of them. An item is a triangle.
pub struct PrepareJob<E, T> {
    original: Vec<Corners<E>>,
    laid_out: Aligned<Corners<E>>,
    records: Aligned<T>,
    /// Made one by one, by another call than the one that is timed.
    wanted: Vec<T>,
    run: PrepareLoop<E, T>,
}

impl<E: Element, T: AsRef<[E]> + Copy> PrepareJob<E, T> {
    /// A job over these triangles; `prepare` makes what the loop has to make.
    pub fn new(
        corners: Vec<Corners<E>>,
        prepare: fn(&Corners<E>) -> T,
        run: PrepareLoop<E, T>,
    ) -> Self {
        let wanted: Vec<T> = corners.iter().map(prepare).collect();
        PrepareJob {
            laid_out: Aligned::new(&corners),
            original: corners,
            records: Aligned::new(&wanted),
            wanted,
            run,
        }
    }

    /// Sums of the bits of all numbers of the items' records, place by place modulo nine.
    fn tally(&self, first: usize, items: usize) -> Tally {
        let mut tally = Tally { hits: items as u64, ..Tally::default() };
        let places = tally.bits.len();
        for record in &self.records[first..first + items] {
            for (place, number) in record.as_ref().iter().enumerate() {
                let sum = &mut tally.bits[place % places];
                *sum = sum.wrapping_add(number.bits());
            }
        }
        tally
    }
}

impl<E: Element, T: AsRef<[E]> + Copy> Job for PrepareJob<E, T> {
    fn items(&self) -> usize {
        self.original.len()
    }

    fn tests_per_item(&self) -> u64 {
        1
    }

    /// Every triangle is prepared as often as the block says. What is left in the buffer is added up once,
    /// not once per repeat: with the dozens of repeats of a block that is within its noise.
    fn run(&mut self, block: Block) -> Tally {
        let items = block.first..block.first + block.items;
        if block.literal {
            for item in items {
                let (corners, record) =
                    (&self.laid_out[item..=item], &mut self.records[item..=item]);
                (0..block.repeats).for_each(|_| (self.run)(corners, record));
            }
        } else {
            let (corners, records) = (&self.laid_out[items.clone()], &mut self.records[items]);
            (0..block.repeats).for_each(|_| (self.run)(corners, records));
        }
        self.tally(block.first, block.items).times(block.repeats as u64)
    }

    fn relocate(&mut self) {
        self.laid_out.relocate();
        self.records.relocate();
    }

    fn permute(&mut self, permutation: &[u32]) {
        for (place, &from) in self.laid_out.iter_mut().zip(permutation) {
            *place = self.original[from as usize];
        }
    }

    /// An answer per triangle: there, where the loop's record is, bit for bit, the one that it has to
    /// make.
    fn answers(&mut self) -> Vec<Answer> {
        self.laid_out.copy_from_slice(&self.original);
        self.run(Block::whole(self));
        let same = |(found, wanted): (&T, &T)| {
            let numbers = found.as_ref().iter().zip(wanted.as_ref());
            numbers.into_iter().all(|(x, y)| x.bits() == y.bits())
        };
        let pairs = self.records.iter().zip(&self.wanted).map(same).enumerate();
        let answer = |(item, same): (usize, bool)| Answer {
            triangle: same.then_some(item),
            ..Answer::default()
        };
        pairs.map(answer).collect()
    }
}

//! What the measuring half of the program knows of a kernel: a prepared batch behind one pointer.
//!
//! Above this trait nothing is generic; below it nothing is dynamic. One call runs 10^3 tests or
//! more, so the indirect call costs nothing that a clock can see.

use std::hint::black_box;

/// Which part of a job's items one call of [`Job::run`] does, and how often.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// First item (a pair, or a packet of rays).
    pub first: usize,
    /// Number of items from `first` on; `first + items` is at most [`Job::items`].
    pub items: usize,
    /// How often the items are done.
    pub repeats: usize,
    /// `true`: each item `repeats` times in a row before the next (thesis B's loop).
    /// `false`: the whole range from start to end, `repeats` times.
    pub literal: bool,
}

impl Block {
    /// Every item of a job once.
    pub fn whole(job: &dyn Job) -> Self {
        Block { first: 0, items: job.items(), repeats: 1, literal: false }
    }
}

/// What a block found. Sums wrap, do not depend on the order of the items, and grow in step with
/// the repeats, so that every timed block can be compared with the answers that were checked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Number of hits (of rays with a hit, for nearest-hit jobs).
    pub hits: u64,
    /// Sums of the bit patterns of the outputs of hits: t, u, v, then point and normal.
    /// For one item done once they *are* the bit patterns.
    pub bits: [u64; 9],
}

impl Tally {
    /// The tally of `self` done `times` times.
    pub fn times(self, times: u64) -> Self {
        Tally {
            hits: self.hits.wrapping_mul(times),
            bits: self.bits.map(|b| b.wrapping_mul(times)),
        }
    }

    /// The tally of both together.
    pub fn plus(self, other: Self) -> Self {
        let mut bits = self.bits;
        for (sum, b) in bits.iter_mut().zip(other.bits) {
            *sum = sum.wrapping_add(b);
        }
        Tally { hits: self.hits.wrapping_add(other.hits), bits }
    }
}

/// One answer of a kernel, widened to f64. Outputs that the form does not report mean nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Answer {
    /// The triangle that was hit (the nearest one; the only one of a pair).
    pub triangle: Option<usize>,
    /// Distance along the ray in units of its direction.
    pub t: f64,
    /// Weight of vertex b.
    pub u: f64,
    /// Weight of vertex c.
    pub v: f64,
    /// The point that was hit.
    pub point: [f64; 3],
    /// The triangle's normal, of any length.
    pub normal: [f64; 3],
    /// Return code: 0 is a hit, others name the test that failed (0 or 255 where codes are not kept).
    pub code: u8,
}

/// A batch of one variant over one workload, ready to run.
pub trait Job {
    /// Number of items: pairs, or packets of rays (single rays are packets of one).
    fn items(&self) -> usize;
    /// Tests per item: 1 for pairs; lanes x triangles for nearest-hit jobs.
    fn tests_per_item(&self) -> u64;
    /// Does the block. This, and nothing else, is inside the timed window.
    fn run(&mut self, block: Block) -> Tally;
    /// Does the block with one call an item, each waiting for the answer to the one before it:
    /// where the next item lies is computed from that answer.
    fn run_dependent(&mut self, block: Block) -> Tally {
        // Neither the compiler nor the processor knows that this is zero.
        let nothing = black_box(0usize);
        let (passes, in_a_row) =
            if block.literal { (1, block.repeats) } else { (block.repeats, 1) };
        let (mut tally, mut waits) = (Tally::default(), 0);
        for _ in 0..passes {
            for item in block.first..block.first + block.items {
                for _ in 0..in_a_row {
                    let first = item + waits;
                    let found = self.run(Block { first, items: 1, repeats: 1, literal: false });
                    waits = (found.hits ^ found.bits[0]) as usize & nothing;
                    tally = tally.plus(found);
                }
            }
        }
        tally
    }
    /// Moves the data to other pages, for a job that can; no number and no order changes. What lies where
    /// is a matter of chance, and a block that finds it elsewhere each time is not bound to one draw.
    fn relocate(&mut self) {}
    /// Brings the data of the block near, without a test.
    fn touch(&mut self, _block: Block) {}
    /// Brings the caches into the state that walking over all items, again and again, leaves before
    /// `block`. Nothing, for jobs whose data are near anyway.
    fn approach(&mut self, _block: Block) {}
    /// Lays the items out in a new order: item `i` becomes what item `permutation[i]` of the
    /// original order was. Outside the timed window; nothing is run over the new order.
    fn permute(&mut self, permutation: &[u32]);
    /// Number of records that every item is tested against; 0 where each item has its own.
    fn shared_records(&self) -> usize {
        0
    }
    /// Lays the shared records out in a new order, as [`Job::permute`] does the items. Tallies do
    /// not depend on it, and answers are told in the original order.
    fn permute_shared(&mut self, _permutation: &[u32]) {}
    /// The answers in the original order, computed by the very function that `run` times.
    fn answers(&mut self) -> Vec<Answer>;
}

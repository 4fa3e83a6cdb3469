//! Nothing but multiplications and additions: what the arithmetic units of a level can do at most.
//!
//! Twelve sums that do not depend on each other keep two pipelines of four cycles' latency, and
//! more, busy. Without it nobody can tell whether a 512-bit instruction runs in one piece or as
//! two halves, and so how much a packet of sixteen can gain over one of eight.

use std::hint::black_box;
use std::marker::PhantomData;

use super::kind::PLACES;
use super::stream::Stream;
use crate::job::{Answer, Block, Job, Tally};
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real, Toggle};

/// Independent sums.
const SUMS: usize = 12;

/// Multiplications and additions of one item, per lane.
pub const OPERATIONS: u64 = 2 * SUMS as u64;

/// The loop.
pub struct Arithmetic<R>(PhantomData<R>);

impl<L: Level, R: Real + On<L>> Batch<L> for Arithmetic<R> {
    type Data<'a> = usize;
    type Yield = u64;

    #[inline(always)]
    fn run(token: L::Token, items: usize) -> u64 {
        let token = R::token_on(token);
        let one = R::splat(token, black_box(R::Element::ONE));
        let zero = R::splat(token, black_box(R::Element::ZERO));
        let mut sums = [one; SUMS];
        for _ in 0..items {
            for sum in &mut sums {
                *sum = *sum * one + zero;
            }
        }
        let mut lanes = [R::Element::ZERO; super::WIDEST];
        let mut bits = 0u64;
        for sum in sums {
            sum.store(&mut lanes);
            bits = bits.wrapping_add(lanes[0].bits());
        }
        bits
    }
}

/// A loop of arithmetic as a job: an item is one multiplication and addition of every sum.
pub struct ArithmeticJob {
    operations: u64,
    run: fn(usize) -> u64,
}

impl ArithmeticJob {
    /// The loop of a level, over a number that it has natively.
    pub fn new<L: Level, R: Real + On<L>>() -> Self {
        let operations = R::LANES as u64 * OPERATIONS;
        ArithmeticJob { operations, run: L::enter::<Arithmetic<R>, 0> }
    }

    /// The stream of a mix of operations; an item is one walk through its loop.
    pub fn stream<L: Level, R: Toggle + On<L>, const MIX: u64>() -> Self {
        let operations = (R::LANES * PLACES) as u64;
        ArithmeticJob { operations, run: L::enter::<Stream<R, MIX>, 0> }
    }
}

impl Job for ArithmeticJob {
    fn items(&self) -> usize {
        256
    }

    fn tests_per_item(&self) -> u64 {
        self.operations
    }

    /// Numbers stay at 1, so what comes out does not depend on how often they were computed with: the
    /// tally counts calls as hits, and the bits of twelve ones for each.
    fn run(&mut self, block: Block) -> Tally {
        let mut tally = Tally::default();
        let calls = block.items * block.repeats;
        let bits = (self.run)(calls);
        tally.hits = calls as u64;
        tally.bits[0] = bits.wrapping_mul(calls as u64);
        tally
    }

    fn permute(&mut self, _: &[u32]) {}

    fn answers(&mut self) -> Vec<Answer> {
        Vec::new()
    }
}

//! A kernel made slower by work that is known.

use crate::job::{Answer, Block, Job, Tally};
use crate::measure::{CYCLES_PER_STEP, Chain};

/// A job with so many cycles of a dependent chain behind each block: what it takes longer is known
/// without a look at the job. (A share of its own tests once more would be less known: a part of a
/// set out of its place is not foreseen as the whole is, and took a tenth more than its share.)
pub struct Slowed {
    job: Box<dyn Job>,
    cycles_per_test: f64,
}

impl Slowed {
    /// `job` with `cycles_per_test` (at least 0) more cycles for each test.
    pub fn new(job: Box<dyn Job>, cycles_per_test: f64) -> Self {
        Slowed { job, cycles_per_test }
    }

    /// Steps of the chain behind a block.
    fn steps(&self, block: Block) -> usize {
        let tests = (block.items * block.repeats) as f64 * self.job.tests_per_item() as f64;
        (tests * self.cycles_per_test / CYCLES_PER_STEP).round() as usize
    }
}

impl Job for Slowed {
    fn items(&self) -> usize {
        self.job.items()
    }

    fn tests_per_item(&self) -> u64 {
        self.job.tests_per_item()
    }

    fn run(&mut self, block: Block) -> Tally {
        let tally = self.job.run(block);
        let steps = self.steps(block);
        // The chain tells how many steps it did; nobody else should know of them.
        Chain::new(1).run(Block { first: 0, items: 1, repeats: steps, literal: false });
        tally
    }

    fn relocate(&mut self) {
        self.job.relocate();
    }

    fn permute(&mut self, permutation: &[u32]) {
        self.job.permute(permutation);
    }

    fn shared_records(&self) -> usize {
        self.job.shared_records()
    }

    fn permute_shared(&mut self, permutation: &[u32]) {
        self.job.permute_shared(permutation);
    }

    fn answers(&mut self) -> Vec<Answer> {
        self.job.answers()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_cycles_behind_the_block_and_nothing_told_of_them() {
        let mut slowed = Slowed::new(Box::new(Chain::new(100)), 0.4);
        let block = Block { first: 0, items: 100, repeats: 10, literal: false };
        // 1000 tests of 0.4 cycles, two to a step.
        assert_eq!(slowed.steps(block), 200);
        assert_eq!(slowed.run(block).hits, 1000);
        assert_eq!(Slowed::new(Box::new(Chain::new(100)), 0.0).steps(block), 0);
    }
}

//! What the loop around the tests costs by itself.

use crate::job::{Answer, Block, Job, Tally};
use std::hint::black_box;

/// The batch loop without a test in it: one fence where a single-ray kernel has one and a test. Its
/// time is reported beside the kernels', not subtracted: the loop's own instructions run in the
/// shadow of the kernel's.
#[derive(Clone, Debug)]
pub struct EmptyLoop {
    items: usize,
    tests_per_item: u64,
}

impl EmptyLoop {
    /// A loop over as many items, counting as many tests each, as `job` has.
    pub fn like(job: &dyn Job) -> Self {
        EmptyLoop { items: job.items(), tests_per_item: job.tests_per_item() }
    }
}

impl Job for EmptyLoop {
    fn items(&self) -> usize {
        self.items
    }

    fn tests_per_item(&self) -> u64 {
        self.tests_per_item
    }

    // A call, as a kernel's loop is one.
    #[inline(never)]
    fn run(&mut self, block: Block) -> Tally {
        let rounds = block.items as u64 * block.repeats as u64 * self.tests_per_item;
        for _ in 0..rounds {
            black_box(());
        }
        // Zero, but nobody can know before the place of the block is known: driven one by one, a
        // call waits for the one before it as a test does.
        let waits = block.first as u64 & black_box(0);
        Tally { bits: [waits; 9], ..Tally::default() }
    }

    fn permute(&mut self, _permutation: &[u32]) {}

    fn answers(&mut self) -> Vec<Answer> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::Chain;

    #[test]
    fn has_the_shape_of_its_model_and_finds_nothing() {
        let mut empty = EmptyLoop::like(&Chain::new(12));
        assert_eq!((empty.items(), empty.tests_per_item()), (12, 1));
        let whole = Block::whole(&empty);
        assert_eq!(empty.run(whole), Tally::default());
    }
}

//! What a block must find: the items' own tallies, taken one by one before anything is timed.

use crate::job::{Block, Job, Tally};

/// The tallies of all items of a job in its original order, as sums from the first item on.
#[derive(Clone, Debug)]
pub(super) struct Expectation {
    /// `sums[i]` is the tally of the first i items.
    sums: Vec<Tally>,
}

impl Expectation {
    /// Runs every item of `job` once by itself. The job must be in its original order: running
    /// over a new order would show it to the branch predictor.
    pub fn of(job: &mut dyn Job) -> Self {
        let mut sum = Tally::default();
        let mut sums = vec![sum];
        for first in 0..job.items() {
            let block = Block { first, items: 1, repeats: 1, literal: false };
            sum = sum.plus(job.run(block));
            sums.push(sum);
        }
        Expectation { sums }
    }

    /// Hits over all items.
    pub fn hits(&self) -> u64 {
        self.sums.last().map_or(0, |sum| sum.hits)
    }

    /// The tally of `block` over the original order, or over `permutation` of it.
    pub fn block(&self, block: Block, permutation: Option<&[u32]>) -> Tally {
        let end = block.first + block.items;
        let once = match permutation {
            // Every item once, in whatever order: the sum does not depend on it.
            Some(order) if block.items < order.len() => order[block.first..end]
                .iter()
                .map(|&i| self.range(i as usize, i as usize + 1))
                .fold(Tally::default(), Tally::plus),
            _ => self.range(block.first, end),
        };
        once.times(block.repeats as u64)
    }

    fn range(&self, first: usize, end: usize) -> Tally {
        // Times 2^64 - 1 is the negative of a wrapping sum.
        self.sums[end].plus(self.sums[first].times(u64::MAX))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::scripted::{Script, ScriptedJob};

    #[test]
    fn agrees_with_the_job_itself() {
        let script = Script::default();
        let mut job = ScriptedJob::new(&script, 20, 1);
        let expectation = Expectation::of(&mut job);
        for (first, items, repeats) in [(0, 20, 1), (0, 20, 3), (5, 7, 4), (19, 1, 1), (4, 0, 9)] {
            for literal in [false, true] {
                let block = Block { first, items, repeats, literal };
                assert_eq!(expectation.block(block, None), job.run(block));
            }
        }
        let order: Vec<u32> = (0..20).map(|i| (i * 7 + 3) % 20).collect();
        job.permute(&order);
        for items in [20, 6] {
            let block = Block { first: 0, items, repeats: 1, literal: false };
            assert_eq!(expectation.block(block, Some(&order)), job.run(block));
        }
        let six = Block { first: 0, items: 6, repeats: 1, literal: false };
        assert_ne!(expectation.block(six, None), expectation.block(six, Some(&order)));
        assert_eq!(expectation.hits(), 10);
    }
}

//! A kernel made slower by work that is known.

use std::hint::black_box;

use crate::job::{Answer, Block, Job, Tally};

/// A job that does a share more tests than it tells, with the very code of the others: what it
/// takes longer is that share, whatever a test costs. For sets that are replayed.
pub struct Slowed {
    job: Box<dyn Job>,
    share: f64,
    /// Where the additional items begin; moves on, so that all of them have their turn.
    first: usize,
}

impl Slowed {
    /// `job` with `share` (0.02 for 2 %) more tests, at least 0 and below 1.
    pub fn new(job: Box<dyn Job>, share: f64) -> Self {
        Slowed { job, share: share.clamp(0.0, 0.999), first: 0 }
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
        let mut left = (self.share * (block.items * block.repeats) as f64).round() as usize;
        while left > 0 {
            let offset = self.first % block.items;
            let items = left.min(block.items - offset);
            let first = block.first + offset;
            black_box(self.job.run(Block { first, items, repeats: 1, literal: false }));
            self.first = offset + items;
            left -= items;
        }
        tally
    }

    fn permute(&mut self, permutation: &[u32]) {
        self.job.permute(permutation);
    }

    fn answers(&mut self) -> Vec<Answer> {
        self.job.answers()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::Chain;
    use std::cell::RefCell;
    use std::rc::Rc;

    /// A chain that keeps the blocks it ran.
    struct Logged(Chain, Rc<RefCell<Vec<Block>>>);

    impl Job for Logged {
        fn items(&self) -> usize {
            self.0.items()
        }
        fn tests_per_item(&self) -> u64 {
            1
        }
        fn run(&mut self, block: Block) -> Tally {
            self.1.borrow_mut().push(block);
            self.0.run(block)
        }
        fn permute(&mut self, _: &[u32]) {}
        fn answers(&mut self) -> Vec<Answer> {
            Vec::new()
        }
    }

    #[test]
    fn does_a_share_more_of_every_item_and_tells_nothing_of_it() {
        let log = Rc::new(RefCell::new(Vec::new()));
        let job = Logged(Chain::new(100), Rc::clone(&log));
        let mut slowed = Slowed::new(Box::new(job), 0.03);
        let block = Block { first: 0, items: 100, repeats: 10, literal: false };
        for _ in 0..10 {
            assert_eq!(slowed.run(block).hits, 1000);
        }
        let mut times = [0; 100];
        for extra in log.borrow().iter().filter(|block| block.repeats == 1) {
            times[extra.first..extra.first + extra.items].iter_mut().for_each(|n| *n += 1);
        }
        // Thirty of a hundred items each time, ten times: each item three times.
        assert_eq!(times, [3; 100]);
    }
}

//! A job whose every item waits for the answer to the item before it.

use crate::job::{Answer, Block, Job, Tally};

/// The same job, driven for latency: one call an item, and where in memory the next item lies is
/// computed from the answer before it. So the processor cannot begin an item early, as it cannot
/// where a program must know the answer of one leaf before it knows which is the next.
///
/// The call itself and the way of the answer through memory are in the time, as they are in a
/// program's; [`super::EmptyLoop`] driven like this tells how much that is. A kernel that leaves
/// early reports a miss by where it leaves, which a processor foresees: then nothing waits.
pub struct Dependent {
    job: Box<dyn Job>,
}

impl Dependent {
    /// `job`, driven for latency.
    pub fn new(job: Box<dyn Job>) -> Self {
        Dependent { job }
    }
}

impl Job for Dependent {
    fn items(&self) -> usize {
        self.job.items()
    }

    fn tests_per_item(&self) -> u64 {
        self.job.tests_per_item()
    }

    fn run(&mut self, block: Block) -> Tally {
        self.job.run_dependent(block)
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
    use crate::measure::scripted::{Call, Script, ScriptedJob};

    #[test]
    fn finds_what_the_job_finds_one_item_a_call() {
        let script = Script::default();
        for (repeats, literal) in [(1, false), (3, false), (3, true)] {
            let block = Block { first: 2, items: 5, repeats, literal };
            let mut plain = ScriptedJob::new(&script, 9, 1);
            let job = ScriptedJob::new(&script, 9, 1);
            let calls = std::rc::Rc::clone(&job.calls);
            let mut dependent = Dependent::new(Box::new(job));
            assert_eq!(dependent.run(block), plain.run(block));
            let first = |call: &Call| match call {
                Call::Run { block, .. } => (block.first, block.items, block.repeats),
                _ => unreachable!("nothing but runs"),
            };
            let firsts: Vec<_> = calls.borrow().iter().map(first).collect();
            let wanted: Vec<_> = if literal {
                (2..7).flat_map(|i| [(i, 1, 1); 3]).collect()
            } else {
                (0..repeats).flat_map(|_| (2..7).map(|i| (i, 1, 1))).collect()
            };
            assert_eq!(firsts, wanted);
        }
    }
}

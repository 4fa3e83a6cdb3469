//! For tests: a job that moves a scripted clock by a known cost and keeps a log of its calls.

use super::clock::ScriptedClock;
use crate::job::{Answer, Block, Job, Tally};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// One call of a scripted job.
#[derive(Clone, Debug, PartialEq)]
pub enum Call {
    /// `run`, and whether it was between the two readings of a timed window.
    Run { block: Block, timed: bool },
    /// `permute`.
    Permute(Vec<u32>),
    /// `approach`.
    Approach(Block),
    /// `relocate`.
    Relocate,
}

/// What the scripted jobs of a group share.
#[derive(Clone, Debug)]
pub struct Script {
    pub clock: ScriptedClock,
    /// Every cost is multiplied by this: the machine's drift.
    pub slowness: Rc<Cell<u64>>,
    /// Who ran last, by the number in [`ScriptedJob::number`], and how often in a row.
    last: Rc<Cell<(usize, usize)>>,
    /// Jobs made so far.
    jobs: Rc<Cell<usize>>,
    /// (runs to go, ns): that run takes so much longer, once.
    pub hiccup: Rc<Cell<Option<(u64, u64)>>>,
}

impl Default for Script {
    fn default() -> Self {
        let clock = ScriptedClock::new(0);
        Script {
            clock,
            slowness: Rc::new(Cell::new(1)),
            last: Rc::default(),
            jobs: Rc::default(),
            hiccup: Rc::default(),
        }
    }
}

/// Items of which every second one is a hit, at a cost that is known.
pub struct ScriptedJob {
    script: Script,
    cost_ns: u64,
    /// What each call takes besides, however much it does.
    pub once_ns: u64,
    /// Runs with nobody in between before it is known; until then it takes twice the time.
    pub learned_in: usize,
    number: usize,
    order: Vec<u32>,
    tests_per_item: u64,
    /// Timed runs from this one on (counted from 0) find a hit too many.
    pub wrong_from: Option<usize>,
    timed_runs: usize,
    pub calls: Rc<RefCell<Vec<Call>>>,
}

impl ScriptedJob {
    pub fn new(script: &Script, items: usize, cost_ns: u64) -> Self {
        ScriptedJob {
            script: script.clone(),
            cost_ns,
            once_ns: 0,
            learned_in: 0,
            number: script.jobs.replace(script.jobs.get() + 1) + 1,
            order: (0..items as u32).collect(),
            tests_per_item: 1,
            wrong_from: None,
            timed_runs: 0,
            calls: Rc::default(),
        }
    }

    /// Items of so many tests, at the same cost per item.
    pub fn with_tests_per_item(self, tests_per_item: u64) -> Self {
        ScriptedJob { tests_per_item, ..self }
    }

    fn item(original: u32) -> Tally {
        let n = u64::from(original);
        Tally { hits: n % 2, bits: [n.wrapping_mul(0x9e37_79b9_7f4a_7c15) * (n % 2); 9] }
    }
}

impl Job for ScriptedJob {
    fn items(&self) -> usize {
        self.order.len()
    }

    fn tests_per_item(&self) -> u64 {
        self.tests_per_item
    }

    fn run(&mut self, block: Block) -> Tally {
        let script = &self.script;
        let timed = script.clock.readings().get() % 2 == 1;
        self.calls.borrow_mut().push(Call::Run { block, timed });
        let items = block.items as u64 * block.repeats as u64;
        let mut cost = script.slowness.get() * (self.once_ns + self.cost_ns * items);
        let (last, streak) = script.last.get();
        let streak = if last == self.number { streak } else { 0 };
        script.last.set((self.number, streak + 1));
        if streak < self.learned_in {
            cost *= 2;
        }
        match script.hiccup.get() {
            Some((0, more)) => {
                cost += more;
                script.hiccup.set(None);
            }
            Some((runs, more)) => script.hiccup.set(Some((runs - 1, more))),
            None => {}
        }
        let time = script.clock.time();
        time.set(time.get() + cost);
        let range = &self.order[block.first..block.first + block.items];
        let mut tally = range.iter().map(|&i| Self::item(i)).fold(Tally::default(), Tally::plus);
        tally = tally.times(block.repeats as u64);
        if timed {
            tally.hits += u64::from(self.wrong_from.is_some_and(|from| self.timed_runs >= from));
            self.timed_runs += 1;
        }
        tally
    }

    fn approach(&mut self, block: Block) {
        self.calls.borrow_mut().push(Call::Approach(block));
    }

    fn relocate(&mut self) {
        self.calls.borrow_mut().push(Call::Relocate);
    }

    fn permute(&mut self, permutation: &[u32]) {
        self.calls.borrow_mut().push(Call::Permute(permutation.to_vec()));
        self.order = permutation.to_vec();
    }

    fn answers(&mut self) -> Vec<Answer> {
        Vec::new()
    }
}

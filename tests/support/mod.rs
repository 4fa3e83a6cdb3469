//! Experiments run by tests: from TOML to rows, on a clock that tells what it is told.
#![allow(dead_code, reason = "no test needs all of it")]

use std::sync::atomic::{AtomicBool, Ordering};

use ray_test::experiment::{
    Bench, Experiment, Keep, KeepNothing, Outcome, Patience, Pieces, Plan, RunError, run,
};
use ray_test::measure::{NoCounters, NoRuler, Remember, ScriptedClock, Undisturbed};
use ray_test::table::{Row, TableError};

/// Keeps pieces in memory.
#[derive(Default)]
pub struct Memory(pub Vec<(String, Vec<Row>)>);

/// The same while a run goes on; it hands out what was there before.
pub struct OfRun<'a> {
    memory: &'a mut Memory,
    before: Pieces,
}

impl<'a> OfRun<'a> {
    pub fn new(memory: &'a mut Memory) -> Self {
        let before = Pieces(memory.0.clone());
        OfRun { memory, before }
    }
}

impl Keep for OfRun<'_> {
    fn is_kept(&self, piece: &str) -> bool {
        self.before.has(piece)
    }

    fn hand_out(&mut self, piece: &str) -> Option<Vec<Row>> {
        self.before.take(piece)
    }

    fn hand_out_rest(&mut self) -> Vec<Row> {
        self.before.take_rest()
    }

    fn keep(&mut self, piece: &str, rows: &[Row]) -> Result<(), TableError> {
        assert!(self.memory.0.iter().all(|(name, _)| name != piece), "{piece} is kept twice");
        self.memory.0.push((piece.to_owned(), rows.to_owned()));
        Ok(())
    }
}

/// The plan of an experiment, or what is wrong with it.
pub fn plan(text: &str) -> Result<Plan, String> {
    let experiment = Experiment::parse("test.toml", text).map_err(|error| error.to_string())?;
    Plan::new("test.toml", experiment, None).map_err(|error| error.to_string())
}

/// Runs an experiment in so many rounds, cancelled after so many blocks; every reading of the clock is
/// a block after the one before.
pub fn attempt(
    text: &str,
    rounds: usize,
    blocks: usize,
    keep: &mut dyn Keep,
) -> Result<Outcome, RunError> {
    let plan = plan(text).expect("the test's own text");
    let cancel = AtomicBool::new(blocks == 0);
    let mut done = 0;
    let mut progress = |more| {
        done += more;
        cancel.store(done >= blocks, Ordering::Relaxed);
    };
    let mut bench = Bench {
        rounds,
        calls: true,
        // The clock moves by its readings, not by work.
        guards: false,
        patience: &mut Patience::NONE.clone(),
        clock: &mut ScriptedClock::new(60_000),
        disturbance: &mut Undisturbed,
        counters: &mut NoCounters,
        forget: &mut Remember,
        ruler: &mut NoRuler,
        progress: &mut progress,
        cancel: &cancel,
        keep,
    };
    run(&plan, &mut bench)
}

/// The same in 16 rounds, where it must succeed.
pub fn run_until(text: &str, blocks: usize, memory: &mut Memory) -> Outcome {
    attempt(text, 16, blocks, &mut OfRun::new(memory)).expect("a workload that can be drawn")
}

/// To its end, in so many rounds.
pub fn run_all(text: &str, rounds: usize) -> Outcome {
    attempt(text, rounds, usize::MAX, &mut KeepNothing).expect("a workload that can be drawn")
}

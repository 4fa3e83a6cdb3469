//! Runs a planned experiment.

use std::sync::atomic::Ordering;

use super::bench::Bench;
use super::cells::{self, Cell, Measured, Piece};
use super::keep::KeepError;
use super::plan::Plan;
use super::rows::{put_percent_slower, put_seconds_mean};
use super::scene::Scene;
use super::workload::Workload;
use super::{
    arithmetic, bounds, clock_free, codes, memory, pictures, points, precompute, prices, search,
    together, useful,
};
use crate::measure::{Order, ProtocolError};
use crate::shard::Shard;
use crate::table::Row;
use crate::workload::WorkloadError;

/// What came of an experiment.
#[derive(Default)]
pub struct Outcome {
    /// Every row.
    pub rows: Vec<Row>,
    /// Of a shard: where each row stands in the whole, as the number of its task; empty otherwise.
    pub places: Vec<u64>,
    /// Ids of variants that gave a wrong answer where they claim a right one.
    pub wrong: Vec<String>,
    /// Whether it was interrupted.
    pub interrupted: bool,
}

/// Why an experiment cannot be run to its end.
#[derive(Debug, thiserror::Error)]
#[error("{experiment}: {trouble}")]
pub struct RunError {
    /// The experiment.
    pub experiment: String,
    /// Why.
    pub trouble: Box<Trouble>,
}

/// What can go wrong on the way.
#[derive(Debug, thiserror::Error)]
pub enum Trouble {
    /// A workload cannot be drawn.
    #[error(transparent)]
    Workload(#[from] WorkloadError),
    /// A group cannot be measured.
    #[error(transparent)]
    Protocol(#[from] ProtocolError),
    /// Rows cannot be kept, or those that were kept not be taken back.
    #[error(transparent)]
    Keep(#[from] KeepError),
}

/// Runs all cells; ends with the block that is being measured once cancelled.
///
/// # Errors
/// For workloads that cannot be drawn, groups that cannot be measured, and rows that cannot be
/// kept or are of another workload.
pub fn run(plan: &Plan, bench: &mut Bench<'_>) -> Result<Outcome, RunError> {
    let experiment = || plan.experiment.id.clone();
    run_all(plan, bench)
        .map_err(|trouble| RunError { experiment: experiment(), trouble: Box::new(trouble) })
}

fn run_all(plan: &Plan, bench: &mut Bench<'_>) -> Result<Outcome, Trouble> {
    let (id, seed) = (&plan.experiment.id, plan.experiment.seed);
    let mut outcome = Outcome::default();
    let streams = if plan.experiment.bounds { bounds::run(id, seed, bench)? } else { Vec::new() };
    match &plan.experiment.workload {
        // Without a clock, below: nothing that needs to be kept.
        Workload::Counts | Workload::Errors(_) => {}
        Workload::Codes(codes) => {
            outcome.take(codes::run(id, &plan.variants, codes, seed, bench)?);
        }
        Workload::Memory(sets) => outcome.take(memory::run(plan, sets, bench)?),
        Workload::Precompute(forms) => outcome.take(precompute::run(plan, forms, bench)?),
        Workload::Structures(sets) => outcome.take(search::run(plan, sets, bench)?),
        Workload::Pictures(sets) => outcome.take(pictures::run(plan, sets, bench)?),
        Workload::Arithmetic => outcome.rows = arithmetic::run(id, seed, bench)?,
        _ => run_cells(plan, bench, &mut outcome)?,
    }
    // Interrupted again, it still has what it had before.
    if bench.cancel.load(Ordering::Relaxed) {
        outcome.rows.extend(bench.keep.hand_out_rest());
    }
    bounds::put(&mut outcome.rows, &plan.variants, &streams);
    outcome.rows.extend(streams);
    finish(plan, &mut outcome.rows);
    let clock_free = clock_free::rows(plan, Shard::WHOLE, bench.cancel)?;
    outcome.rows.extend(clock_free.into_iter().map(|(_, row)| row));
    outcome.interrupted = bench.cancel.load(Ordering::Relaxed);
    Ok(outcome)
}

/// Runs the cells of workloads that have some; the groups of as many as are enough take turns.
fn run_cells(plan: &Plan, bench: &mut Bench<'_>, outcome: &mut Outcome) -> Result<(), Trouble> {
    let (mut cells, mut pieces, mut scenes) = (Vec::new(), Vec::new(), Vec::new());
    for (number, (density, order)) in plan.cells().into_iter().enumerate() {
        if bench.cancel.load(Ordering::Relaxed) {
            break;
        }
        let scene = scene(plan, density, order)?;
        let density = density.map_or(String::new(), |density| format!(" {density}"));
        // The number alone would do; the rest is for whoever reads the journal.
        let name = format!("cell {number} {order}{density}");
        let (new, whole) = prepare_cell(plan, (&scene, order), bench, name, &mut cells)?;
        pieces.extend(new);
        scenes.push((scene, whole));
        if together::is_enough(&pieces, &cells, bench.rounds) {
            together::measure(std::mem::take(&mut pieces), &mut cells, bench)?;
            finish_cells(plan, (&mut cells, &mut scenes), bench, outcome)?;
        }
    }
    together::measure(pieces, &mut cells, bench)?;
    finish_cells(plan, (&mut cells, &mut scenes), bench, outcome)
}

/// Prepares a cell. One with priced forms is kept in one piece, since prices are made of all its
/// samples; gives the name under which that is still to be done.
fn prepare_cell(
    plan: &Plan,
    (scene, order): (&Scene, Order),
    bench: &mut Bench<'_>,
    name: String,
    cells: &mut Vec<Cell>,
) -> Result<(Vec<Piece>, Option<String>), Trouble> {
    let (id, variants) = (&plan.experiment.id, &plan.variants);
    let in_one = has_prices(plan);
    if in_one && let Some(rows) = bench.take_cell(&name, scene.facts.hash)? {
        bench.pass_over(variants.len());
        let wrong = rows.iter().filter(|row| row.status == "wrong-result");
        let wrong = wrong.map(|row| row.id.clone()).collect();
        let measured = Measured { rows, figures: Vec::new(), wrong };
        cells.push(Cell::new(scene, order, measured));
        return Ok((Vec::new(), None));
    }
    let kept_as = (!in_one).then_some(name.as_str());
    let pieces =
        cells::prepare(id, variants, plan.reference, (scene, order), bench, kept_as, cells)?;
    Ok((pieces, in_one.then_some(name)))
}

fn has_prices(plan: &Plan) -> bool {
    plan.variants.iter().any(|variant| !variant.axes.priced.is_empty())
}

/// What is made of all rows and samples of each cell.
fn finish_cells(
    plan: &Plan,
    (cells, scenes): (&mut Vec<Cell>, &mut Vec<(Scene, Option<String>)>),
    bench: &mut Bench<'_>,
    outcome: &mut Outcome,
) -> Result<(), Trouble> {
    for (cell, (scene, whole)) in cells.drain(..).zip(scenes.drain(..)) {
        let mut measured = cell.measured;
        if let Some(name) = whole {
            let priced = prices::rows(&measured.rows, &measured.figures, &plan.variants);
            measured.rows.extend(priced);
            if !bench.cancel.load(Ordering::Relaxed) {
                let all: Vec<usize> = (0..measured.rows.len()).collect();
                bench.keep_piece(&name, &all, &measured.rows)?;
            }
        }
        useful::put(&mut measured.rows, &scene);
        outcome.take(measured);
    }
    Ok(())
}

impl Outcome {
    fn take(&mut self, measured: Measured) {
        self.rows.extend(measured.rows);
        for id in measured.wrong {
            if !self.wrong.contains(&id) {
                self.wrong.push(id);
            }
        }
    }
}

fn scene(plan: &Plan, density: Option<f64>, order: Order) -> Result<Scene, WorkloadError> {
    let seed = plan.experiment.seed;
    match &plan.experiment.workload {
        Workload::Pairs(pairs) => Scene::pairs(pairs, density.unwrap_or(0.5), order, seed),
        Workload::Points(points) => points::scene(points, density.unwrap_or(0.5), order, seed),
        Workload::Nearest(nearest) => Scene::nearest(nearest, density, order, seed),
        Workload::Codes(_)
        | Workload::Counts
        | Workload::Arithmetic
        | Workload::Errors(_)
        | Workload::Memory(_)
        | Workload::Precompute(_)
        | Workload::Structures(_)
        | Workload::Pictures(_) => {
            unreachable!("these have no cells")
        }
    }
}

/// Columns that need all rows: seconds of the thesis's number of tests, and its percentages.
fn finish(plan: &Plan, rows: &mut [Row]) {
    let seconds_of_tests = match &plan.experiment.workload {
        Workload::Pairs(pairs) => pairs.seconds_of_tests,
        Workload::Codes(_) => Some(THESIS_TESTS),
        _ => None,
    };
    if let Some(tests) = seconds_of_tests {
        for row in rows.iter_mut() {
            row.seconds = row.ns_per_test.map(|ns| ns * tests * 1e-9);
        }
        if matches!(plan.experiment.workload, Workload::Pairs(_)) {
            put_percent_slower(rows);
            put_seconds_mean(rows);
        }
    }
}

/// 25 000 triangles, 20 000 times each: what a cell of thesis B's tables took.
const THESIS_TESTS: f64 = 5e8;

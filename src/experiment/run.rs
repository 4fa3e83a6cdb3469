//! Runs a planned experiment.

use std::sync::atomic::Ordering;

use super::cells::{self, Bench, Measured};
use super::codes::{self, CodesError};
use super::plan::Plan;
use super::rows::put_percent_slower;
use super::scene::Scene;
use super::workload::Workload;
use super::{arithmetic, counts, points, prices};
use crate::measure::{Order, ProtocolError};
use crate::table::Row;
use crate::workload::WorkloadError;

/// What came of an experiment.
#[derive(Default)]
pub struct Outcome {
    /// Every row.
    pub rows: Vec<Row>,
    /// Ids of variants that gave a wrong answer where they claim a right one.
    pub wrong: Vec<String>,
    /// Whether it was interrupted.
    pub interrupted: bool,
}

/// Why an experiment cannot be run to its end.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// A workload cannot be drawn.
    #[error("{experiment}: {source}")]
    Workload {
        /// The experiment.
        experiment: String,
        /// Why.
        source: WorkloadError,
    },
    /// A group cannot be measured.
    #[error("{experiment}: {source}")]
    Protocol {
        /// The experiment.
        experiment: String,
        /// Why.
        source: ProtocolError,
    },
}

/// Runs all cells; stops between cells once cancelled.
///
/// # Errors
/// For workloads that cannot be drawn and groups that cannot be measured.
pub fn run(plan: &Plan, bench: &mut Bench<'_>) -> Result<Outcome, RunError> {
    let experiment = &plan.experiment;
    let workload_error = |source| RunError::Workload { experiment: experiment.id.clone(), source };
    let protocol_error = |source| RunError::Protocol { experiment: experiment.id.clone(), source };
    let mut outcome = Outcome::default();
    match &experiment.workload {
        Workload::Counts => {
            let rows = counts::rows(&experiment.id, experiment.seed);
            outcome.rows = rows.map_err(workload_error)?;
        }
        Workload::Codes(codes) => {
            let measured =
                codes::run(&experiment.id, &plan.variants, codes, experiment.seed, bench).map_err(
                    |error| match error {
                        CodesError::Workload(source) => workload_error(source),
                        CodesError::Protocol(source) => protocol_error(source),
                    },
                )?;
            outcome.take(measured);
        }
        Workload::Arithmetic => {
            let rows = arithmetic::run(&experiment.id, experiment.seed, bench);
            outcome.rows = rows.map_err(protocol_error)?;
        }
        _ => {
            for (density, order) in plan.cells() {
                if bench.cancel.load(Ordering::Relaxed) {
                    break;
                }
                let scene = scene(plan, density, order).map_err(workload_error)?;
                let (id, variants) = (&experiment.id, &plan.variants);
                let mut measured = cells::run(id, variants, plan.reference, &scene, order, bench)
                    .map_err(protocol_error)?;
                let priced = prices::rows(&measured.rows, &measured.figures, variants);
                measured.rows.extend(priced);
                outcome.take(measured);
            }
        }
    }
    finish(plan, &mut outcome.rows);
    outcome.interrupted = bench.cancel.load(Ordering::Relaxed);
    Ok(outcome)
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
        Workload::Nearest(nearest) => Scene::nearest(nearest, order, seed),
        Workload::Codes(_) | Workload::Counts | Workload::Arithmetic => {
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
        }
    }
}

/// 25 000 triangles, 20 000 times each: what a cell of thesis B's tables took.
const THESIS_TESTS: f64 = 5e8;

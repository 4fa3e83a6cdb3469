//! What of an experiment needs no clock: the same rows on every machine, and in shares if wanted.

use std::sync::atomic::{AtomicBool, Ordering};

use super::plan::Plan;
use super::run::{Outcome, RunError};
use super::workload::{PairsWorkload, Workload};
use super::{counts, errors, search, stiff};
use crate::shard::Shard;
use crate::table::Row;
use crate::workload::WorkloadError;

/// A row, and the number of its task in the list of all tasks: sorted by that, the rows of all
/// shards stand as in the whole. A task makes one row or several.
pub type Placed = (u64, Row);

/// Whether an experiment has such rows, and whether it has others.
pub fn is_clock_free(workload: &Workload) -> (bool, bool) {
    match workload {
        Workload::Counts | Workload::Errors(_) => (true, false),
        Workload::Pairs(PairsWorkload { errors, stiff, .. }) => {
            (errors.is_some() || stiff.is_some(), true)
        }
        Workload::Structures(sets) => (sets.counted.is_some(), true),
        _ => (false, true),
    }
}

/// Runs a share of what needs no clock, and says where its rows stand in the whole.
///
/// # Errors
/// For workloads that cannot be drawn.
pub fn run_shard(plan: &Plan, shard: Shard, cancel: &AtomicBool) -> Result<Outcome, RunError> {
    let failed = |trouble: WorkloadError| RunError {
        experiment: plan.experiment.id.clone(),
        trouble: Box::new(trouble.into()),
    };
    let placed = rows(plan, shard, cancel).map_err(failed)?;
    let (places, rows) = placed.into_iter().unzip();
    let interrupted = cancel.load(Ordering::Relaxed);
    Ok(Outcome { rows, places, wrong: Vec::new(), interrupted })
}

/// The rows of a share; none where an experiment has none. Once cancelled, fewer.
///
/// # Errors
/// As drawing.
pub(super) fn rows(
    plan: &Plan,
    shard: Shard,
    cancel: &AtomicBool,
) -> Result<Vec<Placed>, WorkloadError> {
    let (id, seed, variants) = (&plan.experiment.id, plan.experiment.seed, &plan.variants);
    let errors = |hits| errors::rows(id, variants, hits, seed, shard, cancel);
    match &plan.experiment.workload {
        Workload::Counts => counts::rows(id, seed, shard),
        Workload::Errors(hits) => Ok(errors(hits)),
        Workload::Pairs(pairs) => {
            let mut rows = pairs.errors.as_ref().map(errors).unwrap_or_default();
            if let Some(workload) = &pairs.stiff {
                let first = pairs.errors.as_ref().map_or(0, |hits| errors::tasks(variants, hits));
                let stiff = stiff::rows(id, variants, workload, seed, shard, cancel);
                rows.extend(stiff.into_iter().map(|(task, row)| (first as u64 + task, row)));
            }
            Ok(rows)
        }
        Workload::Structures(sets) => search::counted_rows(id, sets, seed, shard, cancel),
        _ => Ok(Vec::new()),
    }
}

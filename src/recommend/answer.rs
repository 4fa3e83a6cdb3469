//! The recommendation.

use super::RecommendError;
use super::arena::{Arena, Ranked};
use super::because;
use super::candidates::{Candidate, candidates, is_timed};
use super::question::{KnownVariant, Question};
use crate::results::Results;
use crate::table::Row;
use serde::Serialize;
use std::collections::BTreeMap;

/// What to take, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Recommendation {
    /// Id of the variant.
    pub variant: String,
    /// Sentences with the figures and the rows that they are from.
    pub because: Vec<String>,
    /// Id of the next best; none if nothing else fits.
    pub runner_up: Option<String>,
    /// What it takes longer, percent of the variant's time.
    pub runner_up_costs_percent: Option<f64>,
    /// Lower end of the interval of it.
    pub runner_up_costs_low_percent: Option<f64>,
    /// Upper end of it.
    pub runner_up_costs_high_percent: Option<f64>,
    /// Whether rows can tell the two apart.
    pub runner_up_is_slower: Option<bool>,
    /// Lines of Rust that call the variant.
    pub code: String,
}

/// How much longer one form takes than another, as a share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cost {
    /// Of the medians.
    pub share: f64,
    /// With the intervals at their near ends.
    pub low: f64,
    /// With the intervals at their far ends.
    pub high: f64,
    /// What copies of one kernel differ by.
    pub floor: f64,
    /// Whether that is more than intervals and noise can make of nothing.
    pub is_measurable: bool,
}

impl Cost {
    /// What `other` costs over `best`. Differences below what copies of one kernel differ by are
    /// none; with two experiments between them, twice.
    pub fn of(other: &Ranked<'_>, best: &Ranked<'_>) -> Self {
        let (row, of_best) = (other.candidate.row, best.candidate.row);
        let floors = [row, of_best].map(|row| row.noise_floor.unwrap_or(0.0));
        let floor = if row.experiment == of_best.experiment {
            floors[0].max(floors[1])
        } else {
            floors[0] + floors[1]
        };
        let over = |a: f64, b: f64| a / b - 1.0;
        let low = over(other.time[1], best.time[2]);
        Cost {
            share: over(other.time[0], best.time[0]),
            low,
            high: over(other.time[2], best.time[1]),
            floor,
            is_measurable: low > floor,
        }
    }
}

/// What was found, before it is put into words.
pub(super) struct Found<'a> {
    pub results: &'a Results,
    pub question: &'a Question,
    /// The first decides.
    pub arenas: Vec<Arena<'a>>,
    /// Who is left out: `24 that ...`.
    pub left_out: String,
    /// Whether any row tells what preparing costs.
    pub tells_preparing: bool,
}

impl<'a> Found<'a> {
    /// The arena that decides.
    pub fn arena(&self) -> &Arena<'a> {
        &self.arenas[0]
    }

    /// The variant to take.
    pub fn best(&self) -> &Ranked<'a> {
        &self.arena().ranked[0]
    }
}

/// The variant to take by these rows.
///
/// # Errors
/// Where there are no times, or nothing that was timed fits.
pub fn recommend(
    results: &Results,
    question: &Question,
    known: &[KnownVariant],
) -> Result<Recommendation, RecommendError> {
    let rows: Vec<&Row> = results.rows().collect();
    let timed = timed(&rows);
    if timed == 0 {
        return Err(RecommendError::NoTimes(folders(results)));
    }
    let by_id: BTreeMap<&str, &KnownVariant> =
        known.iter().map(|variant| (variant.id.as_str(), variant)).collect();
    let (fitting, left_out) = candidates(&rows, question, &by_id);
    let arenas = Arena::all(&rows, &fitting);
    if arenas.is_empty() {
        let (folders, reasons) = (folders(results), left_out.words());
        return Err(RecommendError::NothingFits { timed, folders, reasons });
    }
    let tells_preparing = rows.iter().any(|row| row.prepare_cycles_per_triangle.is_some());
    let left_out = left_out.words();
    Ok(put(&Found { results, question, arenas, left_out, tells_preparing }))
}

fn put(found: &Found<'_>) -> Recommendation {
    let best = found.best();
    let next = found.arena().ranked.get(1);
    let cost = next.map(|next| Cost::of(next, best));
    let percent = |share: fn(&Cost) -> f64| cost.as_ref().map(|cost| share(cost) * 100.0);
    let id = |candidate: &Candidate<'_>| candidate.known.id.clone();
    Recommendation {
        variant: id(&best.candidate),
        because: because::sentences(found),
        runner_up: next.map(|next| id(&next.candidate)),
        runner_up_costs_percent: percent(|cost| cost.share),
        runner_up_costs_low_percent: percent(|cost| cost.low),
        runner_up_costs_high_percent: percent(|cost| cost.high),
        runner_up_is_slower: cost.map(|cost| cost.is_measurable),
        code: best.candidate.known.call.clone(),
    }
}

fn timed(rows: &[&Row]) -> usize {
    let ids = rows.iter().filter(|row| is_timed(row)).map(|row| row.id.as_str());
    ids.collect::<std::collections::BTreeSet<_>>().len()
}

/// Where the rows are from.
pub(super) fn folders(results: &Results) -> String {
    let all = results.sources.iter().flat_map(|source| source.folders.iter().cloned());
    let all: Vec<String> = all.collect();
    if all.is_empty() { "the rows".to_owned() } else { all.join(", ") }
}

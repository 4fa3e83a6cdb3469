//! What was found, before it is put into words.

use super::RecommendError;
use super::arena::{Arena, Ranked};
use super::candidates::{candidates, is_timed};
use super::question::{KnownVariant, Question};
use crate::results::Results;
use crate::table::Row;
use std::collections::{BTreeMap, BTreeSet};

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

/// What was found.
pub(super) struct Found<'a> {
    pub results: &'a Results,
    /// The rows that were asked.
    pub rows: Vec<&'a Row>,
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

    /// The best form of another kernel, with its place.
    pub fn other_kernel(&self) -> Option<(usize, &Ranked<'a>)> {
        let kernel = &self.best().candidate.row.kernel;
        let mut ranked = self.arena().ranked.iter().enumerate();
        ranked.find(|(_, one)| one.candidate.row.kernel != *kernel)
    }
}

/// The variant to take by the rows of a machine, or by all.
///
/// # Errors
/// Where there are no times, or nothing that was timed fits.
pub(super) fn find<'a>(
    results: &'a Results,
    machine: Option<&str>,
    question: &'a Question,
    known: &'a [KnownVariant],
) -> Result<Found<'a>, RecommendError> {
    let is_its = |row: &&Row| machine.is_none_or(|machine| row.machine == machine);
    let rows: Vec<&Row> = results.rows().filter(is_its).collect();
    let timed = timed(&rows);
    if timed == 0 {
        return Err(RecommendError::NoTimes(folders(results)));
    }
    let by_id: BTreeMap<&str, &KnownVariant> =
        known.iter().map(|variant| (variant.id.as_str(), variant)).collect();
    let (fitting, left_out) = candidates(&rows, question, &by_id);
    let arenas = Arena::all(&rows, &fitting);
    let left_out = left_out.words();
    if arenas.is_empty() {
        let folders = folders(results);
        return Err(RecommendError::NothingFits { timed, folders, reasons: left_out });
    }
    let tells_preparing = rows.iter().any(|row| row.prepare_cycles_per_triangle.is_some());
    Ok(Found { results, rows, question, arenas, left_out, tells_preparing })
}

fn timed(rows: &[&Row]) -> usize {
    let ids = rows.iter().filter(|row| is_timed(row)).map(|row| row.id.as_str());
    ids.collect::<BTreeSet<_>>().len()
}

/// Where the rows are from.
pub(super) fn folders(results: &Results) -> String {
    let all = results.sources.iter().flat_map(|source| source.folders.iter().cloned());
    let all: Vec<String> = all.collect();
    if all.is_empty() { "the rows".to_owned() } else { all.join(", ") }
}

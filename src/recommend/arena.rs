//! Times that may be held against each other: of the same rays and triangles in the same order.
//!
//! An experiment pairs its times with those of a reference in the same rounds. Experiments on the
//! same rays and triangles are brought to one scale by the variants that they share.

use super::candidates::{Candidate, is_timed};
use crate::stats::median;
use crate::table::{Cell, Row};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// What must be the same.
const SAME: [&str; 17] = [
    "workload",
    "order",
    "density",
    "triangles",
    "rays",
    "query",
    "winding",
    "generator",
    "seed",
    "workload_hash",
    "repeats",
    "set_bytes",
    "spread",
    "code",
    "subnormals",
    "build",
    "machine",
];

/// Orders, the one that foresees least last.
const ORDERS: [&str; 3] = ["literal", "fixed", "reshuffled"];

/// A candidate with its time.
#[derive(Clone, Copy)]
pub(super) struct Ranked<'a> {
    /// It.
    pub candidate: Candidate<'a>,
    /// Time on the arena's scale with what preparing adds: median, lower and upper end.
    pub time: [f64; 3],
}

/// Everything that was timed on the same rays and triangles in the same order.
pub(super) struct Arena<'a> {
    /// The candidates, the fastest first.
    pub ranked: Vec<Ranked<'a>>,
    /// Candidates in experiments that share no variant with the others.
    pub apart: Vec<Candidate<'a>>,
    /// All that was timed there.
    timed: Vec<&'a Row>,
}

impl<'a> Arena<'a> {
    /// All arenas that have a candidate, the one to decide by first.
    pub fn all(rows: &[&'a Row], candidates: &[Candidate<'a>]) -> Vec<Arena<'a>> {
        let mut keys: BTreeMap<Vec<String>, (Vec<&'a Row>, Vec<Candidate<'a>>)> = BTreeMap::new();
        for candidate in candidates {
            keys.entry(key(candidate.row)).or_default().1.push(*candidate);
        }
        for row in rows.iter().copied().filter(|row| is_timed(row)) {
            if let Some((timed, _)) = keys.get_mut(&key(row)) {
                timed.push(row);
            }
        }
        let mut arenas: Vec<Arena<'a>> = keys
            .into_values()
            .map(|(timed, candidates)| Arena::of(timed, candidates))
            .filter(|arena| !arena.ranked.is_empty())
            .collect();
        arenas.sort_by(by_rank);
        arenas
    }

    fn of(timed: Vec<&'a Row>, candidates: Vec<Candidate<'a>>) -> Self {
        let scales = scales(&timed, &candidates);
        let (mut ranked, mut apart): (Vec<Ranked<'a>>, Vec<Candidate<'a>>) = Default::default();
        for (experiment, scale) in &scales {
            let here = candidates.iter().filter(|one| one.row.experiment == *experiment);
            for candidate in here {
                // The experiment that came first has the most to be compared with.
                let is_new = ranked.iter().all(|one| one.candidate.row.id != candidate.row.id);
                if let Some(time) = time(candidate, *scale).filter(|_| is_new) {
                    ranked.push(Ranked { candidate: *candidate, time });
                }
            }
        }
        for candidate in candidates {
            if scales.iter().all(|(experiment, _)| candidate.row.experiment != *experiment) {
                apart.push(candidate);
            }
        }
        ranked.sort_by(|a, b| {
            let by_time = a.time[0].total_cmp(&b.time[0]);
            let (a, b) = (a.candidate.row, b.candidate.row);
            by_time.then(a.bytes_per_triangle.cmp(&b.bytes_per_triangle)).then(a.id.cmp(&b.id))
        });
        Arena { ranked, apart, timed }
    }

    /// A row of it.
    pub fn row(&self) -> &'a Row {
        self.ranked[0].candidate.row
    }

    /// A variant's place.
    pub fn find(&self, id: &str) -> Option<&Ranked<'a>> {
        self.ranked.iter().find(|one| one.candidate.row.id == id)
    }

    /// The reference that a row's ratio refers to, where it has a row itself: its own ratio is 1.
    pub fn reference(&self, row: &Row) -> Option<&'a Row> {
        let one = Some(1.0);
        let is_reference = |other: &&&'a Row| {
            let ratio = [other.ratio_to_reference, other.ratio_low, other.ratio_high];
            other.experiment == row.experiment && ratio == [one; 3]
        };
        self.timed.iter().find(is_reference).copied()
    }

    /// Experiments that the ranked times are from.
    pub fn experiments(&self) -> Vec<&'a str> {
        let all = self.ranked.iter().map(|one| one.candidate.row.experiment.as_str());
        all.collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// Kernels among the candidates.
    pub fn kernels(&self) -> usize {
        let all = self.ranked.iter().map(|one| one.candidate.row.kernel.as_str());
        all.collect::<BTreeSet<_>>().len()
    }
}

/// Arenas where something can be compared before others, unforeseen outcomes before foreseen ones,
/// rays before lines, the nearest of many triangles before single pairs, many forms before few (what was
/// not timed there cannot be the fastest), and the density that leaves most to be found out.
fn by_rank(a: &Arena<'_>, b: &Arena<'_>) -> Ordering {
    let rank = |arena: &Arena<'_>| {
        let row = arena.row();
        let order = ORDERS.iter().position(|order| *order == row.order);
        let is_nearest = row.workload.starts_with("nearest");
        let forms = arena.ranked.len();
        (forms > 1, order, row.query == "ray", is_nearest, forms, arena.kernels())
    };
    let lopsided = |arena: &Arena<'_>| (arena.row().density.unwrap_or(0.5) - 0.5).abs();
    rank(b).cmp(&rank(a)).then(lopsided(a).total_cmp(&lopsided(b)))
}

fn key(row: &Row) -> Vec<String> {
    SAME.map(|column| row.cell(column).unwrap_or(Cell::Missing).to_string()).to_vec()
}

/// A row's figure: the ratio to the reference in the same rounds, or cycles where there is none.
pub(super) fn measured(row: &Row) -> Option<[f64; 3]> {
    let ratio = row.ratio_to_reference.map(|ratio| (ratio, row.ratio_low, row.ratio_high));
    let cycles = || row.cycles_per_test.map(|cycles| (cycles, row.cycles_low, row.cycles_high));
    let (median, low, high) = ratio.or_else(cycles)?;
    (median > 0.0).then(|| [median, low.unwrap_or(median), high.unwrap_or(median)])
}

fn time(candidate: &Candidate<'_>, scale: f64) -> Option<[f64; 3]> {
    let measured = measured(candidate.row)?;
    Some([0, 1, 2].map(|end| measured[end] * scale * candidate.factors[end]))
}

/// Experiments in the order in which they are joined, and what their figures are multiplied by. The
/// first is the one with most candidates; each next one shares most variants with those before.
fn scales<'a>(timed: &[&'a Row], candidates: &[Candidate<'a>]) -> Vec<(&'a str, f64)> {
    let mut waiting: BTreeMap<&str, BTreeMap<&str, f64>> = BTreeMap::new();
    for row in timed {
        if let Some([median, ..]) = measured(row) {
            let of_experiment = waiting.entry(&row.experiment).or_default();
            of_experiment.entry(&row.id).or_insert(median);
        }
    }
    let count =
        |experiment: &str| candidates.iter().filter(|one| one.row.experiment == experiment).count();
    let mut joined: BTreeMap<&str, f64> = BTreeMap::new();
    let mut scales = Vec::new();
    loop {
        let shared = |(experiment, own): &(&&'a str, &BTreeMap<&'a str, f64>)| {
            if scales.is_empty() {
                return count(experiment);
            }
            own.keys().filter(|id| joined.contains_key(*id)).count()
        };
        // The first of equals: `max_by_key` gives the last.
        let best = waiting.iter().rev().max_by_key(shared);
        let Some(experiment) = best.filter(|best| shared(best) > 0).map(|(name, _)| *name) else {
            return scales;
        };
        let own = waiting.remove(experiment).unwrap_or_default();
        let steps = own.iter().filter_map(|(id, value)| Some((joined.get(id)? / value).ln()));
        let scale = median(&steps.collect::<Vec<_>>()).map_or(1.0, f64::exp);
        for (id, value) in own {
            joined.entry(id).or_insert(value * scale);
        }
        scales.push((experiment, scale));
    }
}

//! Which timed variants fit what is asked, and why the others do not.

use super::evidence::{Leaks, error, leaks};
use super::preparing::{Counting, Preparing};
use super::question::{KnownVariant, Needs, Question};
use crate::table::Row;
use std::collections::{BTreeMap, BTreeSet};

/// A variant that fits, timed in one place.
#[derive(Clone, Copy)]
pub(super) struct Candidate<'a> {
    /// Its time.
    pub row: &'a Row,
    /// What it is.
    pub known: &'a KnownVariant,
    /// What preparing multiplies its time by: median, least, most.
    pub factors: [f64; 3],
    /// What preparing costs, where that counts.
    pub preparing: Option<Preparing<'a>>,
    /// Its error and the row that tells it, where a tolerance is asked.
    pub error: Option<(f64, &'a Row)>,
    /// The rays it loses, where it must not.
    pub leaks: Option<Leaks<'a>>,
}

/// Ids that are left out, by the reason.
#[derive(Default)]
pub(super) struct LeftOut(BTreeMap<String, BTreeSet<String>>);

impl LeftOut {
    /// Puts an id in.
    pub fn add(&mut self, reason: &str, id: &str) {
        self.0.entry(reason.to_owned()).or_default().insert(id.to_owned());
    }

    /// `24 that answer for lines, 3 that cull`: most first; empty if nothing is left out.
    pub fn words(&self) -> String {
        let mut all: Vec<(usize, &String)> =
            self.0.iter().map(|(reason, ids)| (ids.len(), reason)).collect();
        all.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
        let words = all.iter().map(|(count, reason)| format!("{count} that {reason}"));
        words.collect::<Vec<_>>().join(", ")
    }
}

/// Whether a row holds the time of a variant on a workload as it is: no sum with preparing, no
/// operation done twice, no pairs sorted by how their calls end.
pub(super) fn is_timed(row: &Row) -> bool {
    let is_plain = row.priced.is_empty() && row.record.is_empty();
    let is_whole = row.code.is_none() && row.rays_per_triangle.is_none();
    // Streams of arithmetic report nothing, since they test nothing.
    let is_test = !row.id.is_empty() && !row.output.is_empty();
    is_plain && is_whole && is_test && row.ns_per_test.is_some()
}

/// The candidates, in the order of the rows, and who is left out.
pub(super) fn candidates<'a>(
    rows: &[&'a Row],
    question: &Question,
    known: &BTreeMap<&str, &'a KnownVariant>,
) -> (Vec<Candidate<'a>>, LeftOut) {
    let counting = Counting::of(question, rows);
    let (mut fitting, mut left_out) = (Vec::new(), LeftOut::default());
    for row in rows.iter().copied().filter(|row| is_timed(row)) {
        let judged = match known.get(row.id.as_str()) {
            None => Err("are not in this program".to_owned()),
            Some(known) => judged(row, known, question, rows, &counting),
        };
        match judged {
            Ok(candidate) => fitting.push(candidate),
            Err(reason) => left_out.add(&reason, &row.id),
        }
    }
    (fitting, left_out)
}

fn judged<'a>(
    row: &'a Row,
    known: &'a KnownVariant,
    question: &Question,
    rows: &[&'a Row],
    counting: &Counting<'a>,
) -> Result<Candidate<'a>, String> {
    form_fits(row, known, question)?;
    let leaks = question.watertight.then(|| leaks(rows, row));
    if question.watertight {
        holds(known, leaks)?;
    }
    let found = question.tolerance.map(|tolerance| (tolerance, error(rows, row)));
    let error = match found {
        None => None,
        Some((_, None)) => return Err("have no error among the rows".to_owned()),
        Some((tolerance, Some(found))) if found.0 > tolerance => {
            return Err("err more".to_owned());
        }
        Some((_, found)) => found,
    };
    // With a tolerance, the rows say whether what claims no exactness is exact enough.
    if row.status != "ok" && !(row.status == "inexact" && error.is_some() && !question.watertight) {
        return Err(format!("have status {}", row.status));
    }
    let preparing = counting.of_row(row)?;
    let factors = counting.factors(row, preparing);
    Ok(Candidate { row, known, factors, preparing, error, leaks })
}

fn form_fits(row: &Row, known: &KnownVariant, question: &Question) -> Result<(), String> {
    if !known.limits.is_empty() {
        return Err(known.limits.clone());
    }
    if question.precision.as_ref().is_some_and(|precision| *precision != row.precision) {
        return Err("are of the other precision".to_owned());
    }
    if Needs::reported(&row.output).is_none_or(|reported| reported < question.needs) {
        return Err(format!("report less than {}", question.needs.word()));
    }
    question.packets.admit(&row.drive)?;
    if !known.available {
        return Err("need a level that this processor lacks".to_owned());
    }
    Ok(())
}

fn holds(known: &KnownVariant, leaks: Option<Leaks<'_>>) -> Result<(), String> {
    match leaks {
        _ if !known.watertight => Err("are not watertight".to_owned()),
        Some(Leaks::Counted(1.., ..)) => Err("lose rays".to_owned()),
        Some(Leaks::Unknown) => Err("have no row that counts the rays they lose".to_owned()),
        _ => Ok(()),
    }
}

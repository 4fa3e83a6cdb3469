//! How trustworthy the run was: what differences it could see, what it threw away, what is missing.

use super::words::{count, first_of, percent};
use crate::results::Results;
use crate::stats::median;
use crate::table::Row;
use std::collections::BTreeMap;

/// One thing to know about the run.
pub(super) struct Check {
    pub what: &'static str,
    pub figure: String,
    pub meaning: String,
    /// Whether it is a warning.
    pub alarm: bool,
}

/// Everything there is to know.
pub(super) fn checks(results: &Results) -> Vec<Check> {
    let rows: Vec<&Row> = results.rows().collect();
    let mut checks = Vec::new();
    checks.extend(noise(&rows));
    checks.extend(placebo(&rows));
    checks.extend(dirty(&rows));
    checks.extend(crowded(&rows));
    checks.extend(statuses(&rows));
    checks.extend(skipped(&rows));
    checks.extend(incomplete(results));
    // What is wrong is said before anything else.
    checks.sort_by_key(|check| check.what != WRONG);
    checks
}

/// The check that there is only where a kernel gave a wrong answer.
const WRONG: &str = "WRONG RESULTS";

/// What the top of the page says of wrong answers; empty without any.
pub(super) fn wrong(results: &Results) -> String {
    let wrong = results.rows().filter(|row| row.status == "wrong-result").count();
    match wrong {
        0 => String::new(),
        number => format!(
            "{} a kernel that gave a wrong answer where it claims a right one.",
            count(number, "row is of", "rows are of")
        ),
    }
}

/// Median and largest.
fn middle_and_worst(mut values: Vec<f64>) -> Option<(f64, f64)> {
    values.sort_by(f64::total_cmp);
    Some((median(&values)?, *values.last()?))
}

fn noise(rows: &[&Row]) -> Option<Check> {
    let (middle, worst) =
        middle_and_worst(rows.iter().filter_map(|row| row.noise_floor).collect())?;
    Some(Check {
        what: "smallest difference that can be told",
        figure: format!("median {}, worst {}", percent(middle), percent(worst)),
        meaning: "from chance and from where code lies, per group of variants measured together"
            .to_owned(),
        alarm: false,
    })
}

fn placebo(rows: &[&Row]) -> Option<Check> {
    let off = |row: &&Row| row.ratio_placebo.map(|ratio| ratio.ln().abs().exp_m1());
    let (middle, worst) = middle_and_worst(rows.iter().filter_map(off).collect())?;
    Some(Check {
        what: "the reference against a copy of itself (A/A)",
        figure: format!("median {}, worst {}", percent(middle), percent(worst)),
        meaning: "nothing differs there, so what is seen is the machine's own".to_owned(),
        alarm: false,
    })
}

fn dirty(rows: &[&Row]) -> Option<Check> {
    let sum = |of: fn(&Row) -> Option<u64>| rows.iter().filter_map(|row| of(row)).sum::<u64>();
    let (clean, dirty) = (sum(|row| row.rounds), sum(|row| row.dirty_rounds));
    (clean + dirty > 0).then(|| Check {
        what: "rounds thrown away as disturbed",
        figure: percent(dirty as f64 / (clean + dirty) as f64),
        meaning: format!("{dirty} of {} over all rows; they count nowhere", clean + dirty),
        alarm: false,
    })
}

fn crowded(rows: &[&Row]) -> Option<Check> {
    // What is made of other rows has no rounds, and is not counted twice.
    let measured = rows.iter().filter(|row| row.rounds.is_some());
    let shares: Vec<f64> = measured.filter_map(|row| row.crowded_share).collect();
    let some = shares.iter().filter(|share| **share > 0.0).count();
    let worst = shares.iter().copied().fold(0.0, f64::max);
    (!shares.is_empty()).then(|| Check {
        what: "rows with a neighbour on the core",
        figure: format!("{some} of {}", shares.len()),
        meaning: match some {
            0 => "every row had rounds enough without one".to_owned(),
            _ => format!("in up to {} of a row's rounds", percent(worst)),
        },
        alarm: some > 0,
    })
}

/// How many rows there are of each status but `ok`; wrong answers are named.
fn statuses(rows: &[&Row]) -> Vec<Check> {
    let mut counts: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for row in rows.iter().filter(|row| !["", "ok"].contains(&row.status.as_str())) {
        let name = format!("{} in {}", row.id, row.experiment);
        let names = counts.entry(&row.status).or_default();
        names.push(name);
    }
    let check = |(status, mut names): (&str, Vec<String>)| {
        let number = names.len();
        names.sort();
        names.dedup();
        let wrong = status == "wrong-result";
        Check {
            what: match status {
                "wrong-result" => WRONG,
                "skipped" => "rows skipped",
                "inexact" => "rows of kernels that are inexact by nature",
                "invalid" => "rows that say nothing (invalid)",
                "not-measured" => "rows not measured",
                _ => "rows of another status",
            },
            figure: format!("{} ({status})", count(number, "row", "rows")),
            meaning: first_of(&names, if wrong { 12 } else { 2 }),
            alarm: wrong || status == "invalid",
        }
    };
    let mut checks: Vec<Check> = counts.into_iter().map(check).collect();
    let ok = rows.iter().filter(|row| ["", "ok"].contains(&row.status.as_str())).count();
    checks.insert(
        0,
        Check {
            what: "rows with nothing to say against them",
            figure: format!("{ok} of {}", rows.len()),
            meaning: "answers checked against the exact ones before anything was timed".to_owned(),
            alarm: false,
        },
    );
    checks
}

fn skipped(rows: &[&Row]) -> Option<Check> {
    let mut levels: Vec<String> = Vec::new();
    for row in rows.iter().filter(|row| row.status == "skipped") {
        if !row.level.is_empty() && !levels.contains(&row.level) {
            levels.push(row.level.clone());
        }
    }
    (!levels.is_empty()).then(|| Check {
        what: "levels with skipped rows",
        figure: levels.join(", "),
        meaning: "instruction sets that this machine or this build lacks".to_owned(),
        alarm: false,
    })
}

fn incomplete(results: &Results) -> Option<Check> {
    let open = results.chapters.iter().filter(|chapter| !chapter.complete);
    let open: Vec<String> = open.map(|chapter| chapter.about.id.clone()).collect();
    (!open.is_empty()).then(|| Check {
        what: "experiments that did not run to their end",
        figure: count(open.len(), "experiment", "experiments"),
        meaning: first_of(&open, 8),
        alarm: true,
    })
}

/// One sentence of the most important of it.
pub(super) fn sentence(results: &Results) -> String {
    let open = results.chapters.iter().filter(|chapter| !chapter.complete).count();
    let floors = results.rows().filter_map(|row| row.noise_floor).collect();
    let is_timed = results.rows().any(|row| row.ns_per_test.is_some());
    let floor = match middle_and_worst(floors) {
        Some((middle, _)) => format!(
            "Half of the times are of groups in which differences from {} on can be told.",
            percent(middle)
        ),
        None if is_timed => "No copies of a kernel were timed, so nothing says which differences \
                             can be told."
            .to_owned(),
        None => "Nothing was timed.".to_owned(),
    };
    let wrong = match wrong(results) {
        none if none.is_empty() => {
            "No kernel gave a wrong answer where it claims a right one.".to_owned()
        }
        some => format!("WRONG: {some}"),
    };
    let open = match open {
        0 => String::new(),
        number => format!(" {} not complete.", count(number, "experiment is", "experiments are")),
    };
    format!("{floor} {wrong}{open}")
}

//! What was found, as text for a terminal: no line is longer than 100 characters.

use super::contest::{Entry, Outcome};
use super::examine::{Examination, FamilyFound, MeshFound};
use crate::measure::{Figures, Status};

/// Characters of a line.
const WIDTH: usize = 100;
/// Characters of the first column.
const FIRST: usize = 27;
/// Characters of the column of one entrant.
const COLUMN: usize = 24;
/// Entrants side by side.
const ABREAST: usize = (WIDTH - FIRST) / COLUMN;

/// What examinations found, side by side: a line a family, with the setting of its knob from which on
/// a kernel fails, and a line a kind of rays, with how many of them were lost.
pub fn examinations(found: &[Examination]) -> String {
    found.chunks(ABREAST).map(abreast).collect::<Vec<_>>().join("\n")
}

fn abreast(found: &[Examination]) -> String {
    let mut lines = vec![
        line("", found.iter().map(|one| short(&one.id))),
        line("wrong of the random pairs", found.iter().map(wrong_pairs)),
    ];
    for family in unique(found.iter().flat_map(|one| &one.families).map(|one| one.family)) {
        let cell = |one: &Examination| {
            let of = one.families.iter().find(|other| other.family == family);
            of.map_or_else(String::new, family_cell)
        };
        lines.push(line(family, found.iter().map(cell)));
    }
    for class in unique(found.iter().flat_map(|one| &one.meshes).map(|one| one.class)) {
        let cell = |one: &Examination| {
            let of = one.meshes.iter().find(|other| other.class == class);
            of.map_or_else(String::new, mesh_cell)
        };
        lines.push(line(&format!("lost of {class} rays"), found.iter().map(cell)));
    }
    lines.concat()
}

/// What a contest found: a line an entrant with its time and its ratio to the reference, each with its
/// interval, and the verdict; below it, why an entrant has none. Then how the group was measured.
pub fn outcome(found: &Outcome) -> String {
    let head = ["ns per test (95 % interval)", "ratio (95 % interval)", "verdict"];
    let mut text = row(&format!("order {}", found.order), head.map(str::to_owned));
    for entry in &found.entries {
        let figures = entry.figures.as_ref();
        let cells = [figures.and_then(time), figures.and_then(ratio), Some(word(entry))];
        text += &row(&short(&entry.id), cells.map(Option::unwrap_or_default));
        text += &reason(entry).map_or_else(String::new, |reason| cut(&format!("  {reason}")));
    }
    let report = &found.report;
    text += &cut(&format!("ratios are to {}", found.reference));
    text += &cut(&format!(
        "{} rounds, {} dropped, {:.0} % beside a neighbour; copies of the reference differ by {:.1} %",
        report.rounds,
        report.dirty_rounds,
        report.crowded_share * 100.0,
        report.noise_floor * 100.0
    ));
    text
}

fn unique<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found = Vec::new();
    for name in names {
        if !found.contains(&name) {
            found.push(name);
        }
    }
    found
}

/// Kernel and precision of an id: all that tells entrants apart.
fn short(id: &str) -> String {
    let end = id.match_indices('/').nth(1).map_or(id.len(), |(place, _)| place);
    id[..end].to_owned()
}

fn line(first: &str, cells: impl Iterator<Item = String>) -> String {
    let cells: String = cells.map(|cell| format!("{cell:>COLUMN$.23}")).collect();
    cut(&format!("{first:<FIRST$.26}{cells}"))
}

fn row(first: &str, [time, ratio, verdict]: [String; 3]) -> String {
    cut(&format!("{first:<FIRST$.26}{time:>29}{ratio:>26}  {verdict}"))
}

/// A line of at most [`WIDTH`] characters.
fn cut(line: &str) -> String {
    let kept: String = line.trim_end().chars().take(WIDTH).collect();
    kept + "\n"
}

fn wrong_pairs(of: &Examination) -> String {
    let accuracy = &of.pairs.accuracy;
    let wrong = accuracy.false_hits + accuracy.false_misses;
    match &of.pairs.wrong {
        None if wrong == 0 => "none".to_owned(),
        // Decisions may all be right where an output is not.
        Some(_) if wrong == 0 => "outputs".to_owned(),
        _ => format!("{wrong} of {}", accuracy.cases),
    }
}

fn family_cell(of: &FamilyFound) -> String {
    let mut words = Vec::new();
    match of.knee {
        Some(knob) => words.push(format!("fails at {knob}")),
        None if !of.has_knee && of.deep > 0 => words.push(format!("{} deep", of.deep)),
        None => {}
    }
    if of.not_finite > 0 {
        words.push(format!("{} NaN, inf", of.not_finite));
    }
    if words.is_empty() { "-".to_owned() } else { words.join(", ") }
}

fn mesh_cell(of: &MeshFound) -> String {
    match of.lost {
        0 => format!("none of {}", of.rays),
        lost => format!("{lost} of {}", of.rays),
    }
}

fn time(of: &Figures) -> Option<String> {
    Some(format!("{:.2} ({:.2} to {:.2})", of.ns_per_test?, of.ns_low?, of.ns_high?))
}

fn ratio(of: &Figures) -> Option<String> {
    let ratio = of.ratio_to_reference?;
    Some(format!("{:.3} ({:.3} to {:.3})", ratio.estimate, ratio.low, ratio.high))
}

fn word(of: &Entry) -> String {
    let Some(figures) = &of.figures else {
        return if of.judgement.wrong.is_some() { "wrong-result" } else { "skipped" }.to_owned();
    };
    match (&figures.status, figures.decision) {
        (Status::Invalid(_), _) => "invalid".to_owned(),
        (Status::Ok, Some(decision)) => decision.verdict.word().to_owned(),
        (Status::Ok, None) => String::new(),
    }
}

fn reason(of: &Entry) -> Option<String> {
    match &of.figures {
        None => of.judgement.wrong.clone(),
        Some(figures) => match &figures.status {
            Status::Invalid(reason) => Some(reason.to_string()),
            Status::Ok => None,
        },
    }
}

//! A comparison as text, CSV, JSON and Markdown.

use std::fmt::Write;

use serde_json::{Value, json};

use super::failure::Failure;
use super::show::{self, Sheet};
use crate::compare::{Comparison, Finding, Place, Side, Source, Verdict};
use crate::report::count;

/// So many of what is only listed are named in a text; CSV and JSON have them all.
const MOST_NAMED: usize = 10;

/// One object.
///
/// # Errors
/// None in practice: no key of it can fail to be written.
pub fn json(comparison: &Comparison) -> Result<String, Failure> {
    serde_json::to_string_pretty(comparison).map_err(|error| Failure::Runtime(error.into()))
}

/// One line per finding; the line of a refusal has its key as figure.
///
/// # Errors
/// None in practice: memory can be written.
pub fn csv(comparison: &Comparison) -> Result<String, Failure> {
    let mut rows = Vec::new();
    for (kind, finding) in findings(comparison) {
        let (place, change) = (&finding.place, &finding.change);
        rows.push(vec![
            json!(kind),
            json!(place.experiment),
            json!(place.id),
            json!(place.workload),
            json!(place.order),
            json!(place.density),
            json!(change.figure),
            json!(change.ratio),
            json!(change.low),
            json!(change.high),
            json!(place.code),
            change.base.clone(),
            change.new.clone(),
        ]);
    }
    for refusal in &comparison.refused {
        let mut row = vec![json!("refused"), Value::Null, json!(refusal.place)];
        row.extend([Value::Null, Value::Null, Value::Null, json!(refusal.key)]);
        row.extend([Value::Null, Value::Null, Value::Null, Value::Null]);
        row.extend([json!(refusal.base), json!(refusal.new)]);
        rows.push(row);
    }
    let columns = vec![
        "kind",
        "experiment",
        "id",
        "workload",
        "order",
        "density",
        "figure",
        "ratio",
        "low",
        "high",
        "code",
        "base",
        "new",
    ];
    let mut bytes = Vec::new();
    show::csv(&Sheet { columns, rows }, &mut bytes)?;
    String::from_utf8(bytes).map_err(|error| Failure::Runtime(error.into()))
}

/// Kind and finding, the worst kind first.
fn findings(comparison: &Comparison) -> impl Iterator<Item = (&'static str, &Finding)> {
    let kinds = [
        ("regression", &comparison.regressions),
        ("improvement", &comparison.improvements),
        ("unresolved", &comparison.unresolved),
    ];
    kinds.into_iter().flat_map(|(kind, found)| found.iter().map(move |finding| (kind, finding)))
}

/// Findings worth a line: all that changed, and the first of what is not known.
fn named(comparison: &Comparison) -> Vec<(&'static str, &Finding)> {
    let changed = comparison.regressions.len() + comparison.improvements.len();
    findings(comparison).take(changed + MOST_NAMED).collect()
}

/// To read: what was compared, what was found, and a sentence.
pub fn text(comparison: &Comparison, base: &Side, new: &Side) -> String {
    let mut out = format!("base  {}\nnew   {}\n{}\n", about(base), about(new), counts(comparison));
    if !comparison.refused.is_empty() {
        let value = |text: &Option<String>| json!(text.as_deref().unwrap_or("nothing"));
        let row = |refusal: &crate::compare::Refusal| {
            let (base, new) = (value(&refusal.base), value(&refusal.new));
            vec![json!(refusal.key), base, new, json!(refusal.place)]
        };
        let rows = comparison.refused.iter().map(row).collect();
        let sheet = Sheet { columns: vec!["differs", "base", "new", "where"], rows };
        out += &format!("\n{}\n", show::text(&sheet));
    }
    let rows: Vec<Vec<Value>> = named(comparison).into_iter().map(line).collect();
    if !rows.is_empty() {
        let columns = TITLES.to_vec();
        out += &format!("\n{}\n", show::text(&Sheet { columns, rows }));
    }
    out += &more(comparison);
    // Of what cannot be compared, every cell is in one of the two only.
    if comparison.refused.is_empty() {
        out += &list("missing", &comparison.missing);
        out += &list("added", &comparison.added);
    }
    out + "\n" + &sentence(comparison)
}

/// Titles of the table in text and Markdown.
const TITLES: [&str; 10] =
    ["", "id", "experiment", "order", "density", "figure", "base", "new", "change", "interval"];

fn line((kind, finding): (&'static str, &Finding)) -> Vec<Value> {
    let (place, change) = (&finding.place, &finding.change);
    let interval = change.low.zip(change.high);
    let interval = interval.map(|(low, high)| format!("{} to {}", percent(low), percent(high)));
    let id = place.code.map_or(place.id.clone(), |code| format!("{} code {code}", place.id));
    vec![
        json!(kind),
        json!(id),
        json!(place.experiment),
        json!(place.order),
        json!(place.density),
        json!(change.figure),
        change.base.clone(),
        change.new.clone(),
        json!(change.ratio.map(percent)),
        json!(interval),
    ]
}

/// A ratio as a change in percent.
fn percent(ratio: f64) -> String {
    format!("{:+.1} %", (ratio - 1.0) * 100.0)
}

fn counts(comparison: &Comparison) -> String {
    let mut line =
        format!("{} in both, threshold {} %", cells(comparison), comparison.threshold_percent);
    for (count, what) in [
        (comparison.not_judged, "without a time to judge"),
        (comparison.missing.len(), "missing"),
        (comparison.added.len(), "added"),
    ] {
        if count > 0 {
            // Writing to a string cannot fail.
            let _ = write!(line, ", {count} {what}");
        }
    }
    line
}

/// What was left out of the table.
fn more(comparison: &Comparison) -> String {
    let left = comparison.unresolved.len().saturating_sub(MOST_NAMED);
    if left > 0 { format!("... and {left} more unresolved\n") } else { String::new() }
}

fn list(what: &str, places: &[Place]) -> String {
    let mut out = String::new();
    for place in places.iter().take(MOST_NAMED) {
        let density = place.density.map(|density| format!(" {density}")).unwrap_or_default();
        let (experiment, order) = (&place.experiment, &place.order);
        out += &format!("\n{what}: {} in {experiment} {order}{density}", place.id);
    }
    let left = places.len().saturating_sub(MOST_NAMED);
    match (places.is_empty(), left) {
        (true, _) => out,
        (false, 0) => out + "\n",
        (false, left) => out + &format!("\n... and {left} more {what}\n"),
    }
}

/// A side in a line: where it is from, the commit and the date.
fn about(side: &Side) -> String {
    let Some(first) = side.sources.first() else { return String::new() };
    let mut line = first.path.display().to_string();
    if side.sources.len() > 1 {
        line += &format!(" and {} more", side.sources.len() - 1);
    }
    let known = [("commit ", "/build/commit"), ("", "/date")];
    for (what, pointer) in known {
        if let Some(value) = word(first, pointer) {
            line += &format!(", {what}{value}");
        }
    }
    line
}

fn word<'a>(source: &'a Source, pointer: &str) -> Option<&'a str> {
    source.field(pointer).and_then(Value::as_str)
}

fn cells(comparison: &Comparison) -> String {
    count(comparison.cells, "cell", "cells")
}

/// The whole in a sentence.
fn sentence(comparison: &Comparison) -> String {
    let worst = comparison.regressions.first().map(|finding| {
        let change = finding.change.ratio.map(|ratio| format!(" ({})", percent(ratio)));
        format!("{} of {}{}", finding.change.figure, finding.place.id, change.unwrap_or_default())
    });
    let (cells, threshold) = (cells(comparison), comparison.threshold_percent);
    let are = |number: usize| if number == 1 { "is" } else { "are" };
    match comparison.verdict {
        Verdict::Refused => {
            "Refused: the two are about different things; nothing was judged.".into()
        }
        Verdict::Regressed => format!(
            "Regressed: {} in {cells} {} worse, first of all {}.",
            count(comparison.regressions.len(), "figure", "figures"),
            are(comparison.regressions.len()),
            worst.unwrap_or_default()
        ),
        Verdict::Unresolved => format!(
            "Unresolved: nothing is known to be worse, but {} of {cells} cannot be told from \
             a change beyond {threshold} %; more rounds (--profile) narrow the intervals.",
            comparison.unresolved.len()
        ),
        Verdict::Improved => format!(
            "Improved: {} in {cells} {} better, none is worse.",
            count(comparison.improvements.len(), "figure", "figures"),
            are(comparison.improvements.len())
        ),
        Verdict::Same => format!("Same: no change beyond {threshold} % in {cells}."),
    }
}

/// For a pull request.
pub fn markdown(comparison: &Comparison, base: &Side, new: &Side) -> String {
    let of = |side: &Side, pointer: &str| {
        let found = side.sources.first().and_then(|source| word(source, pointer));
        found.unwrap_or("unknown").to_owned()
    };
    let commit = |side: &Side| of(side, "/build/commit").chars().take(12).collect::<String>();
    let mut out = format!(
        "**{}**: `{}` against `{}` on {}, {}\n\n{}\n",
        comparison.verdict.word(),
        commit(new),
        commit(base),
        of(new, "/machine/processor"),
        of(new, "/build/compiler"),
        counts(comparison)
    );
    if !comparison.refused.is_empty() {
        out += "\n| differs | base | new | where |\n|---|---|---|---|\n";
        for refusal in &comparison.refused {
            let value = |text: &Option<String>| json!(text);
            let (base, new) = (value(&refusal.base), value(&refusal.new));
            out += &table_row(&[json!(refusal.key), base, new, json!(refusal.place)]);
        }
    }
    let lines = named(comparison);
    if !lines.is_empty() {
        out += &format!(
            "\n| {} |\n|---|---|---|---|---:|---|---:|---:|---:|---|\n",
            TITLES.join(" | ")
        );
        for found in lines {
            out += &table_row(&line(found));
        }
        out += &more(comparison);
    }
    out + "\n" + &sentence(comparison)
}

fn table_row(cells: &[Value]) -> String {
    // A bar would end the cell.
    let cells = cells.iter().map(|cell| show::rounded(cell).replace('|', "\\|"));
    format!("| {} |\n", cells.collect::<Vec<_>>().join(" | "))
}

#[cfg(test)]
#[path = "comparison_tests.rs"]
mod tests;

//! Under which conditions a claim is judged, and which rows belong to each.

use super::claim::{Claim, SeriesOf};
use super::select::belongs;
use crate::table::Row;

/// A condition: what rows have in common.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Condition {
    /// Values of the claim's condition columns, in their order.
    values: Vec<String>,
    /// The machine, where there are several and the claim does not compare them.
    machine: Option<String>,
}

/// The values that come first, in this order; others follow in the order of their rows.
const FIRST: [&str; 3] = ["literal", "fixed", "reshuffled"];

/// Conditions of a claim for which all its series have rows, in the order of [`FIRST`], then machine by
/// machine. Where there are none, those that decide.
pub fn conditions(claim: &Claim, rows: &[&Row]) -> Vec<Condition> {
    let of_claim = |row: &&&Row| {
        claim.series.values().any(|series| series.experiment.list().contains(&row.experiment))
    };
    let rows: Vec<&Row> = rows.iter().filter(of_claim).copied().collect();
    let mut found = Vec::new();
    for machine in machines_apart(claim, &rows) {
        let belongs = |row: &&&Row| machine.as_ref().is_none_or(|machine| row.machine == *machine);
        let rows: Vec<&Row> = rows.iter().filter(belongs).copied().collect();
        let mut values = values_of(claim, &rows);
        // Stable: what is not listed stays behind, in its order.
        values.sort_by_key(|values| values.first().map(|value| rank(value)));
        found.extend(
            values.into_iter().map(|values| Condition { values, machine: machine.clone() }),
        );
    }
    found.sort_by_key(|condition| condition.values.first().map(|value| rank(value)));
    found
}

fn rank(value: &str) -> usize {
    FIRST.iter().position(|first| *first == value).unwrap_or(FIRST.len())
}

/// The machines that are judged one by one; one `None` where there is one machine, or the claim
/// compares them.
fn machines_apart(claim: &Claim, rows: &[&Row]) -> Vec<Option<String>> {
    let machines = machines(rows);
    if claim.machines > 1 || machines.len() < 2 {
        return vec![None];
    }
    machines.into_iter().map(Some).collect()
}

/// Machines that rows come from, in their order. Rows of one source name none.
pub fn machines(rows: &[&Row]) -> Vec<String> {
    let mut machines: Vec<String> = Vec::new();
    for row in rows {
        if !machines.contains(&row.machine) {
            machines.push(row.machine.clone());
        }
    }
    machines
}

/// What every series that is not fixed by its own filter has rows of.
fn values_of(claim: &Claim, rows: &[&Row]) -> Vec<Vec<String>> {
    if claim.columns().is_empty() {
        return vec![Vec::new()];
    }
    let free = |series: &&SeriesOf| {
        let fixed = |column: &String| series.filter.contains_key(column);
        series.values.is_empty() && !claim.columns().iter().any(fixed)
    };
    let of_row =
        |row: &&Row| -> Vec<String> { claim.columns().iter().map(|c| text(row, c)).collect() };
    let mut common: Option<Vec<Vec<String>>> = None;
    for series in claim.series.values().filter(free) {
        let mut own: Vec<Vec<String>> = Vec::new();
        for row in rows.iter().filter(|row| series.experiment.list().contains(&row.experiment)) {
            let values = of_row(row);
            if !own.contains(&values) && values.iter().any(|value| !value.is_empty()) {
                own.push(values);
            }
        }
        let has_rows = rows.iter().any(|row| series.experiment.list().contains(&row.experiment));
        if own.is_empty() && has_rows {
            continue;
        }
        common = Some(match common {
            None => own,
            Some(others) => others.into_iter().filter(|one| own.contains(one)).collect(),
        });
    }
    // Other rows of an experiment, which no series asks for, make no condition.
    let asked: Vec<Vec<String>> = rows
        .iter()
        .filter(|row| claim.series.values().filter(free).any(|series| belongs(series, row)))
        .map(of_row)
        .collect();
    let mut common = common.unwrap_or_default();
    if !asked.is_empty() {
        common.retain(|values| asked.contains(values));
    }
    match common {
        common if !common.is_empty() => common,
        _ => claim.decides.iter().flatten().map(|value| vec![value.clone()]).collect(),
    }
}

fn text(row: &Row, column: &str) -> String {
    row.cell(column).map_or(String::new(), |cell| cell.to_string())
}

impl Condition {
    /// The rows that a series may choose from.
    pub fn rows_of<'r>(&self, claim: &Claim, series: &SeriesOf, rows: &[&'r Row]) -> Vec<&'r Row> {
        let agrees = |row: &Row| {
            let mut columns = claim.columns().iter().zip(&self.values);
            columns.all(|(column, value)| {
                let own = text(row, column);
                // What no clock was involved in has no order, and is the same in all.
                series.filter.contains_key(column) || own.is_empty() || own == *value
            })
        };
        let of_machine =
            |row: &Row| self.machine.as_ref().is_none_or(|machine| row.machine == *machine);
        rows.iter().copied().filter(|row| of_machine(row) && agrees(row)).collect()
    }

    /// The values of the claim's condition columns.
    pub fn values(&self) -> impl Iterator<Item = &String> {
        self.values.iter()
    }

    /// Whether the claim itself is about it.
    pub fn decides(&self, claim: &Claim) -> bool {
        let decides = claim.decides.as_deref().unwrap_or_default();
        self.values.is_empty()
            || decides.is_empty()
            || self.values.iter().any(|value| decides.contains(value))
    }

    /// As it is shown: `literal`, or `literal, AMD EPYC`.
    pub fn name(&self) -> String {
        let all: Vec<&str> = self.values.iter().chain(&self.machine).map(String::as_str).collect();
        all.join(", ")
    }
}

//! How kernels bear stiff and extreme cases.

use super::words::count;
use crate::results::Results;
use crate::table::Row;
use std::collections::BTreeMap;

/// Families that a kernel was put to, and those that it bore.
#[derive(Clone, Copy, Debug, Default)]
struct Borne {
    of: usize,
    all: usize,
}

/// `bears 7 of 19 families of stiff cases to the end (the best: plucker, 9)`, by the knees of
/// `ray_test stability`, or else by the stiff cases of other experiments; none where no row is about
/// them. Kernels are compared in their usual form and in the precision of the given one.
pub(super) fn words(results: &Results, machine: Option<&str>, form: &Row) -> Option<String> {
    let is_usual = |row: &&Row| {
        let usual = row.form == row.kernel && row.precision == form.precision;
        usual && machine.is_none_or(|own| row.machine == own)
    };
    let rows: Vec<&Row> = results.rows().filter(is_usual).collect();
    let knees = borne(&rows, &|row| row.record == "knee", &|row| row.knee.is_none());
    let is_case = |row: &Row| row.record == "cases" && row.drive == "single";
    let all = if knees.is_empty() { borne(&rows, &is_case, &is_right) } else { knees };
    let own = all.get(form.kernel.as_str())?;
    // What was put to fewer families cannot be compared. The first of equals by name.
    let others = all.iter().rev().filter(|(_, other)| other.all == own.all);
    let best = others.max_by_key(|(_, other)| other.of)?;
    let families = count(own.all, "family", "families");
    let compared = match best {
        (_, best) if best.of == own.of => "no kernel bears more".to_owned(),
        (kernel, best) => format!("the best: {kernel}, {}", best.of),
    };
    Some(format!("bears {} of {families} of stiff cases to the end ({compared})", own.of))
}

/// Whether no answer of stiff cases is deep in the wrong or no number.
fn is_right(row: &Row) -> bool {
    let wrong = [row.deep_false_hits, row.deep_false_misses, row.nan_outputs];
    wrong.iter().flatten().sum::<u64>() == 0
}

/// By kernel.
fn borne<'a>(
    rows: &[&'a Row],
    tells: &dyn Fn(&Row) -> bool,
    bears: &dyn Fn(&Row) -> bool,
) -> BTreeMap<&'a str, Borne> {
    let mut all: BTreeMap<&str, Borne> = BTreeMap::new();
    for row in rows.iter().filter(|row| tells(row)) {
        let own = all.entry(&row.kernel).or_default();
        own.all += 1;
        own.of += usize::from(bears(row));
    }
    all
}

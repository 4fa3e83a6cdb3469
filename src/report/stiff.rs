//! How a kernel bears stiff and extreme cases.

use super::words::count;
use crate::results::Results;
use crate::table::Row;

/// `fails in 2 of 17 families of stiff cases`, by the knees of `ray_test stability`, or else by the
/// stiff cases of other experiments; none where no row is about them.
pub(super) fn words(results: &Results, machine: Option<&str>, form: &Row) -> Option<String> {
    let is_its = |row: &&Row| {
        let usual = row.form == row.kernel && row.kernel == form.kernel;
        usual && row.precision == form.precision && machine.is_none_or(|own| row.machine == own)
    };
    let rows: Vec<&Row> = results.rows().filter(is_its).collect();
    let of = |record: &'static str| rows.iter().copied().filter(move |row| row.record == record);
    let fails = |row: &Row| {
        let wrong = [row.deep_false_hits, row.deep_false_misses, row.nan_outputs];
        wrong.iter().flatten().sum::<u64>() > 0
    };
    let knees: Vec<bool> = of("knee").map(|row| row.knee.is_some()).collect();
    let cases = || of("cases").filter(|row| row.drive == "single").map(fails).collect();
    let failed: Vec<bool> = if knees.is_empty() { cases() } else { knees };
    let families = count(failed.len(), "family", "families");
    let failing = failed.iter().filter(|fails| **fails).count();
    (!failed.is_empty()).then(|| format!("fails in {failing} of {families} of stiff cases"))
}

//! What rows without a clock say of a form: its errors, and the rays that it loses.

use crate::table::Row;

/// The largest 99th percentile of a weight's error over random hits, and the row that has it: the
/// form's own, or one of the same arithmetic. `None` where no row tells.
pub(super) fn error<'a>(rows: &[&'a Row], form: &Row) -> Option<(f64, &'a Row)> {
    let tells = |row: &&&Row| row.workload == "errors-random" && row.err_against == "exact";
    let alike = |row: &&&Row| {
        let of = |row: &Row| {
            let Row { kernel, precision, division, stored, reciprocal, edges, cross, .. } = row;
            [kernel, precision, division, stored, reciprocal, edges, cross].map(String::clone)
        };
        of(row) == of(form)
    };
    let all: Vec<&&Row> = rows.iter().filter(tells).filter(alike).collect();
    let closeness: [&dyn Fn(&Row) -> bool; 3] =
        [&|row| row.id == form.id, &|row| row.rounding == form.rounding, &|_| true];
    let close = closeness.into_iter().map(|is_close| {
        let of_row = |row: &&'a Row| Some((row.err_b_p99?, *row));
        let close = all.iter().filter(|row| is_close(row)).filter_map(|row| of_row(row));
        close.reduce(|worst, next| if next.0 > worst.0 { next } else { worst })
    });
    close.flatten().next()
}

/// What is known of the rays that a form loses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Leaks<'a> {
    /// No row is about leaks.
    NobodyLooked,
    /// There are such rows, but none of this form.
    Unknown,
    /// So many of so many rays, and one of the rows.
    Counted(u64, u64, &'a Row),
}

/// The leaks of a form on closed meshes.
pub(super) fn leaks<'a>(rows: &[&'a Row], form: &Row) -> Leaks<'a> {
    let all: Vec<&'a Row> = rows.iter().copied().filter(|row| row.record == "leaks").collect();
    if all.is_empty() {
        return Leaks::NobodyLooked;
    }
    let alike = |row: &&&'a Row| {
        let of = |row: &Row| {
            [&row.kernel, &row.precision, &row.rounding, &row.edges, &row.cross].map(String::clone)
        };
        of(row) == of(form) && ["", "kept"].contains(&row.subnormals.as_str())
    };
    let alike: Vec<&'a Row> = all.iter().filter(alike).copied().collect();
    // Edges are decided by signs, before anything is divided: the other division will do.
    let own = |row: &&&'a Row| row.division == form.division;
    let mut chosen: Vec<&'a Row> = alike.iter().filter(own).copied().collect();
    if chosen.is_empty() {
        chosen = alike;
    }
    let sum = |of: fn(&Row) -> Option<u64>| chosen.iter().filter_map(|row| of(row)).sum();
    match chosen.first() {
        None => Leaks::Unknown,
        Some(first) => Leaks::Counted(sum(|row| row.leaks), sum(|row| row.cases), first),
    }
}

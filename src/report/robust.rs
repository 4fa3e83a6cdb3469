//! Which kernel to take where robustness matters: the one that loses the fewest rays and fails on
//! the fewest families of stiff cases, and what it costs.

use super::answers::{Answer, best_cell, fastest, picked};
use super::words::count;
use crate::table::Row;

/// How a form fails: what is worse comes first.
#[derive(Clone, Debug, Default, PartialEq)]
struct Failures {
    /// Rays lost of those through closed meshes, per million, over all classes of aims.
    leaks: f64,
    /// Families in which it fails at some setting.
    families: usize,
    /// Families that it was put to.
    of: usize,
    /// Whether it was put to closed meshes.
    meshes: bool,
    /// Decisions deep in the wrong, and answers that are no numbers, over all cases.
    wrong: u64,
}

impl Failures {
    fn key(&self) -> (f64, usize, u64) {
        (self.leaks, self.families, self.wrong)
    }
}

/// The answer; none where no row is about stiff cases.
pub(super) fn answer(rows: &[&Row]) -> Option<Answer> {
    let swept = rows.iter().any(|row| ["knee", "leaks"].contains(&row.record.as_str()));
    let mut forms = if swept { of_sweep(rows) } else { of_stiff_cases(rows) };
    forms.sort_by(|a, b| {
        let ((leaks, families, wrong), other) = (a.1.key(), b.1.key());
        leaks.total_cmp(&other.0).then((families, wrong).cmp(&(other.1, other.2)))
    });
    // Of those that fail equally rarely, the fastest.
    let (_, least) = forms.first()?;
    let equal: Vec<&str> = forms
        .iter()
        .filter(|(_, failures)| failures.key() == least.key())
        .map(|(kernel, _)| kernel.as_str())
        .collect();
    let timed = |kernels: &[&str]| {
        let usual = |row: &&&Row| {
            kernels.contains(&row.kernel.as_str())
                && row.precision == "f32"
                && row.drive.starts_with("single")
                && row.output == "tuv"
                && row.status == "ok"
                && row.ns_per_test.is_some_and(|time| time > 0.0)
        };
        let rows: Vec<&Row> = rows.iter().filter(usual).copied().collect();
        best_cell(&rows).and_then(|cell| fastest(cell.into_iter()))
    };
    let other = forms.iter().find(|(_, failures)| failures.key() != least.key());
    let runner_up =
        other.map_or(String::new(), |(kernel, failures)| format!("{kernel}: {}", said(failures)));
    let need = "robustness, single rays in f32".to_owned();
    let note = said(least);
    let names = equal.join(", ");
    let answer = timed(&equal).map(|row| picked(row, rows));
    Some(Answer {
        need,
        note,
        runner_up,
        ..answer.unwrap_or(Answer { variant: names, ..Answer::default() })
    })
}

fn said(failures: &Failures) -> String {
    let mut parts = Vec::new();
    if failures.meshes && failures.leaks == 0.0 {
        parts.push("no ray lost through closed meshes".to_owned());
    }
    if failures.of > 0 {
        let families = count(failures.of, "family", "families");
        parts.push(format!("fails in {} of {families}", failures.families));
    }
    let leaks = crate::chart::short_figure(failures.leaks);
    match failures.leaks > 0.0 {
        true => parts.push(format!("loses {leaks} rays in a million")),
        false if failures.wrong > 0 => parts.push(format!("{} wrong decisions", failures.wrong)),
        false => {}
    }
    if parts.is_empty() { "no wrong decision".to_owned() } else { parts.join(", ") }
}

/// Adds to what is known of a form.
fn at<'a>(forms: &'a mut Vec<(String, Failures)>, kernel: &str) -> Option<&'a mut Failures> {
    if !forms.iter().any(|(known, _)| known == kernel) {
        forms.push((kernel.to_owned(), Failures::default()));
    }
    forms.iter_mut().find(|(known, _)| known == kernel).map(|(_, failures)| failures)
}

/// Whether a row is of a form without anything unusual: `form` is the kernel then.
fn is_usual(row: &Row) -> bool {
    row.precision == "f32" && !row.kernel.is_empty() && row.form == row.kernel
}

/// From the knees and leaks of `ray_test stability`. Leaks are the mean over the classes of aims.
fn of_sweep(rows: &[&Row]) -> Vec<(String, Failures)> {
    let mut forms = Vec::new();
    let mut classes: Vec<(String, u64)> = Vec::new();
    for row in rows.iter().filter(|row| is_usual(row)) {
        let Some(failures) = at(&mut forms, &row.kernel) else { continue };
        match row.record.as_str() {
            "knee" => {
                failures.of += 1;
                failures.families += usize::from(row.knee.is_some());
            }
            "leaks" => {
                failures.meshes = true;
                failures.leaks += row.leaks_per_million.unwrap_or(0.0);
                match classes.iter_mut().find(|(kernel, _)| *kernel == row.kernel) {
                    Some((_, count)) => *count += 1,
                    None => classes.push((row.kernel.clone(), 1)),
                }
            }
            _ => {}
        }
    }
    for (kernel, classes) in classes {
        if let Some(failures) = at(&mut forms, &kernel) {
            failures.leaks /= classes as f64;
        }
    }
    // A form that was put to fewer families, or to no mesh, cannot be compared.
    let most = forms.iter().map(|(_, failures)| failures.of).max().unwrap_or(0);
    forms.retain(|(_, failures)| failures.of == most);
    forms
}

/// From the stiff cases of other experiments.
fn of_stiff_cases(rows: &[&Row]) -> Vec<(String, Failures)> {
    let mut forms = Vec::new();
    let is_stiff = |row: &&&Row| row.record == "cases" && is_usual(row) && row.drive == "single";
    for row in rows.iter().filter(is_stiff) {
        let Some(failures) = at(&mut forms, &row.kernel) else { continue };
        let counts = [row.deep_false_hits, row.deep_false_misses, row.nan_outputs];
        let wrong: u64 = counts.iter().flatten().sum();
        failures.of += 1;
        failures.families += usize::from(wrong > 0);
        failures.wrong += wrong;
    }
    forms
}

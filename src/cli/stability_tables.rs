//! The summary of a sweep: knees, leaks, and what kernels do where there is nothing to hit.

use serde_json::{Value, json};

use super::show::{self, Sheet};
use crate::table::{Cell, Row};

/// Columns of the summary for programs.
const COLUMNS: [&str; 21] = [
    "record",
    "form",
    "kernel",
    "precision",
    "id",
    "workload",
    "knob_name",
    "knob",
    "knee",
    "ray_class",
    "cases",
    "exact_hits",
    "hits",
    "false_hits",
    "false_misses",
    "nan_outputs",
    "hits_of_not_finite",
    "leaks",
    "leaks_per_million",
    "leaks_bound_per_million",
    "double_hits_per_million",
];

/// Families whose cases have an answer that is known beforehand.
const SPECIAL: [&str; 5] = ["axis-aligned", "t-zero", "coplanar", "degenerate", "not-finite"];

/// The summary for programs: knees, leaks, and the families of exact zeros and of no answer.
pub fn sheet(rows: &[Row]) -> Sheet {
    let shown = rows.iter().filter(|row| {
        ["knee", "leaks"].contains(&row.record.as_str()) || SPECIAL.contains(&row.family.as_str())
    });
    let value = |row: &Row, column: &&str| row.cell(column).map_or(Value::Null, |cell| json!(cell));
    let values = |row: &Row| COLUMNS.iter().map(|column| value(row, column)).collect();
    Sheet { columns: COLUMNS.to_vec(), rows: shown.map(values).collect() }
}

/// The summary to read: per precision a table of knees, of leaks and of special cases.
pub fn text(rows: &[Row]) -> String {
    let mut out = String::new();
    for precision in ["f32", "f64"] {
        let of: Vec<&Row> = rows.iter().filter(|row| row.precision == precision).collect();
        for (title, table) in [
            (
                "first setting of the knob at which a kernel fails (- never); `ray_test list \
                 families` says what the knobs are",
                knees(&of, false),
            ),
            ("the same with subnormal numbers flushed to zero", knees(&of, true)),
            (
                "rays lost in a million, by what they are aimed at (< bound where none was seen); \
                 hit twice, of rays at vertices",
                leaks(&of),
            ),
            (
                "hits in a million cases where there is nothing to hit; t=0: share of hits in %; \
                 outputs that are not finite: count",
                special(&of),
            ),
        ] {
            if let Some(table) = table {
                out += &format!("\n{precision}: {title}\n{table}\n");
            }
        }
    }
    out
}

/// A table of forms by columns; `None` without rows.
fn table(
    forms: &[&str],
    columns: &[(String, &str)],
    cell: impl Fn(&str, &str) -> String,
) -> Option<String> {
    if forms.is_empty() || columns.is_empty() {
        return None;
    }
    let mut lines = vec![vec!["kernel".to_owned()]];
    lines[0].extend(columns.iter().map(|(title, _)| title.clone()));
    for form in forms {
        let cells = columns.iter().map(|(_, column)| cell(form, column));
        lines.push(std::iter::once((*form).to_owned()).chain(cells).collect());
    }
    Some(show::aligned(&lines))
}

fn distinct<'a>(rows: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut names = Vec::new();
    for name in rows {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// The knees of forms that keep subnormal numbers, or of those that flush them.
fn knees(rows: &[&Row], flushed: bool) -> Option<String> {
    let is_wanted = |row: &&&Row| row.record == "knee" && (row.subnormals == "flushed") == flushed;
    let knees: Vec<&&Row> = rows.iter().filter(is_wanted).collect();
    let families = distinct(knees.iter().map(|row| row.family.as_str()));
    let columns: Vec<(String, &str)> =
        families.into_iter().map(|family| (family.replace('-', "\n"), family)).collect();
    let forms = distinct(knees.iter().map(|row| row.form.as_str()));
    table(&forms, &columns, |form, family| {
        let row = knees.iter().find(|row| row.form == form && row.family == family);
        row.map_or(String::new(), |row| row.knee.map_or("-".to_owned(), |knee| knee.to_string()))
    })
}

fn leaks(rows: &[&Row]) -> Option<String> {
    let leaks: Vec<&&Row> = rows.iter().filter(|row| row.record == "leaks").collect();
    let classes = distinct(leaks.iter().map(|row| row.ray_class.as_str()));
    let mut columns: Vec<(String, &str)> =
        classes.iter().map(|class| (class.replace(' ', "\n"), *class)).collect();
    columns.push(("vertex\ntwice".to_owned(), "twice"));
    let forms = distinct(leaks.iter().map(|row| row.form.as_str()));
    table(&forms, &columns, |form, column| {
        let class = if column == "twice" { "vertex" } else { column };
        let row = leaks.iter().find(|row| row.form == form && row.ray_class == class);
        let Some(row) = row else { return String::new() };
        let shown = |value: Option<f64>| value.map_or(String::new(), rounded);
        match (column, row.leaks_bound_per_million) {
            ("twice", _) => shown(row.double_hits_per_million),
            (_, Some(bound)) => format!("<{}", rounded(bound)),
            _ => shown(row.leaks_per_million),
        }
    })
}

fn rounded(value: f64) -> String {
    if value >= 100.0 { format!("{value:.0}") } else { show::rounded(&json!(value)) }
}

/// The special cases: column, family, and the kinds of it that are meant.
const SPECIAL_COLUMNS: [(&str, &str, &[f64]); 7] = [
    ("axis-\naligned\nwrong", "axis-aligned", &[0.0]),
    ("t=0", "t-zero", &[0.0]),
    ("co-\nplanar", "coplanar", &[0.0]),
    ("zero\narea", "degenerate", &[1.0, 2.0, 3.0, 4.0]),
    ("NaN\ninput", "not-finite", &[1.0]),
    ("inf\ninput", "not-finite", &[2.0, 3.0]),
    ("not\nfinite\noutputs", "", &[]),
];

fn special(rows: &[&Row]) -> Option<String> {
    let cells: Vec<&&Row> = rows.iter().filter(|row| row.record == "cases").collect();
    if !cells.iter().any(|row| SPECIAL.contains(&row.family.as_str())) {
        return None;
    }
    let usual = |row: &&&&Row| SPECIAL.contains(&row.family.as_str());
    let forms = distinct(cells.iter().filter(usual).map(|row| row.form.as_str()));
    let titles = SPECIAL_COLUMNS.iter().map(|(title, ..)| ((*title).to_owned(), *title));
    let columns: Vec<(String, &str)> = titles.collect();
    table(&forms, &columns, |form, column| {
        let Some((_, family, kinds)) = SPECIAL_COLUMNS.iter().find(|(title, ..)| *title == column)
        else {
            return String::new();
        };
        let mine: Vec<&Row> = rows
            .iter()
            .filter(|row| row.form == form)
            .filter(|row| {
                let kind = row.knob.is_some_and(|knob| kinds.contains(&knob));
                family.is_empty() || (row.family == *family && kind)
            })
            .copied()
            .collect();
        special_cell(family, &mine)
    })
}

fn special_cell(family: &str, rows: &[&Row]) -> String {
    let sum = |column: &str| -> f64 {
        rows.iter().filter_map(|row| row.cell(column).and_then(Cell::number)).sum()
    };
    let cases = sum("cases");
    match family {
        // Sums of a leak table repeat what its rows count.
        "" => {
            let cells = rows.iter().filter(|row| row.record != "leaks");
            cells.filter_map(|row| row.nan_outputs).sum::<u64>().to_string()
        }
        _ if cases == 0.0 => String::new(),
        "t-zero" => rounded(sum("hits") / cases * 100.0),
        "axis-aligned" => rounded((sum("false_hits") + sum("false_misses")) / cases * 1e6),
        _ => rounded(sum("hits") / cases * 1e6),
    }
}

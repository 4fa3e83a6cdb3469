//! The figures of a sweep over stiff and extreme cases.

use super::Wanted;
use super::envelope::Envelope;
use super::figure::{Figure, Kind, Names, Scale, Within};
use crate::table::Row;
use std::collections::BTreeMap;

/// Series that stay within this factor of the best, a digit, are drawn together.
const CROWD: f64 = 10.0;
/// An error of 10 is as wrong as one of 1e20.
const LIMIT: f64 = 10.0;

/// What there is to draw of the rows of `ray_test stability`: knees and leaks per precision, and
/// per family the errors over its knob.
pub fn stability_figures(rows: &[Row]) -> Vec<Figure> {
    let mut figures = Vec::new();
    for (precision, roundoff) in [("f32", f32::EPSILON as f64 / 2.0), ("f64", f64::EPSILON / 2.0)] {
        let has = |record: &str| {
            rows.iter().any(|row| row.record == record && row.precision == precision)
        };
        if has("knee") {
            figures.push(knees(rows, precision));
        }
        if has("leaks") {
            figures.push(leaks(precision));
        }
        let mut seen: Vec<(&str, &str)> = Vec::new();
        let is_knee = |row: &&Row| row.record == "knee" && row.precision == precision;
        // The row of the inputs has no form that keeps or flushes anything.
        for row in rows.iter().filter(is_knee).filter(|row| !row.kernel.is_empty()) {
            if !seen.contains(&(&row.family, &row.subnormals)) {
                seen.push((&row.family, &row.subnormals));
                figures.push(errors(row, roundoff));
            }
        }
    }
    figures
}

fn filter(pairs: &[(&str, &str)]) -> BTreeMap<String, Wanted> {
    let pair =
        |(column, value): &(&str, &str)| ((*column).to_owned(), Wanted::Word((*value).to_owned()));
    pairs.iter().map(pair).collect()
}

/// A figure of which only the name, the kind and the question are known.
pub(super) fn blank(file: String, kind: Kind, question: String) -> Figure {
    Figure {
        file,
        kind,
        question,
        subtitle: String::new(),
        x: Names::default(),
        y: String::new(),
        also: Vec::new(),
        y_below: None,
        x_title: None,
        y_title: None,
        y_below_title: None,
        series: Names::default(),
        panels: None,
        filter: BTreeMap::new(),
        published: None,
        scale: Scale::Linear,
        x_scale: Scale::Linear,
        normalise_to: None,
        normalise: Within::Panel,
        x_marks: Names::default(),
        reference: None,
        envelope: None,
        bound: None,
        shown: None,
        apart: None,
        over: None,
        x_low: None,
        x_high: None,
        errors_from: BTreeMap::new(),
        labels: BTreeMap::new(),
        bare: false,
    }
}

fn named(words: &str) -> Names {
    Names::One(words.to_owned())
}

fn knees(rows: &[Row], precision: &str) -> Figure {
    let error = if precision == "f32" { "1e-3" } else { "1e-9" };
    // The row without a kernel is that of the problems themselves.
    let apart = rows.iter().find(|row| row.record == "knee" && row.kernel.is_empty());
    Figure {
        subtitle: format!(
            "{precision}: first setting of the knob with an error of t or of a weight above \
             {error} (99th percentile), or 1000 decisions in a million deep in the wrong"
        ),
        x: named("family"),
        y: "knee_share".to_owned(),
        y_title: Some("dark: fails at the first settings; white: never".to_owned()),
        series: named("form"),
        shown: Some("knee".to_owned()),
        apart: apart.map(|row| row.form.clone()),
        filter: filter(&[("record", "knee"), ("precision", precision)]),
        ..blank(
            format!("knees-{precision}"),
            Kind::Heat,
            "Where does each kernel start to fail?".to_owned(),
        )
    }
}

fn leaks(precision: &str) -> Figure {
    Figure {
        subtitle: format!(
            "{precision}: rays through closed meshes that hit no triangle, per million, by what \
             they are aimed at"
        ),
        x: named("form"),
        y: "leaks_per_million".to_owned(),
        y_title: Some("rays lost in a million".to_owned()),
        series: named("record"),
        panels: Some("ray_class".to_owned()),
        scale: Scale::Log,
        bound: Some("leaks_bound_per_million".to_owned()),
        filter: filter(&[("record", "leaks"), ("precision", precision)]),
        ..blank(
            format!("leaks-{precision}"),
            Kind::Bars,
            "Which kernels lose rays at edges and vertices?".to_owned(),
        )
    }
}

/// The errors of a family's row, over its knob; forms that flush subnormal numbers apart.
fn errors(row: &Row, roundoff: f64) -> Figure {
    let (family, precision, knob) = (&row.family, &row.precision, &row.knob_name);
    let flushed = row.subnormals == "flushed";
    let (suffix, note) =
        if flushed { ("-flushed", ", subnormal numbers flushed to zero") } else { ("", "") };
    let labels = [("err_t_p99_rel", "t, relative error"), ("err_b_p99", "u, v, w, absolute error")];
    Figure {
        subtitle: format!("{precision}, 99th percentile of the hits{note}"),
        x: named("knob"),
        x_title: Some(format!("k; {knob}")),
        y: "err_t_p99_rel".to_owned(),
        also: vec!["err_b_p99".to_owned()],
        y_title: Some("error".to_owned()),
        series: named("form"),
        scale: Scale::Log,
        filter: filter(&[
            ("record", "cases"),
            ("family", family),
            ("precision", precision),
            ("subnormals", &row.subnormals),
        ]),
        envelope: Some(Envelope {
            columns: vec!["kappa_t_p99".to_owned(), "kappa_b_p99".to_owned()],
            factor: roundoff,
            crowd: CROWD,
            limit: LIMIT,
            name: "what a rounding of the inputs does (99th percentile)".to_owned(),
        }),
        labels: labels.map(|(column, words)| (column.to_owned(), words.to_owned())).into(),
        ..blank(
            format!("{family}{suffix}-{precision}"),
            Kind::Lines,
            format!("How wrong do answers get? Family {family}"),
        )
    }
}

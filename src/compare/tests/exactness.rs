//! What counts as less exact.

use super::*;
use crate::compare::exactness::ERRORS;

fn changed(change: impl Fn(&mut Row)) -> Comparison {
    let subject = |row: &mut Row| row.id == SUBJECT && row.order == "fixed";
    at_3_percent(
        &base(),
        &with(|row| {
            if subject(row) {
                change(row)
            }
        }),
    )
}

#[test]
fn every_column_of_errors_judges() {
    for column in ERRORS {
        let of = |value: &'static str| {
            with(move |row| {
                if row.id == SUBJECT && row.order == "fixed" {
                    row.set(column, value).expect("a number")
                }
            })
        };
        let worse = at_3_percent(&of("4"), &of("6"));
        assert_eq!(worse.verdict, Verdict::Regressed, "{column}");
        assert_eq!(figures(&worse.regressions), [(SUBJECT, column)]);
        let change = &worse.regressions[0].change;
        assert!((change.ratio.unwrap() - 1.5).abs() < 1e-12);
        assert_eq!((change.low, change.high), (None, None));
        let better = at_3_percent(&of("6"), &of("4"));
        assert_eq!(better.verdict, Verdict::Improved, "{column}");
        assert_eq!(figures(&better.improvements), [(SUBJECT, column)]);
    }
}

#[test]
fn no_figure_of_accuracy_is_forgotten() {
    let is_figure = |column: &&&str| {
        let name = ["err_", "false_", "deep_", "backward_"].iter().any(|s| column.starts_with(s))
            || column.contains("bits_lost")
            || column.ends_with("excess_max");
        // A column that takes a word is none.
        name && Row::default().set(column, "word").is_err()
    };
    // How many there are, and what is made of the others.
    let told_otherwise = ["err_cases", "err_tuv_mean_rel", "err_ratio_to_exact"];
    let figures: Vec<&&str> = crate::table::COLUMNS.iter().filter(is_figure).collect();
    assert!(figures.len() > 25, "{figures:?}");
    for column in figures {
        assert!(ERRORS.contains(column) || told_otherwise.contains(column), "{column}");
    }
}

#[test]
fn what_errors_are_against_is_part_of_what_was_measured() {
    // Against the exact answer and against another kernel, the same subject has two rows.
    let both = |worse: f64| {
        let mut rows = rows();
        let subject = rows.iter().position(|row| row.id == SUBJECT).unwrap();
        let mut row = rows[subject].clone();
        row.err_against = "moller-trumbore-f64".into();
        row.err_t_mean_rel = Some(2e-7 * worse);
        rows.insert(0, row);
        side(rows)
    };
    assert_eq!(at_3_percent(&both(1.0), &both(1.0)).verdict, Verdict::Same);
    let worse = at_3_percent(&both(1.0), &both(1.5));
    assert_eq!(figures(&worse.regressions), [(SUBJECT, "err_t_mean_rel")]);
}

#[test]
fn from_nothing_there_is_no_ratio() {
    let comparison = changed(|row| row.nan_outputs = Some(1));
    let change = &comparison.regressions[0].change;
    assert_eq!((change.figure, change.ratio), ("nan_outputs", None));
    assert_eq!((change.base.as_u64(), change.new.as_u64()), (Some(0), Some(1)));
    // What is missing on one side says nothing.
    assert_eq!(changed(|row| row.err_t_max_ulp = None).verdict, Verdict::Same);
}

#[test]
fn a_status_that_is_worse_judges() {
    for status in ["wrong-result", "inexact"] {
        let worse = changed(|row| row.status = status.into());
        assert_eq!(figures(&worse.regressions), [(SUBJECT, "status")], "{status}");
        let spoilt = with(|row| row.status = status.into());
        assert_eq!(at_3_percent(&spoilt, &base()).verdict, Verdict::Improved, "{status}");
    }
    // A guard that did not believe the clock says nothing of the answers.
    for status in ["invalid", "skipped", "not-measured", ""] {
        assert_eq!(changed(|row| row.status = status.into()).verdict, Verdict::Same, "{status}");
    }
}

#[test]
fn other_answers_judge_unless_they_are_better_ones() {
    let other = |row: &mut Row| {
        row.hits = Some(501);
        row.outputs_hash = "dead".into();
    };
    let comparison = changed(other);
    assert_eq!(figures(&comparison.regressions), [(SUBJECT, "outputs_hash"), (SUBJECT, "hits")]);
    let better = changed(|row| {
        other(row);
        row.false_misses = Some(1);
    });
    assert_eq!(better.verdict, Verdict::Improved);
    let mixed = changed(|row| {
        other(row);
        row.false_misses = Some(1);
        row.err_t_max_ulp = Some(10.0);
    });
    assert_eq!(mixed.regressions.len(), 3);
    // Older files have no such hash.
    assert_eq!(changed(|row| row.outputs_hash.clear()).verdict, Verdict::Same);
}

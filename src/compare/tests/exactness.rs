//! What counts as less exact.

use super::*;

type Setter = fn(&mut Row, f64);

/// Each column with a way to set it to the value in the base times a factor.
const ERRORS: [(&str, Setter); 7] = [
    ("false_misses", |row, factor| row.false_misses = Some((2.0 * factor) as u64)),
    ("err_t_mean_rel", |row, factor| row.err_t_mean_rel = Some(1e-7 * factor)),
    ("err_t_p999_ulp", |row, factor| row.err_t_p999_ulp = Some(3.0 * factor)),
    ("err_t_max_ulp", |row, factor| row.err_t_max_ulp = Some(9.0 * factor)),
    ("err_u_max_abs", |row, factor| row.err_u_max_abs = Some(1e-6 * factor)),
    ("err_v_max_abs", |row, factor| row.err_v_max_abs = Some(1e-6 * factor)),
    // Away from 0 in the base: then there is a quotient to look at.
    ("false_hits", |row, factor| row.false_hits = Some((4.0 * factor) as u64)),
];

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
    for (column, set) in ERRORS {
        let of = |factor: f64| {
            with(move |row| {
                if row.id == SUBJECT && row.order == "fixed" {
                    set(row, factor)
                }
            })
        };
        let worse = at_3_percent(&of(1.0), &of(1.5));
        assert_eq!(worse.verdict, Verdict::Regressed, "{column}");
        assert_eq!(figures(&worse.regressions), [(SUBJECT, column)]);
        let change = &worse.regressions[0].change;
        assert!((change.ratio.unwrap() - 1.5).abs() < 1e-12);
        assert_eq!((change.low, change.high), (None, None));
        let better = at_3_percent(&of(1.5), &of(1.0));
        assert_eq!(better.verdict, Verdict::Improved, "{column}");
        assert_eq!(figures(&better.improvements), [(SUBJECT, column)]);
    }
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

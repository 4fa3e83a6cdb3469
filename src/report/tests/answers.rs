//! Which kernel is taken.

use super::*;
use crate::report::answers::{Answer, answers};

fn answer(rows: Vec<Row>, need: &str) -> Option<Answer> {
    let results = results(rows, &[]);
    answers(&results, None).into_iter().find(|answer| answer.need == need)
}

#[test]
fn the_fastest_of_one_cell_and_how_much_slower_the_next_kernel_is() {
    let error = Row {
        workload: "errors-random".into(),
        err_b_p99: Some(3e-7),
        ns_per_test: None,
        order: String::new(),
        ..timed("b", 1.0)
    };
    let mut slower = timed("b", 2.4);
    slower.id += "/leading=inside";
    let rows = vec![timed("a", 3.0), timed("b", 2.0), slower, timed("c", 2.5), error];
    let answer = answer(rows, "single rays").unwrap();
    assert!(answer.variant.starts_with("b/"));
    assert_eq!((answer.time.as_str(), answer.error.as_str()), ("2.00 [1.98, 2.02]", "3.00e-7"));
    assert_eq!(answer.speed, "500 [495, 505]");
    // The next of another kernel, not the next form of the same.
    assert_eq!(answer.runner_up, "c/f32/single/sse2/early/last/plain/tuv, 25 % slower");
    assert_eq!(answer.cell, "nearest-random, order reshuffled");
}

#[test]
fn rows_of_other_work_are_not_compared() {
    let other = |row: Row| Row { experiment: "second".into(), ..row };
    let mut faster = other(timed("d", 0.1));
    faster.workload_hash = "another".into();
    let rows = vec![timed("a", 3.0), timed("b", 2.0), timed("c", 2.5), faster];
    assert!(answer(rows.clone(), "single rays").unwrap().variant.starts_with("b/"));
    // In another order, which is asked for first, only one kernel was measured.
    let fixed: Vec<Row> =
        rows.into_iter().map(|row| Row { order: "fixed".into(), ..row }).collect();
    let with_other = fixed.iter().cloned().chain([timed("e", 9.0)]).collect();
    assert!(answer(with_other, "single rays").unwrap().variant.starts_with("e/"));
    assert!(answer(fixed, "single rays").unwrap().variant.starts_with("b/"));
}

#[test]
fn what_does_not_serve_every_scene_is_not_taken() {
    let spoilt: [fn(&mut Row); 8] = [
        |row| row.status = "wrong-result".into(),
        |row| row.cull = "on".into(),
        |row| row.tests_form = "sign-bits".into(),
        |row| row.reciprocal = "estimate".into(),
        |row| row.projection = "fixed".into(),
        |row| row.output = "hit".into(),
        |row| row.precision = "f64".into(),
        |row| row.drive = "packet8-common-origin".into(),
    ];
    for spoil in spoilt {
        let mut row = timed("a", 1.0);
        assert!(answer(vec![row.clone()], "single rays").is_some());
        spoil(&mut row);
        assert!(answer(vec![row], "single rays").is_none());
    }
}

#[test]
fn overlapping_intervals_are_said_to_overlap() {
    let rows = vec![timed("a", 2.0), timed("b", 2.01)];
    assert!(answer(rows, "single rays").unwrap().runner_up.ends_with("(the intervals overlap)"));
}

#[test]
fn the_robust_one_loses_no_ray_and_then_fails_in_the_fewest_families() {
    let swept = |kernel: &str, record: &str| Row {
        record: record.into(),
        form: kernel.into(),
        ns_per_test: None,
        ..timed(kernel, 1.0)
    };
    let knee = |kernel: &str, knee: Option<f64>| Row { knee, ..swept(kernel, "knee") };
    let leaks =
        |kernel: &str, rate: f64| Row { leaks_per_million: Some(rate), ..swept(kernel, "leaks") };
    let mut rows = vec![
        knee("a", None),
        leaks("a", 5.0),
        knee("b", Some(3.0)),
        leaks("b", 0.0),
        knee("c", None),
        leaks("c", 0.0),
    ];
    rows.extend([timed("a", 1.0), timed("b", 2.0), timed("c", 3.0)]);
    let found = answer(rows.clone(), "robustness, single rays in f32").unwrap();
    assert!(found.variant.starts_with("c/"), "{found:?}");
    assert_eq!(found.note, "no ray lost through closed meshes, fails in 0 of 1 family");
    assert_eq!(found.runner_up, "b: no ray lost through closed meshes, fails in 1 of 1 family");
    // Among equals the faster one.
    rows.extend([knee("d", None), leaks("d", 0.0), timed("d", 2.5)]);
    let found = answer(rows, "robustness, single rays in f32").unwrap();
    assert!(found.variant.starts_with("d/"), "{found:?}");
}

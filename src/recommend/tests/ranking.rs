//! What is compared with what, and what is said of it.

use super::*;

#[test]
fn the_fastest_is_taken_and_the_next_best_has_its_price() {
    let rows = [timed("a", "f32", "tuv", 1.0), timed("b", "f32", "tuv", 0.5)];
    let found = asked(&rows, &Question::default()).expect("both fit");
    assert_eq!(found.variant, rows[1].id);
    assert_eq!(found.runner_up.as_ref(), Some(&rows[0].id));
    assert_eq!(found.runner_up_costs_percent, Some(100.0));
    assert_eq!(found.runner_up_is_slower, Some(true));
    assert_eq!(found.code, format!("call {}", rows[1].id));
    // (0.99 / 0.505 - 1) to (1.01 / 0.495 - 1)
    assert!(says(&found, "costs +100.0 % (+96.0 % to +104.0 %)"), "{:?}", found.because);
    assert!(says(&found, "[first, nearest-random, reshuffled]"), "{:?}", found.because);
}

#[test]
fn intervals_that_overlap_are_no_price() {
    let rows = [timed("a", "f32", "tuv", 0.51), timed("b", "f32", "tuv", 0.5)];
    let found = asked(&rows, &Question::default()).expect("both fit");
    assert_eq!(found.variant, rows[1].id);
    assert_eq!(found.runner_up_is_slower, Some(false));
    assert!(says(&found, "costs nothing that can be measured"), "{:?}", found.because);
    assert!(!says(&found, "copies of one kernel"), "{:?}", found.because);
    // Nor is a difference below what copies of one kernel differ by.
    let noisy = |row: Row| Row { noise_floor: Some(0.2), ..row };
    let apart = [timed("a", "f32", "tuv", 0.55), timed("b", "f32", "tuv", 0.5)];
    assert_eq!(
        asked(&apart, &Question::default()).map(|it| it.runner_up_is_slower),
        Ok(Some(true))
    );
    let apart = apart.map(noisy);
    assert_eq!(
        asked(&apart, &Question::default()).map(|it| it.runner_up_is_slower),
        Ok(Some(false))
    );
}

#[test]
fn unforeseen_outcomes_decide_and_a_reversal_is_told() {
    let rows = [
        in_order("fixed", timed("a", "f32", "tuv", 0.5)),
        in_order("fixed", timed("b", "f32", "tuv", 0.6)),
        timed("a", "f32", "tuv", 0.9),
        timed("b", "f32", "tuv", 0.6),
    ];
    let found = asked(&rows, &Question::default()).expect("both fit");
    assert_eq!(found.variant, rows[1].id);
    assert!(says(&found, "in 1 of 1 other setting another form is faster"), "{:?}", found.because);
    assert!(says(&found, "+20.0 % over a/"), "{:?}", found.because);
    assert_eq!(kernel(&rows[..2], &Question::default()), "a");
}

#[test]
fn different_inputs_are_never_compared() {
    // In the small set b is timed at half of a; c is faster than both, on other triangles.
    let other = Row { workload_hash: "other".into(), ..timed("c", "f32", "tuv", 0.1) };
    let rows = [timed("a", "f32", "tuv", 1.0), timed("b", "f32", "tuv", 0.5), other];
    assert_eq!(kernel(&rows, &Question::default()), "b");
}

#[test]
fn experiments_on_the_same_inputs_are_joined_by_what_they_share() {
    // The second has another reference: there a is 1, and c a third of it.
    let rows = [
        timed("a", "f32", "tuv", 0.6),
        timed("b", "f32", "tuv", 0.5),
        in_experiment("second", timed("a", "f32", "tuv", 1.0)),
        in_experiment("second", timed("c", "f32", "tuv", 0.9)),
    ];
    let found = asked(&rows, &Question::default()).expect("all fit");
    assert_eq!(found.variant, rows[1].id);
    // 0.9 x 0.6 / 0.5 = 1.08
    assert_eq!(found.runner_up.as_ref(), Some(&rows[3].id));
    assert!((found.runner_up_costs_percent.expect("two fit") - 8.0).abs() < 1e-9);
    assert!(says(&found, "Experiments first, second"), "{:?}", found.because);
    // Without anything shared, one scale cannot be had.
    let found = asked(&[rows[0].clone(), rows[1].clone(), rows[3].clone()], &Question::default());
    assert_eq!(found.map(|found| found.runner_up), Ok(Some(rows[0].id.clone())));
}

#[test]
fn what_cannot_be_taken_is_left_out_and_counted() {
    let rows = [
        timed("a", "f32", "tuv", 0.5),
        timed("line", "f32", "tuv", 0.1),
        timed("far", "f32", "tuv", 0.1),
        timed("new", "f32", "tuv", 0.1),
        Row { status: "inexact".into(), ..timed("rough", "f32", "tuv", 0.1) },
    ];
    let mut known = known(&rows);
    known[1].limits = "answer for lines".into();
    known[2].available = false;
    known.remove(3);
    let found = recommend(&results(rows.to_vec()), &Question::default(), &known).expect("a fits");
    assert_eq!(found.variant, rows[0].id);
    assert_eq!(found.runner_up, None);
    let words = "Left out: 1 that answer for lines, 1 that are not in this program, 1 that have \
                 status inexact, 1 that need a level that this processor lacks.";
    assert!(says(&found, words), "{:?}", found.because);
}

#[test]
fn nothing_to_go_by_is_refused() {
    let untimed = Row { ns_per_test: None, ..timed("a", "f32", "tuv", 0.5) };
    assert!(matches!(asked(&[], &Question::default()), Err(RecommendError::NoTimes(_))));
    assert!(matches!(asked(&[untimed], &Question::default()), Err(RecommendError::NoTimes(_))));
    let question = Question { needs: Needs::Surface, ..Question::default() };
    let refused = asked(&[timed("a", "f32", "tuv", 0.5)], &question).expect_err("no surface");
    assert!(refused.to_string().contains("1 that report less than surface"), "{refused}");
}

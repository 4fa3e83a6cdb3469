//! Invented rows with a known answer, for each demand.

use super::{KnownVariant, Needs, Question, RecommendError, Recommendation, recommend};
use crate::results::{About, Chapter, Results};
use crate::table::Row;

/// A timed row of a single ray; the ratio's interval is 1 % wide to both sides.
fn timed(kernel: &str, precision: &str, output: &str, ratio: f64) -> Row {
    Row {
        experiment: "first".into(),
        id: format!("{kernel}/{precision}/single/sse2/early/last/plain/{output}"),
        kernel: kernel.into(),
        precision: precision.into(),
        drive: "single".into(),
        level: "sse2".into(),
        division: "last".into(),
        rounding: "plain".into(),
        output: output.into(),
        stored: "vertices".into(),
        workload: "nearest-random".into(),
        order: "reshuffled".into(),
        query: "ray".into(),
        status: "ok".into(),
        ns_per_test: Some(10.0 * ratio),
        cycles_per_test: Some(30.0 * ratio),
        cycles_low: Some(29.7 * ratio),
        cycles_high: Some(30.3 * ratio),
        ratio_to_reference: Some(ratio),
        ratio_low: Some(0.99 * ratio),
        ratio_high: Some(1.01 * ratio),
        ..Row::default()
    }
}

fn in_order(order: &str, row: Row) -> Row {
    Row { order: order.into(), ..row }
}

fn in_experiment(experiment: &str, row: Row) -> Row {
    Row { experiment: experiment.into(), ..row }
}

fn results(rows: Vec<Row>) -> Results {
    let about = About {
        id: "first".into(),
        title: String::new(),
        mirrors: String::new(),
        question: String::new(),
        why: String::new(),
        config: String::new(),
        command: String::new(),
        claims: Vec::new(),
        figures: Vec::new(),
    };
    let chapter = Chapter { about, rows, complete: true, workload_hash: String::new() };
    Results { sources: Vec::new(), chapters: vec![chapter] }
}

/// All variants of the rows: available, not watertight, without limits.
fn known(rows: &[Row]) -> Vec<KnownVariant> {
    let variant = |row: &Row| KnownVariant {
        id: row.id.clone(),
        available: true,
        call: format!("call {}", row.id),
        ..KnownVariant::default()
    };
    rows.iter().map(variant).collect()
}

fn asked(rows: &[Row], question: &Question) -> Result<Recommendation, RecommendError> {
    recommend(&results(rows.to_vec()), question, &known(rows))
}

/// The kernel that is recommended.
fn kernel(rows: &[Row], question: &Question) -> String {
    let found = asked(rows, question).expect("something fits");
    found.variant.split('/').next().unwrap_or_default().to_owned()
}

fn says(found: &Recommendation, words: &str) -> bool {
    found.because.iter().any(|sentence| sentence.contains(words))
}

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
fn what_reports_more_serves_and_what_reports_less_does_not() {
    let rows = [
        timed("a", "f32", "hit", 0.1),
        timed("b", "f32", "t", 0.2),
        timed("c", "f32", "tuv", 0.3),
        timed("d", "f32", "surface", 0.4),
    ];
    let needing = |needs| Question { needs, ..Question::default() };
    for (needs, expected) in
        [(Needs::Hit, "a"), (Needs::T, "b"), (Needs::Tuv, "c"), (Needs::Surface, "d")]
    {
        assert_eq!(kernel(&rows, &needing(needs)), expected);
    }
    let reversed = [timed("a", "f32", "hit", 0.4), timed("d", "f32", "surface", 0.1)];
    assert_eq!(kernel(&reversed, &needing(Needs::Hit)), "d");
}

#[test]
fn precision_is_obeyed_or_its_price_is_told() {
    let rows = [timed("a", "f32", "tuv", 0.5), timed("b", "f64", "tuv", 0.6)];
    let in_double = Question { precision: Some("f64".into()), ..Question::default() };
    assert_eq!(kernel(&rows, &in_double), "b");
    let found = asked(&rows, &Question::default()).expect("both fit");
    assert_eq!(found.variant, rows[0].id);
    assert!(says(&found, "The best in f64, b/"), "{:?}", found.because);
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
fn preparing_counts_by_the_rays_that_share_it() {
    let prepared = |kernel: &str, stored: &str, ratio, cycles| Row {
        stored: stored.into(),
        prepare_cycles_per_triangle: Some(cycles),
        ..timed(kernel, "f32", "tuv", ratio)
    };
    // A ray costs 30 + 2 / N cycles with a, 15 + 60 / N with b: equal at 58 / 15 = 3.9 rays.
    let rows = [prepared("a", "vertices", 1.0, 2.0), prepared("b", "precomputed", 0.5, 60.0)];
    let over = |rays| Question { rays_per_triangle: Some(rays), ..Question::default() };
    assert_eq!(kernel(&rows, &over(3)), "a");
    assert_eq!(kernel(&rows, &over(4)), "b");
    let found = asked(&rows, &over(6)).expect("both fit");
    assert!(says(&found, "cost 25.0 cycles a ray"), "{:?}", found.because);
    // Sums that the experiment stores are no times of their own.
    let sum = Row { rays_per_triangle: Some(1), ratio_to_reference: Some(0.01), ..rows[0].clone() };
    let [a, b] = rows;
    assert_eq!(kernel(&[a, b, sum], &over(4)), "b");
}

#[test]
fn without_a_price_of_preparing_few_rays_get_what_prepares_nothing() {
    let rows = [
        timed("a", "f32", "tuv", 1.0),
        Row { stored: "precomputed".into(), ..timed("b", "f32", "tuv", 0.5) },
    ];
    let over = |rays| Question { rays_per_triangle: Some(rays), ..Question::default() };
    assert_eq!(kernel(&rows, &over(10)), "a");
    assert_eq!(kernel(&rows, &over(11)), "b");
    let found = asked(&rows, &over(10)).expect("a fits");
    assert!(says(&found, "it cannot lose by preparing"), "{:?}", found.because);
}

fn leaking(kernel: &str, leaks: u64) -> Row {
    Row {
        record: "leaks".into(),
        experiment: "stability".into(),
        leaks: Some(leaks),
        cases: Some(1000),
        ns_per_test: None,
        ..timed(kernel, "f32", "tuv", 1.0)
    }
}

#[test]
fn watertight_is_what_is_said_to_be_and_loses_none() {
    let rows = [
        timed("a", "f32", "tuv", 0.1),
        timed("b", "f32", "tuv", 0.2),
        timed("c", "f32", "tuv", 0.3),
    ];
    let question = Question { watertight: true, ..Question::default() };
    let mut known = known(&rows);
    known[1].watertight = true;
    known[2].watertight = true;
    let with = |more: &[Row]| {
        let rows = rows.iter().chain(more).cloned().collect();
        recommend(&results(rows), &question, &known).expect("one fits")
    };
    let unseen = with(&[]);
    assert_eq!(unseen.variant, rows[1].id);
    assert!(says(&unseen, "watertight by its construction"), "{:?}", unseen.because);
    let seen = with(&[leaking("b", 1), leaking("c", 0)]);
    assert_eq!(seen.variant, rows[2].id);
    assert!(says(&seen, "lost none of 1000 rays"), "{:?}", seen.because);
    // Others were looked at, b was not.
    assert_eq!(with(&[leaking("c", 0)]).variant, rows[2].id);
}

#[test]
fn a_tolerance_is_held_by_the_errors_of_the_same_arithmetic() {
    let erring = |row: &Row, error| Row {
        workload: "errors-random".into(),
        err_against: "exact".into(),
        err_b_p99: Some(error),
        ns_per_test: None,
        ..row.clone()
    };
    let fused =
        Row { rounding: "fused".into(), id: "a/fused".into(), ..timed("a", "f32", "tuv", 0.1) };
    let (a, b) = (timed("a", "f32", "tuv", 0.2), timed("b", "f32", "tuv", 0.3));
    let rows = [fused, a.clone(), b.clone(), erring(&a, 1e-6), erring(&a, 3e-6), erring(&b, 1e-7)];
    let within = |tolerance| Question { tolerance: Some(tolerance), ..Question::default() };
    assert_eq!(kernel(&rows, &within(1e-6)), "b");
    let found = asked(&rows, &within(3e-6)).expect("all fit");
    assert_eq!(found.variant, "a/fused");
    assert!(says(&found, "errs by more than 3.0e-6"), "{:?}", found.because);
    let refused = asked(&rows, &within(1e-8)).expect_err("none fits");
    assert!(refused.to_string().contains("3 that err more"), "{refused}");
}

#[test]
fn packets_come_only_when_allowed() {
    let packet = Row { drive: "packet8".into(), id: "p".into(), ..timed("a", "f32", "tuv", 0.1) };
    let shared = Row { drive: "packet8-parallel".into(), id: "q".into(), ..packet.clone() };
    let rows = [timed("a", "f32", "tuv", 0.5), packet, shared];
    assert_eq!(asked(&rows, &Question::default()).map(|it| it.variant), Ok(rows[0].id.clone()));
    let question = Question { packets: true, ..Question::default() };
    assert_eq!(asked(&rows, &question).map(|it| it.variant), Ok("p".to_owned()));
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

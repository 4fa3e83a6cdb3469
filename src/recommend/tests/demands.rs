//! Each demand takes away what does not meet it.

use super::*;

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
    let from_one = Row { drive: "packet8-common-origin".into(), id: "s".into(), ..packet.clone() };
    let from_one = Row { ratio_to_reference: Some(0.05), ..from_one };
    let group = Row { drive: "group8".into(), id: "g".into(), ..packet.clone() };
    let rows = [timed("a", "f32", "tuv", 0.5), packet, shared, from_one, group];
    assert_eq!(asked(&rows, &Question::default()).map(|it| it.variant), Ok(rows[0].id.clone()));
    let packets = |packets| Question { packets, ..Question::default() };
    let taken = |question| asked(&rows, &question).map(|it| it.variant);
    assert_eq!(taken(packets(Packets::OfAnyRays)), Ok("p".to_owned()));
    assert_eq!(taken(packets(Packets::FromOnePoint)), Ok("s".to_owned()));
    let refused = asked(&rows, &packets(Packets::OfAnyRays)).expect("p fits");
    let words = "Left out: 2 that take rays that share an origin or a direction, 1 that take rays or \
                 triangles by groups or bundles.";
    assert!(says(&refused, words), "{:?}", refused.because);
}

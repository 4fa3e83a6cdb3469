//! Work-precision charts: every kernel in two precisions, and what must not stretch an axis.

use super::*;

const PRECISION: &str = r#"
    file = "precision"
    kind = "precision"
    question = "Which kernel do I take if I can afford this error, or this time?"
    subtitle = "Made up."
    x = "err_b_p99"
    x_low = "err_b_p50"
    x_high = "err_b_max"
    y = "ns_per_test"
    panels = "order"
    filter = { order = ["fixed", "reshuffled"] }
"#;

fn dot(kernel: &str, precision: &str, ns: f64, error: f64) -> Row {
    let row = Row {
        id: format!("{kernel}/{precision}"),
        precision: precision.into(),
        order: "fixed".into(),
        err_b_p50: Some(error / 4.0),
        err_b_p99: Some(error),
        err_b_max: Some(error * 8.0),
        ..row("precision", kernel)
    };
    timed(row, ns)
}

/// Many kernels in two orders, both precisions close together in time and in error.
fn crowd(kernels: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    for number in 0..kernels {
        let kernel = format!("kernel-of-number-{number}");
        // Scattered, but the same in every run.
        let scatter = |step: f64| (number as f64 * step).fract();
        for (precision, unit) in [("f32", 1e-7), ("f64", 2e-16)] {
            let error = unit * (1.0 + 9.0 * scatter(0.754_877_666));
            let ns = 6.0 + 12.0 * scatter(0.618_034);
            rows.push(dot(&kernel, precision, ns, error));
            let reshuffled = dot(&kernel, precision, 15.0 + 0.5 * ns, error);
            rows.push(Row { order: "reshuffled".into(), ..reshuffled });
        }
    }
    rows
}

#[test]
fn every_kernel_in_both_precisions_and_two_orders() {
    let svg = drawn(&figure(PRECISION), &crowd(28));
    let texts = boxes::texts(&svg);
    for number in 0..28 {
        let name = format!("kernel-of-number-{number}");
        let count = texts.iter().filter(|text| text.words == name).count();
        let listed = svg.matches(&format!("{name} f")).count();
        assert!(count + listed >= 4, "{name}: {count} labels, {listed} listed");
        assert!(count >= 2, "{name} has {count} labels");
    }
    assert!(svg.contains("the error axis leaves out decades"));
}

#[test]
fn a_point_is_dominated_only_beyond_doubt() {
    let mut rows = vec![
        dot("fast", "f32", 10.0, 8e-7),
        // Slower and worse than `fast`: by much, and by less than their intervals.
        dot("slow", "f32", 15.0, 9e-7),
        dot("close", "f32", 10.1, 9e-7),
        dot("exact", "f32", 20.0, 1e-7),
        // Its 99th percentile is worse than that of `fast`, its largest error is not.
        Row { err_b_max: Some(7e-6), ..dot("steady", "f32", 15.0, 9e-7) },
        Row { err_b_max: Some(6e-6), ..dot("steadier", "f32", 17.0, 9e-7) },
        // Another precision is another question.
        dot("double", "f64", 30.0, 1e-15),
    ];
    rows[4].err_b_max = Some(6.3e-6);
    let svg =
        drawn(&figure(&PRECISION.replace("\"precision\"\n    kind", "\"doubt\"\n    kind")), &rows);
    let front = svg.split("Front: ").nth(1).expect("it is told");
    for (name, is_front) in [
        ("fast", true),
        ("slow", false),
        ("close", true),
        ("exact", true),
        ("steady", true),
        ("steadier", true),
        ("double", true),
    ] {
        let told = front.contains(&format!("{name} f"));
        assert_eq!(told, is_front, "{name}: {front:.400}");
    }
}

#[test]
fn what_is_far_behind_is_listed_and_what_has_no_error_is_named() {
    let mut rows = vec![
        dot("good", "f32", 10.0, 1e-7),
        dot("sluggish", "f32", 31.0, 2e-7),
        dot("wild", "f32", 12.0, 1.1e-5),
        dot("behind", "f32", 29.0, 2e-7),
        Row { err_b_p99: None, ..dot("without", "f32", 11.0, 1.0) },
    ];
    let with_zero = dot("perfect", "f32", 40.0, 0.0);
    rows.push(with_zero);
    let mut figure = figure(PRECISION);
    figure.file = "apart".into();
    let svg = drawn(&figure, &rows);
    let texts = boxes::texts(&svg);
    let all: String = texts.iter().map(|text| format!("{} ", text.words)).collect();
    assert!(
        all.contains("sluggish f32 (31.0; error 2.00e-7, 3.1 times the time of the front)"),
        "{all}"
    );
    assert!(
        all.contains("wild f32 (12.0; error 1.10e-5, 110 times the error of the front)"),
        "{all}"
    );
    assert!(all.contains("without this error: without"), "{all}");
    assert!(all.contains("errors of 0 stand at the left edge"), "{all}");
    for drawn in ["good", "behind", "perfect"] {
        assert!(texts.iter().any(|text| text.words == drawn), "{drawn}");
    }
    for listed in ["sluggish", "wild", "without"] {
        assert!(!texts.iter().any(|text| text.words == listed), "{listed}");
    }
}

#[test]
fn errors_can_come_from_other_rows_of_the_same_id() {
    let mut rows = vec![dot("a", "f32", 10.0, 1.0), dot("b", "f32", 12.0, 1.0)];
    for (kernel, error) in [("a", 3e-6), ("b", 1e-6)] {
        let stiff = dot(kernel, "f32", 1.0, error);
        let (workload, order) = ("needle".into(), String::new());
        rows.push(Row { workload, order, ns_per_test: None, ..stiff });
    }
    let mut figure = figure(PRECISION);
    figure.file = "joined".into();
    figure.errors_from = BTreeMap::from([("workload".into(), Wanted::Word("needle".into()))]);
    let svg = drawn(&figure, &rows);
    assert!(svg.contains("a f32 (10.0, 3.00e-6), b f32 (12.0, 1.00e-6)"), "{svg:.600}");
    // Two rows of errors for one point are one too many.
    rows.push(rows[2].clone());
    let refused = draw(&figure, &rows, &published()).unwrap_err();
    assert!(matches!(refused, ChartError::Ambiguous { .. }), "{refused}");
    // Without any, there is nothing to draw.
    figure.errors_from = BTreeMap::from([("workload".into(), Wanted::Word("cap".into()))]);
    assert!(drawn(&figure, &rows).contains("Not drawn"));
}

#[test]
fn two_points_of_one_name_are_refused() {
    let rows = [dot("a", "f32", 10.0, 1e-6), dot("a", "f32", 11.0, 1e-6)];
    let refused = draw(&figure(PRECISION), &rows, &published()).unwrap_err();
    assert!(matches!(refused, ChartError::Ambiguous { .. }), "{refused}");
}

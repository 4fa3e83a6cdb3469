//! What is said under figures, and their numbers.

use super::*;
use crate::chart::{Published, numbers};
use crate::report::numbers::{figure_csv, table};
use crate::report::sentence::sentences;

fn said(figure: &Figure, rows: &[Row]) -> Vec<String> {
    sentences(figure, &numbers(figure, rows, &Published::embedded().unwrap()).unwrap())
}

fn csv_of(figure: &Figure, rows: &[Row]) -> Vec<String> {
    let bytes = figure_csv(figure, rows).unwrap();
    String::from_utf8(bytes).unwrap().lines().map(str::to_owned).collect()
}

fn in_order(order: &str, row: Row) -> Row {
    Row { order: order.into(), ..row }
}

#[test]
fn bars_tell_the_best_the_next_and_the_worst_of_each_panel() {
    let rows = [
        timed("a", 3.0),
        timed("b", 2.0),
        timed("c", 8.0),
        in_order("fixed", timed("a", 1.0)),
        in_order("fixed", timed("b", 1.01)),
    ];
    assert_eq!(
        said(&figure(TIMES), &rows),
        [
            "Order reshuffled: b is the fastest (2.00 [1.98, 2.02] ns); a comes next, 50 % slower; \
             c is the slowest, 4.00 times the time.",
            "Order fixed: a is the fastest (1.00 [0.990, 1.01] ns); b comes next, 1.0 % slower, \
             their intervals overlap.",
        ]
    );
}

#[test]
fn more_tests_a_second_are_better() {
    let mut figure = figure(TIMES);
    figure.y = "mtests_per_s".into();
    let speed =
        |kernel: &str, speed: f64| Row { mtests_per_s: Some(speed), ..timed(kernel, 1e3 / speed) };
    let rows = [speed("a", 100.0), speed("b", 300.0)];
    let words = said(&figure, &rows);
    assert!(
        words[0].starts_with("b is the fastest (300 [297, 303] M tests/s); a comes next, 3.00")
    );
    let table = table(&figure, &numbers(&figure, &rows, &Published::embedded().unwrap()).unwrap());
    // The best first; the panel is named where there is one.
    assert_eq!(table.rows[0][1], "b");
    assert_eq!(table.head[0], "order");
}

const LINES: &str = r#"
    file = "lines"
    kind = "lines"
    question = "What does the density do?"
    x = "density"
    y = "ns_per_test"
"#;

fn over_density(kernel: &str, times: &[f64]) -> Vec<Row> {
    let at = |(step, ns): (usize, &f64)| {
        let density = step as f64 / (times.len() - 1) as f64;
        Row { density: Some(density), ..timed(kernel, *ns) }
    };
    times.iter().enumerate().map(at).collect()
}

#[test]
fn lines_tell_where_the_best_changes() {
    let mut rows = over_density("a", &[1.0, 2.0, 4.0]);
    rows.extend(over_density("b", &[2.0, 3.0, 2.0]));
    assert_eq!(
        said(&figure(LINES), &rows),
        ["a is the fastest from density 0 to 0.5 (1.00 [0.990, 1.01] ns at 0; b 2.00 times the \
          time), then b at 1 (2.00 [1.98, 2.02] ns at 1; a 2.00 times the time); a grows to \
          4.00 times from density 0 to 1."]
    );
    assert_eq!(
        said(&figure(LINES), &over_density("a", &[4.0, 3.0, 2.0])),
        ["a falls by 50 % from density 0 to 1: 4.00 [3.96, 4.04] ns and 2.00 [1.98, 2.02] ns."]
    );
}

#[test]
fn counts_are_compared_with_the_published_ones() {
    let mut figure = figure("file = \"c\"\nkind = \"counts\"\nquestion = \"C?\"");
    figure.published = Some(toml::from_str("table = \"table_4_9\"").unwrap());
    let mut row = timed("badouel", 1.0);
    let counts = [8, 11, 13, 3, 4].map(Some);
    [row.ops_add, row.ops_sub, row.ops_mul, row.ops_div, row.ops_condition] = counts;
    assert_eq!(said(&figure, &[row.clone()]), ["All 5 counts are the published ones."]);
    row.ops_div = Some(2);
    assert_eq!(
        said(&figure, &[row.clone()]),
        ["4 of 5 counts are the published ones; badouel has 2 divisions instead of 3."]
    );
    assert!(csv_of(&figure, &[row]).contains(&"badouel,divisions,2,3".to_owned()));
}

#[test]
fn errors_against_times_name_the_steps() {
    let figure = figure(
        "file = \"p\"\nkind = \"precision\"\nquestion = \"P?\"\nx = \"err_b_p99\"\ny = \"ns_per_test\"",
    );
    let dot =
        |kernel: &str, ns: f64, error: f64| Row { err_b_p99: Some(error), ..timed(kernel, ns) };
    let rows = [dot("a", 1.0, 1e-6), dot("b", 2.0, 1e-7), dot("c", 2.5, 1e-6)];
    assert_eq!(
        said(&figure, &rows),
        ["F32: from the fastest to the most exact, take a (1.00 ns, error 1.00e-6), then b (2.00 \
          ns, error 1.00e-7); 1 form is off these steps."]
    );
    let csv = csv_of(&figure, &rows);
    assert_eq!(csv[3], ",c,f32,0.000001,0.000001,0.000001,2.5,2.475,2.525,dominated");
}

#[test]
fn a_heat_map_tells_who_never_fails() {
    let figure = figure(
        "file = \"h\"\nkind = \"heat\"\nquestion = \"H?\"\nx = \"family\"\ny = \"knee_share\"",
    );
    let field = |kernel: &str, family: &str, share: f64| Row {
        family: family.into(),
        knee_share: Some(share),
        ..timed(kernel, 1.0)
    };
    let rows = [
        field("a", "cap", 1.0),
        field("a", "far", 1.0),
        field("b", "cap", 0.2),
        field("b", "far", 1.0),
    ];
    assert_eq!(
        said(&figure, &rows),
        [
            "1 of 2 never fail: a; b fails in the most, 1 of 2 families; most kernels, 1 of 2, fail in cap."
        ]
    );
}

#[test]
fn whoever_fails_as_rarely_or_as_often_is_named_as_well() {
    let figure = figure(
        "file = \"h\"\nkind = \"heat\"\nquestion = \"H?\"\nx = \"family\"\ny = \"knee_share\"",
    );
    let mut rows = Vec::new();
    for (kernel, shares) in [("a", [0.5, 1.0]), ("b", [1.0, 0.5]), ("c", [0.5, 0.5])] {
        rows.extend(["cap", "far"].iter().zip(shares).map(|(family, share)| Row {
            family: (*family).into(),
            knee_share: Some(share),
            ..timed(kernel, 1.0)
        }));
    }
    assert_eq!(
        said(&figure, &rows),
        [
            "No kernel holds everywhere: a and b fail in the fewest, 1 of 2 families; c fails in the \
             most, 2 of 2 families; most kernels, 2 of 3, fail in far."
        ]
    );
}

#[test]
fn published_figures_that_are_ours_are_not_said_to_be_far_off() {
    let mut figure = figure(LINES);
    figure.y = "seconds".into();
    figure.published = Some(toml::from_str("table = \"table_4_2\"").unwrap());
    let words = |seconds: f64| {
        let row = Row { density: Some(0.0), seconds: Some(seconds), ..timed("moller", 2.0) };
        said(&figure, &[row]).pop().unwrap()
    };
    let row = Row { density: Some(0.0), seconds: Some(1.0), ..timed("moller", 2.0) };
    let lines = csv_of(&figure, &[row]);
    let is_theirs =
        |line: &&String| line.starts_with(",moller,0,seconds,") && line.ends_with("published");
    let theirs = lines.iter().find(is_theirs).unwrap();
    let theirs: f64 = theirs.split(',').nth(4).unwrap().parse().unwrap();
    let same = words(1.0001 * theirs);
    assert!(
        same.starts_with("The published figures are ours: the furthest, that of moller"),
        "{same}"
    );
    assert!(words(1.1 * theirs).starts_with("The published figure that is furthest from ours"));
}

#[test]
fn numbers_are_written_unrounded_with_what_was_published() {
    let mut figure = figure(LINES);
    figure.y = "seconds".into();
    figure.published = Some(toml::from_str("table = \"table_4_2\"").unwrap());
    let row = Row { density: Some(0.0), seconds: Some(0.1 + 0.2), ..timed("moller", 2.0) };
    let csv = csv_of(&figure, &[row]);
    assert_eq!(csv[0], "panel,series,x,column,value,low,high,kind");
    assert!(csv[1].starts_with(",moller,0,seconds,0.30000000000000004,"), "{}", csv[1]);
    assert!(
        csv.iter()
            .any(|line| line.starts_with(",badouel,1,seconds,") && line.ends_with(",,published"))
    );
}

#[test]
fn no_link_leads_to_what_a_copy_may_lack() {
    let stiff = Row { record: "knee".into(), ns_per_test: None, ..timed("a", 1.0) };
    for (rows, has_link) in [(vec![timed("a", 1.0)], true), (vec![stiff], false)] {
        let results = results(rows, &[TIMES]);
        let pages = [html(&results, &[]), markdown(&results, &[])];
        let links = ["href=\"first/rows.csv\"", "(first/rows.csv)"];
        for (page, link) in pages.iter().zip(links) {
            assert_eq!(page.contains(link), has_link, "{link}");
            assert!(has_link || page.contains("the same on every machine"));
        }
    }
}

#[test]
fn a_prediction_is_held_against_what_was_measured_and_does_not_compete() {
    let mut figure = figure(LINES);
    figure.series =
        toml::from_str::<Figure>(&LINES.replace("x =", "series = \"form\"\nx =")).unwrap().series;
    let of = |form: &str, times: &[f64]| -> Vec<Row> {
        let rows = over_density("moller1", times).into_iter();
        rows.map(|row| Row { form: form.into(), ..row }).collect()
    };
    let rows = [of("measured", &[2.0, 3.0, 8.0]), of("predicted", &[4.0, 3.0, 4.0])].concat();
    assert_eq!(
        said(&figure, &rows),
        ["measured is 0.500 times predicted at density 0 and 2.00 times at 1, everywhere else \
          between these."]
    );
    // What is left of a prediction lies around 0.
    figure.reference = Some(0.0);
    assert_eq!(
        said(&figure, &of("residual", &[-1.0, 0.5, 7.0])),
        ["residual lies from -1.00 ns (at density 0) to 7.00 ns (at 1)."]
    );
}

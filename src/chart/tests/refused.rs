//! What cannot be drawn: configuration errors are named, missing data make a placeholder.

use super::*;

const LEAST: &str = "file = \"f\"\nquestion = \"Why?\"\n";

fn with(rest: &str) -> Figure {
    figure(&format!("{LEAST}{rest}"))
}

#[test]
fn without_rows_a_placeholder_says_why() {
    for kind in ["lines", "bars", "shares", "counts", "precision"] {
        let axes = if kind == "counts" { "" } else { "x = \"density\"\ny = \"seconds\"\n" };
        let mut figure = with(&format!("kind = \"{kind}\"\n{axes}"));
        figure.file = format!("placeholder-{kind}");
        assert!(drawn(&figure, &[]).contains("Not drawn: there are no rows."));
        // No value at all, and values that are none.
        let nan = Some(f64::NAN);
        let empty = Row { seconds: nan, density: Some(0.5), ..row("b-4.1", "wald") };
        assert!(drawn(&figure, &[empty]).contains("Not drawn: no row "));
        figure.filter = BTreeMap::from([("kernel".into(), Wanted::Word("none".into()))]);
        let svg = drawn(&figure, &[row("b-4.1", "wald")]);
        assert!(svg.contains("no row (of 1) passes the figure&apos;s filter"));
    }
}

#[test]
fn one_row_and_equal_values_are_drawn() {
    for (kind, scales) in
        [("lines", &["linear", "log"][..]), ("bars", &["linear", "log"]), ("shares", &["linear"])]
    {
        for scale in scales {
            for ns in [0.0, 1e-300, 1.0, 1e300] {
                let text = format!(
                    "kind = \"{kind}\"\nx = \"density\"\ny = \"ns_per_test\"\nscale = \"{scale}\""
                );
                let one = |kernel| timed(Row { density: Some(0.5), ..row("one", kernel) }, ns);
                drawn(&with(&text), &[one("wald"), one("keidy")]);
            }
        }
    }
}

#[test]
fn what_there_is_nothing_to_divide_by_is_said() {
    let figure =
        with("kind = \"lines\"\nx = \"density\"\ny = \"seconds\"\nnormalise_to = \"wald\"");
    let row = timed(Row { density: Some(0.5), ..row("b-4.1", "keidy") }, 1.0);
    assert!(drawn(&figure, &[row]).contains("there is no value of wald to divide by"));
}

#[test]
fn wrong_values_are_named_with_what_is_allowed() {
    let cases = [
        (
            "kind = \"counts\"\npanels = \"order\"",
            "key 'panels': 'kind counts'",
            "[lines, bars, precision]",
        ),
        ("kind = \"bars\"\nx = \"kernel\"\ny = \"speed\"", "key 'y': 'speed'", "mtests_per_s"),
        ("kind = \"bars\"\nx = \"kernel\"\ny = \"kernel\"", "key 'y': 'kernel'", "ns_per_test"),
        ("kind = \"lines\"\nx = \"kernel\"\ny = \"seconds\"", "key 'x': 'kernel'", "density"),
        (
            "kind = \"bars\"\nx = \"kernel\"\ny = \"seconds\"\npanels = \"odrer\"",
            "key 'panels': 'odrer'",
            "order",
        ),
        ("kind = \"counts\"\nfilter = { kernal = \"wald\" }", "key 'filter': 'kernal'", "kernel"),
        ("kind = \"counts\"\nseries = [\"kernel\", \"x\"]", "key 'series': 'x'", "division"),
        (
            "kind = \"counts\"\npublished = { table = \"table_9\" }",
            "'table_9'",
            "table_4_1, table_4_2",
        ),
    ];
    for (text, named, allowed) in cases {
        let message = draw(&with(text), &[], &published()).unwrap_err().to_string();
        assert!(message.contains(named) && message.contains(allowed), "{message}");
    }
    let mut outside = with("kind = \"counts\"");
    outside.file = "../escape".into();
    assert!(matches!(
        draw(&outside, &[], &published()),
        Err(ChartError::Wrong { key: "file", .. })
    ));
}

#[test]
fn unknown_keys_and_words_are_refused_when_read() {
    for (text, allowed) in [
        ("kind = \"pie\"", "`shares`"),
        ("kind = \"bars\"\ncolour = 1", "`question`"),
        ("kind = \"bars\"\nscale = \"ln\"", "`linear`"),
    ] {
        let error = toml::from_str::<Figure>(&format!("{LEAST}{text}")).unwrap_err().to_string();
        assert!(error.contains(allowed), "{error}");
    }
}

#[test]
fn rows_for_one_place_are_refused_and_their_difference_named() {
    let figure = with("kind = \"lines\"\nx = \"density\"\ny = \"seconds\"");
    let one = |level: &str| {
        timed(Row { density: Some(0.5), level: level.into(), ..row("b-4.1", "wald") }, 1.0)
    };
    let message = draw(&figure, &[one("sse2"), one("avx2")], &published()).unwrap_err().to_string();
    assert!(message.contains("wald, 0.5; they differ in level"), "{message}");
}

#[test]
fn labels_are_pushed_apart_and_stay_inside() {
    let heights = labels::pushed_apart(&[50.0, 51.0, 49.0, 200.0, 300.0], 16.0, 0.0, 300.0);
    assert_eq!(heights, [50.0, 66.0, 34.0, 200.0, 300.0]);
    let crowded = labels::pushed_apart(&[299.0, 298.0, 2.0, 1.0, 0.0], 16.0, 0.0, 300.0);
    assert_eq!(crowded, [300.0, 284.0, 32.0, 16.0, 0.0]);
}

#[test]
fn published_tables_are_read() {
    let published = published();
    let point = |table, measure, series: &str, x: &str| {
        let points = published.points(table, measure);
        points.into_iter().find(|point| point.series == series && point.x == x).map(|point| point.y)
    };
    assert_eq!(point("table_4_1", Measure::Seconds, "moller3", "0.75"), Some(37.236));
    assert_eq!(point("table_4_2", Measure::Seconds, "chirkov", "0"), Some(26.016));
    assert_eq!(point("table_4_3", Measure::Seconds, "badouel", "pc4"), Some(30.422));
    assert_eq!(point("table_4_10", Measure::Seconds, "moller", "1"), Some(40.641));
    assert_eq!(point("table_4_7", Measure::Seconds, "badouel", "1"), Some(5.516));
    assert_eq!(point("table_4_5", Measure::Share, "moller", "0"), Some(0.12072));
    assert_eq!(point("table_4_9", Measure::Count, "chirkov", "mul"), Some(29.0));
    assert_eq!(published.meaning("table_4_5", "0"), Some("hit"));
}

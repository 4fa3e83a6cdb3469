//! Which rows a series takes, and what is said where there are none.

use crate::claims::{Ledger, Verdict, judge};
use crate::table::Row;

/// A paper with one claim: the mean of a series is below 2.
fn paper(series: &str, measure: &str) -> String {
    format!(
        "place = 1\n[[claim]]\nid = \"X\"\nsource = \"nobody\"\nstatement = \"Small.\"\n\
         series.x = {series}\n[[claim.part]]\nwhat = \"x\"\nmeasure = '{measure}'\nbelow = 2.0\n"
    )
}

/// Verdict, figure and details of that claim.
fn judged(series: &str, measure: &str, rows: &[Row]) -> (Verdict, Option<f64>, String) {
    let paper = paper(series, measure);
    let ledger =
        Ledger::from_files(&[("x.toml", &paper)]).unwrap_or_else(|error| panic!("{error}"));
    let rows: Vec<&Row> = rows.iter().collect();
    let found = judge(&ledger, &rows).remove(0);
    (found.verdict, found.measured, found.details)
}

fn row(kernel: &str, seed: u64, ops: u64) -> Row {
    Row {
        experiment: "e".into(),
        kernel: kernel.into(),
        seed: Some(seed),
        status: "ok".into(),
        ops_add: Some(ops),
        ..Row::default()
    }
}

const BY_KERNEL: &str = r#"{ experiment = "e", value = "ops_add", along = "kernel" }"#;

#[test]
fn filters_and_status_and_empty_cells_leave_rows_out() {
    let series =
        r#"{ experiment = "e", filter = { level = "sse2" }, value = "ops_add", along = "kernel" }"#;
    let mut rows = vec![row("a", 1, 1), row("b", 1, 9), row("c", 1, 9), row("d", 1, 9)];
    rows[0].level = "sse2".into();
    rows[1].level = "avx2".into();
    rows[2].level = "sse2".into();
    rows[2].status = "wrong-result".into();
    rows[3].level = "sse2".into();
    rows[3].ops_add = None;
    assert_eq!(judged(series, "count(x)", &rows).1, Some(1.0));
    let wrong_too = series
        .replace(" }", ", wrong_too = true }")
        .replace("\"sse2\", wrong_too = true }", "\"sse2\" }");
    assert_eq!(judged(&wrong_too, "count(x)", &rows).1, Some(2.0));
}

#[test]
fn rows_of_one_key_are_put_together_over_a_column_only() {
    let rows = [row("a", 1, 1), row("a", 2, 5), row("a", 3, 2)];
    let (verdict, _, details) = judged(BY_KERNEL, "mean(x)", &rows);
    assert_eq!(verdict, Verdict::Undecided);
    assert!(details.contains("several rows of e are for a: seed"), "{details}");
    let over = BY_KERNEL.replace(" }", ", over = \"seed\" }");
    let (_, median, details) = judged(&over, "mean(x)", &rows);
    assert_eq!(median, Some(2.0));
    assert!(details.contains("2 [1, 5] may or may not be below 2"), "{details}");
    let twice = [row("a", 1, 1), row("a", 1, 5)];
    assert!(judged(&over, "mean(x)", &twice).2.contains("several rows of e are for a 1"));
}

#[test]
fn keys_without_a_row_can_have_a_figure() {
    let series = r#"{ experiment = "e", value = "ops_add", along = "seed", keys = ["1", "2"], otherwise = 0.0 }"#;
    assert_eq!(judged(series, "min(x)", &[row("a", 1, 1)]).1, Some(0.0));
    // But not if there is no row at all.
    assert_eq!(judged(series, "min(x)", &[]).1, None);
}

#[test]
fn numeric_keys_are_in_ascending_order() {
    let series = r#"{ experiment = "e", value = "ops_add", along = "seed" }"#;
    let rows = [row("a", 10, 3), row("a", 9, 1), row("a", 100, 7)];
    assert_eq!(judged(series, "first(x)", &rows).1, Some(1.0));
    assert_eq!(judged(series, "last(x)", &rows).1, Some(7.0));
    // 9 -> 1, 10 -> 3: the slope of the first two is 2, at() leaves nothing else.
    assert_eq!(judged(series, "at(x, 10) - at(x, 9)", &rows).1, Some(2.0));
}

#[test]
fn what_is_missing_is_named() {
    let rows = [row("a", 1, 1)];
    let says = |series: &str, measure: &str, rows: &[Row]| judged(series, measure, rows).2;
    assert!(says(BY_KERNEL, "mean(x)", &[]).contains("run `ray_test run configs/e.toml`"));
    assert!(says(BY_KERNEL, "at(x, \"b\")", &rows).contains("there is no figure for b"));
    assert!(says(BY_KERNEL, "x + 1", &rows).contains("1 figures where one is wanted"));
    assert!(
        says(BY_KERNEL, "mean(like(x, \"z\"))", &rows).contains("no kernel with 'z' in its name")
    );
    assert!(says(BY_KERNEL, "slope(x)", &rows).contains("keys along kernel are no numbers"));
    assert!(says(BY_KERNEL, "1 / (at(x, \"a\") - 1)", &rows).contains("no value"));
    let skipped = Row { status: "skipped".into(), reason: "no avx512".into(), ..row("a", 1, 1) };
    assert!(says(BY_KERNEL, "mean(x)", &[skipped]).contains("no ops_add in e: no avx512"));
    let stability = BY_KERNEL.replace("\"e\"", "\"stability\"");
    assert!(says(&stability, "mean(x)", &[]).contains("run `ray_test stability`"));
    let timed = BY_KERNEL.replace("ops_add", "cycles_per_test");
    let no_interval = Row { cycles_per_test: Some(1.0), ..row("a", 1, 1) };
    assert!(says(&timed, "mean(x)", &[no_interval]).contains("has no interval"));
}

#[test]
fn keys_of_both_sides_must_be_the_same() {
    let paper = paper(BY_KERNEL, "mean(x / y)").replace(
        "[[claim.part]]",
        "series.y = { experiment = \"f\", value = \"ops_add\", along = \"kernel\" }\n[[claim.part]]",
    );
    let ledger =
        Ledger::from_files(&[("x.toml", &paper)]).unwrap_or_else(|error| panic!("{error}"));
    let other = Row { experiment: "f".into(), ..row("b", 1, 1) };
    let rows = [row("a", 1, 1), other];
    let rows: Vec<&Row> = rows.iter().collect();
    let found = judge(&ledger, &rows).remove(0);
    assert!(found.details.contains("only one side has figures for a, b"), "{}", found.details);
}

#[test]
fn choosing_among_noisy_figures_widens_their_intervals() {
    let timed = |kernel: &str| Row {
        cycles_per_test: Some(1.0),
        cycles_low: Some(0.9),
        cycles_high: Some(1.1),
        ..row(kernel, 1, 1)
    };
    let rows: Vec<Row> = ["a", "b", "c", "d"].map(timed).to_vec();
    let series = BY_KERNEL.replace("ops_add", "cycles_per_test");
    let high = |measure: &str| {
        let paper = paper(&series, measure);
        let ledger =
            Ledger::from_files(&[("x.toml", &paper)]).unwrap_or_else(|error| panic!("{error}"));
        let rows: Vec<&Row> = rows.iter().collect();
        judge(&ledger, &rows).remove(0).high.expect("a figure")
    };
    assert!((high("mean(x)") - 1.1).abs() < 1e-12);
    // The quantile of 1 - 0.025 / 4 is 2.497705474, that of 0.975 1.959963985.
    let times: f64 = 2.497_705_474 / 1.959_963_985;
    assert!((high("max(x)") - 1.1f64.powf(times)).abs() < 1e-8, "{}", high("max(x)"));
}

#[test]
fn the_noise_floor_widens_where_codes_are_compared() {
    let timed = |kernel: &str, cycles: f64, floor: f64| Row {
        cycles_per_test: Some(cycles),
        cycles_low: Some(cycles),
        cycles_high: Some(cycles),
        noise_floor: Some(floor),
        ..row(kernel, 1, 1)
    };
    let rows = [timed("a", 3.0, 0.25), timed("b", 2.0, 0.5)];
    let series = BY_KERNEL.replace("ops_add", "cycles_per_test");
    let paper =
        paper(&series, "at(x, \"a\") / at(x, \"b\")").replace("below", "noise = true\nbelow");
    let ledger =
        Ledger::from_files(&[("x.toml", &paper)]).unwrap_or_else(|error| panic!("{error}"));
    let rows: Vec<&Row> = rows.iter().collect();
    let found = judge(&ledger, &rows).remove(0);
    assert_eq!((found.low, found.high), (Some(0.75), Some(2.25)));
}

//! One claim under several conditions, and on several machines.

use crate::claims::{Finding, Ledger, Verdict, headline, judge, to_csv};
use crate::table::Row;

const PAPER: &str = r#"
place = 1
conditions = ["order"]
decides = ["literal"]

[[claim]]
id = "X-1"
source = "nobody"
statement = "a is slower than b."
explains.reshuffled = "Because of this."
series.time = { experiment = "x", filter = { kernel = ["a", "b"] }, value = "cycles_per_test", along = "kernel" }
series.count = { experiment = "counts", value = "ops_mul", along = "kernel" }
[[claim.part]]
what = "a / b"
measure = 'at(time, "a") / at(time, "b")'
above = 1.0
published = 1.25
[[claim.part]]
what = "more in a"
measure = 'at(count, "a") - at(count, "b")'
above = 0.0

[[claim]]
id = "X-2"
source = "nobody"
statement = "a / b depends on the machine."
machines = 2
series.time = { experiment = "x", value = "cycles_per_test", along = ["kernel", "machine"] }
[[claim.part]]
what = "largest a / b over the smallest"
measure = 'spread(at(time, "a") / at(time, "b"))'
above = 1.1
"#;

fn ledger() -> Ledger {
    Ledger::from_files(&[("x.toml", PAPER)]).unwrap_or_else(|error| panic!("{error}"))
}

/// A time with an interval of a per cent to both sides.
fn time(kernel: &str, order: &str, machine: &str, cycles: f64) -> Row {
    Row {
        experiment: "x".into(),
        kernel: kernel.into(),
        order: order.into(),
        machine: machine.into(),
        status: "ok".into(),
        cycles_per_test: Some(cycles),
        cycles_low: Some(cycles * 0.99),
        cycles_high: Some(cycles * 1.01),
        ..Row::default()
    }
}

fn count(kernel: &str, machine: &str, ops: u64) -> Row {
    Row {
        experiment: "counts".into(),
        kernel: kernel.into(),
        machine: machine.into(),
        status: "ok".into(),
        ops_mul: Some(ops),
        ..Row::default()
    }
}

fn on(machine: &str, ratios: [(&str, f64); 3]) -> Vec<Row> {
    let times = |(order, ratio): (&str, f64)| {
        [time("a", order, machine, ratio * 10.0), time("b", order, machine, 10.0)]
    };
    let mut rows: Vec<Row> = ratios.into_iter().flat_map(times).collect();
    rows.extend([count("a", machine, 9), count("b", machine, 5)]);
    rows
}

fn of(id: &str, rows: &[Row]) -> Vec<Finding> {
    let rows: Vec<&Row> = rows.iter().collect();
    judge(&ledger(), &rows).into_iter().filter(|found| found.id == id).collect()
}

#[test]
fn orders_stand_in_their_order_and_the_opposite_is_explained() {
    let rows = on("", [("reshuffled", 0.8), ("fixed", 1.0), ("literal", 1.2)]);
    let found = of("X-1", &rows);
    let words: Vec<(&str, &str, bool)> = found
        .iter()
        .map(|found| (found.condition.as_str(), found.verdict.word(), found.decides))
        .collect();
    let wanted = [
        ("literal", "reproduced", true),
        ("fixed", "undecided", false),
        ("reshuffled", "not-reproduced", false),
    ];
    assert_eq!(words, wanted);
    let explained: Vec<bool> =
        found.iter().map(|found| found.details.contains("Because of this.")).collect();
    assert_eq!(explained, [false, false, true]);
    let all: Vec<&Finding> = found.iter().collect();
    let wanted = "reproduced (literal); undecided (fixed); contradicted (reshuffled)";
    assert_eq!(headline(&all), wanted);
}

#[test]
fn rows_that_no_series_asks_for_make_no_condition() {
    let mut rows = on("", [("literal", 1.2), ("fixed", 1.2), ("reshuffled", 1.2)]);
    rows.push(time("c", "sorted", "", 10.0));
    let found = of("X-1", &rows);
    let words: Vec<&str> = found.iter().map(|found| found.condition.as_str()).collect();
    assert_eq!(words, ["literal", "fixed", "reshuffled"]);
    rows.push(time("a", "sorted", "", 10.0));
    assert_eq!(of("X-1", &rows).len(), 4);
}

#[test]
fn a_finding_shows_the_part_that_is_closest_to_failing() {
    let found = of("X-1", &on("", [("literal", 1.2), ("fixed", 1.2), ("reshuffled", 1.2)]));
    let found = &found[0];
    // 1.2 is 0.2 above its bound, 4 is 4 above 0.
    assert!(found.measured.is_some_and(|ratio| (ratio - 1.2).abs() < 1e-12));
    assert_eq!(found.published, "1.25");
    // One noisy part: no correction. The ends are those of the worst case.
    assert!(found.low.is_some_and(|low| (low - 11.88 / 10.1).abs() < 1e-9), "{found:?}");
    assert!(found.details.starts_with("a / b: 1.2 [1.176, 1.224] is above 1 (published 1.25); "));
    assert!(found.details.ends_with("more in a: 4 is above 0"), "{}", found.details);
}

#[test]
fn machines_are_judged_one_by_one() {
    let mut rows = on("M1", [("literal", 1.2), ("fixed", 1.2), ("reshuffled", 1.2)]);
    rows.extend(on("M2", [("literal", 0.8), ("fixed", 1.2), ("reshuffled", 1.2)]));
    let found = of("X-1", &rows);
    let words: Vec<(&str, &str)> =
        found.iter().map(|found| (found.condition.as_str(), found.verdict.word())).collect();
    assert_eq!(words[0], ("literal, M1", "reproduced"));
    assert_eq!(words[1], ("literal, M2", "not-reproduced"));
    assert_eq!(words.len(), 6);
}

#[test]
fn machines_are_compared_where_there_are_two() {
    let one = on("M1", [("literal", 1.2), ("fixed", 1.2), ("reshuffled", 1.2)]);
    let found = &of("X-2", &one)[0];
    assert_eq!(found.verdict, Verdict::Undecided);
    assert!(
        found.details.contains("needs results of 2 or more machines: `ray_test report DIR1 DIR2`")
    );
    let mut two = one;
    two.extend(on("M2", [("literal", 0.8), ("fixed", 1.2), ("reshuffled", 1.2)]));
    let found = of("X-2", &two);
    let words: Vec<(&str, Verdict)> =
        found.iter().map(|found| (found.condition.as_str(), found.verdict)).collect();
    assert_eq!(words[0], ("literal", Verdict::Reproduced));
    assert_eq!(words[1], ("fixed", Verdict::NotReproduced));
}

#[test]
fn csv_has_a_row_per_claim_and_condition() {
    let rows = on("", [("literal", 1.2), ("fixed", 1.2), ("reshuffled", 1.2)]);
    let rows: Vec<&Row> = rows.iter().collect();
    let findings = judge(&ledger(), &rows);
    let text = String::from_utf8(to_csv(&findings)).expect("UTF-8");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 1 + findings.len());
    assert_eq!(
        lines[0],
        "id,source,statement,published,measured,low,high,condition,verdict,details"
    );
    assert!(lines[1].starts_with("X-1,nobody,a is slower than b.,1.25,1.2"), "{}", lines[1]);
    // No figure: empty cells.
    assert!(
        lines[4].starts_with("X-2,nobody,a / b depends on the machine.,,,,,literal,undecided,")
    );
}

#[test]
fn an_undecided_claim_says_what_would_decide_it() {
    let found = of("X-1", &on("", [("literal", 1.0), ("fixed", 1.2), ("reshuffled", 1.2)]));
    let wanted = "what would decide it: more rounds (`--profile thorough`), or a quieter machine";
    assert!(found[0].details.ends_with(wanted), "{}", found[0].details);
    assert!(!found[1].details.contains("what would decide it"));
    // Without rows the part says what to run, and more rounds of nothing help nobody.
    let found = of("X-1", &[]);
    assert!(found[0].details.contains("run `ray_test run configs/x.toml`"));
    assert!(!found[0].details.contains("more rounds"));
}

#[test]
fn an_exact_part_that_fails_is_shown() {
    // 4 less than 0; the ratio holds.
    let mut rows = on("", [("literal", 1.2), ("fixed", 1.2), ("reshuffled", 1.2)]);
    rows.retain(|row| row.experiment != "counts");
    rows.extend([count("a", "", 5), count("b", "", 9)]);
    let found = of("X-1", &rows);
    assert_eq!((found[0].measured, found[0].verdict), (Some(-4.0), Verdict::NotReproduced));
}

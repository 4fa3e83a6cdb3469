//! Every claim of the ledger changes its verdict with the rows.

use super::cases::{self, Case};
use super::made;
use crate::claims::judge::of_claim;
use crate::claims::{Claim, Finding, Ledger, Verdict, judge};
use crate::table::{Row, has_interval};

fn ledger() -> Ledger {
    Ledger::embedded().unwrap_or_else(|error| panic!("{error}"))
}

/// The one finding that decides a claim, by figures of the case and of a change.
fn decided(case: &Case, claim: &Claim, with_change: bool, noise: f64) -> Finding {
    let order = claim.decides.as_deref().and_then(<[String]>::first).map_or("", String::as_str);
    let change = if with_change { case.change } else { &[] };
    let cells = [case.holds, change].concat();
    finding(claim, &made::rows(claim, &cells, order, noise))
}

fn finding(claim: &Claim, rows: &[Row]) -> Finding {
    let rows: Vec<&Row> = rows.iter().collect();
    let mut own = of_claim(claim, &rows).into_iter().filter(|found| found.decides);
    let found = own.next().unwrap_or_else(|| panic!("{} has no finding", claim.id));
    assert!(own.next().is_none(), "{} has several", claim.id);
    found
}

fn cases() -> Vec<(&'static Case, Claim)> {
    let ledger = ledger();
    let of = |case: &'static Case| {
        let claim = ledger.find(case.id).unwrap_or_else(|| panic!("no claim {}", case.id));
        (case, claim.clone())
    };
    cases::cases().map(of).collect()
}

#[test]
fn every_claim_that_can_be_tested_has_its_case() {
    let ledger = ledger();
    let testable = ledger.claims().iter().filter(|claim| claim.is_testable());
    let ids: Vec<&str> = testable.map(|claim| claim.id.as_str()).collect();
    let cases: Vec<&str> = cases::cases().map(|case| case.id).collect();
    assert_eq!(ids, cases);
}

#[test]
fn figures_with_which_it_holds_and_a_change_that_undoes_it() {
    for (case, claim) in cases() {
        let found = decided(case, &claim, false, 0.001);
        assert_eq!(found.verdict, case.first, "{}: {}", case.id, found.details);
        let found = decided(case, &claim, true, 0.001);
        assert_eq!(found.verdict, case.changed, "{}: {}", case.id, found.details);
    }
}

#[test]
fn figures_that_are_too_noisy_decide_nothing() {
    let mut noisy = 0;
    for (case, claim) in cases() {
        let mut series = claim.series.values();
        if !series.any(|series| has_interval(&series.value) || series.over.is_some()) {
            continue;
        }
        noisy += 1;
        let found = decided(case, &claim, false, 0.99);
        assert_eq!(found.verdict, Verdict::Undecided, "{}: {}", case.id, found.details);
    }
    // All but those that count.
    assert!(noisy > cases::cases().count() / 2, "{noisy}");
}

#[test]
fn without_rows_a_claim_says_what_to_run() {
    for (case, claim) in cases() {
        let found = finding(&claim, &[]);
        assert_eq!(found.verdict, Verdict::Undecided, "{}", case.id);
        assert!(found.details.contains("run `ray_test "), "{}: {}", case.id, found.details);
        assert_eq!((found.measured, found.low, found.high), (None, None, None), "{}", case.id);
    }
}

#[test]
fn a_claim_without_an_experiment_says_why() {
    let ledger = ledger();
    let all = judge(&ledger, &[]);
    let untestable: Vec<&Finding> =
        all.iter().filter(|found| found.verdict == Verdict::NotTestable).collect();
    assert!(!untestable.is_empty());
    for found in untestable {
        assert!(found.details.len() > 40 && found.condition.is_empty(), "{}", found.id);
    }
}

#[test]
fn findings_are_in_the_order_of_the_ledger_and_none_is_left_out() {
    let ledger = ledger();
    let mut ids: Vec<String> = judge(&ledger, &[]).into_iter().map(|found| found.id).collect();
    ids.dedup();
    let wanted: Vec<&str> = ledger.claims().iter().map(|claim| claim.id.as_str()).collect();
    assert_eq!(ids, wanted);
}

/// Printed figures stand in the ledger and, for the charts, in the tables of the thesis.
#[test]
fn printed_figures_are_those_of_the_tables() {
    use crate::chart::{Measure, Published};
    let published = Published::embedded().expect("the tables can be read");
    let ledger = ledger();
    for (id, series, table, measure, unit) in [
        ("B-4.5", "printed", "table_4_5", Measure::Share, 1e-6),
        ("B-4.5t", "printed", "table_4_5", Measure::Seconds, 1.0),
        ("B-4.7", "printed", "table_4_7", Measure::Share, 1e-6),
    ] {
        let claim = ledger.find(id).expect("a claim");
        let ours = &claim.series[series].values;
        let theirs = published.points(table, measure);
        assert!(!theirs.is_empty(), "{id}");
        for point in theirs {
            let Some(own) = ours.get(&point.x) else {
                assert_eq!((id, point.x.as_str()), ("B-4.5t", "0"), "{id}");
                continue;
            };
            // Shares are of the sum of the counts, which is a million: the division rounds once.
            assert!((own * unit - point.y).abs() <= f64::EPSILON, "{id} {}", point.x);
        }
    }
    let counts = published.points("table_4_9", Measure::Count);
    let claim = ledger.find("B-4.9").expect("a claim");
    for point in &counts {
        let kernel = match point.series.as_str() {
            "moller" => "moller1",
            "chirkov" => "chirkov-line",
            other => other,
        };
        let own = claim.series[&format!("their_{}", point.x)].values[kernel];
        assert_eq!(own, point.y, "{kernel} {}", point.x);
    }
    assert_eq!(counts.len(), 15);
}

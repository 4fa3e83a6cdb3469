//! The report of invented results: what it says, and that nothing makes it fail.

use super::*;
use crate::chart::Figure;
use crate::claims::Verdict;
use crate::recommend::KnownVariant;
use crate::results::{About, Chapter, Source};
use crate::table::Row;
use serde_json::json;

mod answers;
mod degenerate;
mod figures;
mod machines;
mod verdicts;

const TIMES: &str = r#"
    file = "times"
    kind = "bars"
    question = "Which kernel is the fastest?"
    x = "kernel"
    y = "ns_per_test"
    panels = "order"
"#;

fn figure(text: &str) -> Figure {
    toml::from_str(text).unwrap()
}

/// A time of a single ray in the order `reshuffled`; the reference takes 2 ns.
fn timed(kernel: &str, ns: f64) -> Row {
    Row {
        experiment: "first".into(),
        id: format!("{kernel}/f32/single/sse2/early/last/plain/tuv"),
        kernel: kernel.into(),
        precision: "f32".into(),
        drive: "single".into(),
        rounding: "plain".into(),
        stored: "vertices".into(),
        output: "tuv".into(),
        workload: "nearest-random".into(),
        order: "reshuffled".into(),
        status: "ok".into(),
        ns_per_test: Some(ns),
        ns_low: Some(0.99 * ns),
        ns_high: Some(1.01 * ns),
        ratio_to_reference: Some(ns / 2.0),
        ratio_low: Some(0.99 * ns / 2.0),
        ratio_high: Some(1.01 * ns / 2.0),
        rounds: Some(90),
        dirty_rounds: Some(10),
        noise_floor: Some(0.02),
        ..Row::default()
    }
}

fn chapter(rows: Vec<Row>, figures: &[&str]) -> Chapter {
    let about = About {
        id: "first".into(),
        title: "First experiment".into(),
        question: "Is <this> & \"that\" shown as it is?".into(),
        why: "Because\nit is so.\n\nAnd so.".into(),
        config: "configs/first.toml".into(),
        command: "ray_test run configs/first.toml".into(),
        claims: vec!["B-1".into()],
        figures: figures.iter().map(|text| figure(text)).collect(),
        ..About::default()
    };
    Chapter { about, rows, complete: true, workload_hash: String::new() }
}

fn source(label: &str) -> Source {
    let environment = json!({
        "machine": { "processor": label },
        "build": { "version": "9.8.7", "commit": "c0ffee" },
        "date": "2026-01-02T03:04:05Z",
    });
    Source { label: label.into(), folders: vec!["results/one".into()], environment }
}

fn results(rows: Vec<Row>, figures: &[&str]) -> Results {
    Results {
        sources: vec![source("Z80")],
        chapters: vec![chapter(rows, figures)],
        ..Results::default()
    }
}

fn finding(id: &str, condition: &str, verdict: Verdict, decides: bool) -> Finding {
    Finding {
        id: id.into(),
        source: "thesis B, table 1".into(),
        statement: "A is faster than B.".into(),
        published: "1.5".into(),
        measured: Some(1.25),
        low: Some(1.2),
        high: Some(1.3),
        condition: condition.into(),
        verdict,
        details: "A/B 1.25".into(),
        decides,
    }
}

/// All variants of the rows: not watertight, without limits, and not of this processor.
fn known(results: &Results) -> Vec<KnownVariant> {
    let variant = |row: &Row| KnownVariant { id: row.id.clone(), ..KnownVariant::default() };
    results.rows().map(variant).collect()
}

fn report(results: &Results, findings: &[Finding]) -> Report {
    Report::new(results, findings, &known(results)).expect("nothing keeps it from being made")
}

fn html(results: &Results, findings: &[Finding]) -> String {
    report(results, findings).html().expect("the template can be filled")
}

fn markdown(results: &Results, findings: &[Finding]) -> String {
    report(results, findings).markdown().expect("the template can be filled")
}

fn terminal(results: &Results, findings: &[Finding]) -> String {
    report(results, findings).terminal()
}

/// The columns of the widest line.
fn widest(text: &str) -> usize {
    text.lines().map(|line| line.chars().count()).max().unwrap_or(0)
}

#[test]
fn the_same_results_give_the_same_bytes() {
    let results = results(vec![timed("a", 2.0), timed("b", 3.0)], &[TIMES]);
    let findings = [finding("B-1", "fixed", Verdict::Reproduced, true)];
    assert_eq!(html(&results, &findings), html(&results, &findings));
    assert_eq!(markdown(&results, &findings), markdown(&results, &findings));
    assert_eq!(terminal(&results, &findings), terminal(&results, &findings));
}

#[test]
fn the_first_line_cites_program_commit_seed_data_machine_and_date() {
    let row = Row { seed: Some(7), ..timed("a", 2.0) };
    let results = results(vec![row], &[TIMES]);
    let hash = format!("data {:016x}", results.data_hash().unwrap());
    let line = format!("ray_test 9.8.7, commit c0ffee, seed 7, {hash}, Z80, 2026-01-02T03:04:05Z");
    assert!(html(&results, &[]).contains(&line));
    assert!(markdown(&results, &[]).contains(&line));
}

#[test]
fn the_page_fetches_nothing_and_runs_nothing() {
    let results = results(vec![timed("a", 2.0)], &[TIMES]);
    let page = html(&results, &[]);
    for bad in ["<script", "src=", "@import", "url(", "<iframe", "<object"] {
        assert!(!page.contains(bad), "{bad}");
    }
    let foreign = page.match_indices("http").map(|(at, _)| &page[at..(at + 30).min(page.len())]);
    let foreign: Vec<&str> = foreign.filter(|text| !text.contains("www.w3.org/2000/svg")).collect();
    assert_eq!(foreign, [""; 0]);
    assert!(page.contains("Is &#60;this&#62; &#38; &#34;that&#34; shown as it is?"));
}

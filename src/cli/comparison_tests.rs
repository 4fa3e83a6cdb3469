//! Every format says what was found.

use super::*;
use crate::compare::compare;
use crate::table::{Row, RunFile, SCHEMA_VERSION};

/// Two rows, a placebo floor, and a seed.
fn side(seed: u64, factor: f64, false_hits: u64) -> Side {
    let row = |id: &str, factor: f64| Row {
        experiment: "b-4.2".into(),
        id: id.into(),
        workload: "pairs-line".into(),
        order: "fixed".into(),
        density: Some(0.5),
        status: "ok".into(),
        false_hits: Some(false_hits),
        cycles_per_test: Some(20.0 * factor),
        ratio_to_reference: Some(0.8 * factor),
        ratio_low: Some(0.79 * factor),
        ratio_high: Some(0.81 * factor),
        ratio_first_half: Some(0.8 * factor),
        ratio_second_half: Some(0.8 * factor),
        ..Row::default()
    };
    let run = RunFile {
        schema_version: SCHEMA_VERSION.into(),
        environment: json!({ "machine": { "processor": "A | B" }, "build": { "commit": "c0ffee" } }),
        seed,
        workload_hash: "beef".into(),
        rows: vec![row("wald/a", factor), row("plucker/b", 1.0 / factor)],
    };
    Side { sources: vec![Source { path: "rows.json".into(), run }] }
}

fn pair(seed: u64) -> (Side, Side, Comparison) {
    let (base, new) = (side(1, 1.0, 0), side(seed, 1.1, 1));
    let comparison = compare(&base, &new, "3%".parse().unwrap());
    (base, new, comparison)
}

#[test]
fn json_is_one_object_with_the_contracts_names() {
    let (_, _, comparison) = pair(1);
    let read: Value = serde_json::from_str(&json(&comparison).unwrap()).unwrap();
    assert_eq!(read["verdict"], "regressed");
    assert_eq!(
        (&read["cells"], &read["missing"], &read["added"]),
        (&json!(2), &json!(0), &json!(0))
    );
    assert_eq!(read["threshold_percent"], 3.0);
    let regressions = read["regressions"].as_array().unwrap();
    // Two kernels with a false hit each, and one that is slower as well.
    assert_eq!(regressions.len(), 3);
    let slower = &regressions[2];
    let text = ["id", "figure", "experiment", "workload", "order"].map(|key| slower[key].as_str());
    let wanted = ["wald/a", "cycles_per_test", "b-4.2", "pairs-line", "fixed"];
    assert_eq!(text, wanted.map(Some));
    let numbers = ["ratio", "low", "high", "density"].map(|key| slower[key].as_f64().unwrap());
    assert!((numbers[0] - 1.1).abs() < 1e-12 && numbers[1] < 1.1 && numbers[2] > 1.1);
    assert!(regressions[0]["ratio"].is_null());
    assert_eq!(read["improvements"][0]["id"], "plucker/b");
    for key in ["unresolved", "refused"] {
        assert_eq!(read[key], json!([]));
    }
    let (_, _, refused) = pair(2);
    let read: Value = serde_json::from_str(&json(&refused).unwrap()).unwrap();
    assert_eq!(read["verdict"], "refused");
    let wanted = json!({ "key": "seed", "base": "1", "new": "2", "where": "rows.json" });
    assert_eq!(read["refused"], json!([wanted]));
}

#[test]
fn csv_has_a_line_per_finding() {
    let records = |comparison: &Comparison| -> Vec<Vec<String>> {
        let text = csv(comparison).unwrap();
        let mut reader =
            ::csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
        let fields = |record: ::csv::StringRecord| record.iter().map(str::to_owned).collect();
        reader.records().map(|record| fields(record.unwrap())).collect()
    };
    let found = records(&pair(1).2);
    let header = "kind,experiment,id,workload,order,density,figure,ratio,low,high,code,base,new";
    assert_eq!(found[0].join(","), header);
    let kinds: Vec<&str> = found[1..].iter().map(|record| record[0].as_str()).collect();
    assert_eq!(kinds, ["regression", "regression", "regression", "improvement"]);
    assert_eq!(
        found[3][..7],
        ["regression", "b-4.2", "wald/a", "pairs-line", "fixed", "0.5", "cycles_per_test"]
    );
    assert!((found[3][7].parse::<f64>().unwrap() - 1.1).abs() < 1e-12);
    let refused = records(&pair(2).2);
    assert_eq!(
        (refused.len(), &refused[1][0], &refused[1][6]),
        (2, &"refused".into(), &"seed".into())
    );
    assert_eq!(refused[1][11..], ["1", "2"]);
}

#[test]
fn text_ends_with_a_sentence() {
    let (base, new, comparison) = pair(1);
    let printed = text(&comparison, &base, &new);
    let last = printed.lines().last().unwrap();
    assert!(last.starts_with("Regressed: 3 figures in 2 cells are worse"), "{last}");
    for part in ["wald/a", "+10.0 %", "false_hits", "improvement", "commit c0ffee", "threshold 3 %"]
    {
        assert!(printed.contains(part), "{part} is not in {printed}");
    }
    let (base, new, refused) = pair(2);
    let printed = text(&refused, &base, &new);
    assert!(printed.lines().last().unwrap().starts_with("Refused"), "{printed}");
    assert!(printed.contains("seed"));
    let same = compare(&base, &base, "3%".parse().unwrap());
    let printed = text(&same, &base, &base);
    assert_eq!(printed.lines().last(), Some("Same: no change beyond 3 % in 2 cells."));
}

#[test]
fn markdown_is_a_table() {
    let (base, new, comparison) = pair(1);
    let printed = markdown(&comparison, &base, &new);
    assert!(printed.starts_with("**regressed**: `c0ffee` against `c0ffee` on A | B"), "{printed}");
    let rows: Vec<&str> = printed.lines().filter(|line| line.starts_with('|')).collect();
    assert_eq!(rows.len(), 2 + 4);
    for row in rows {
        assert_eq!(row.matches('|').count(), TITLES.len() + 1, "{row}");
    }
    let (base, new, refused) = pair(2);
    assert!(markdown(&refused, &base, &new).contains("| seed | 1 | 2 | rows.json |"));
}

#[test]
fn long_lists_are_cut_in_text_and_whole_elsewhere() {
    let (base, new, mut comparison) = pair(1);
    let finding = comparison.regressions[0].clone();
    comparison.unresolved = vec![finding; 2 * MOST_NAMED];
    comparison.missing = vec![Place { id: "gone".into(), ..Place::default() }; MOST_NAMED + 1];
    let printed = text(&comparison, &base, &new);
    assert!(printed.contains("... and 10 more unresolved"), "{printed}");
    assert!(printed.contains("... and 1 more missing"), "{printed}");
    assert_eq!(printed.matches("missing: gone").count(), MOST_NAMED);
    assert_eq!(csv(&comparison).unwrap().matches("unresolved,").count(), 2 * MOST_NAMED);
}

//! `ray_test recommend` on the committed run: the contract's keys, and what is refused; and that all of that
//! run can be read.
#![cfg(feature = "cli")]

use ray_test::table::{Row, read_csv, read_json};
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

const FROM: [&str; 2] = ["--from", concat!(env!("CARGO_MANIFEST_DIR"), "/results/reference")];

fn recommend(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ray_test"));
    command.arg("recommend").args(arguments).output().unwrap()
}

fn answer(arguments: &[&str]) -> Value {
    let arguments = [&FROM[..], &["--format", "json"], arguments].concat();
    let output = recommend(&arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {message}");
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn an_answer_has_a_variant_reasons_and_a_line_to_paste() {
    let answer = answer(&[]);
    assert!(answer["variant"].as_str().unwrap().split('/').count() >= 8);
    assert!(answer["because"].as_array().unwrap().iter().all(Value::is_string));
    assert!(answer["because"].as_array().unwrap().len() >= 3);
    assert_ne!(answer["variant"], answer["runner_up"]);
    assert!(answer["code"].as_str().unwrap().contains("Test::test::<Usual, "));
}

#[test]
fn demands_show_in_the_answer() {
    for precision in ["f32", "f64"] {
        let answer = answer(&["--precision", precision]);
        assert_eq!(answer["variant"].as_str().unwrap().split('/').nth(1), Some(precision));
    }
    let watertight = answer(&["--watertight"]);
    assert!(watertight["variant"].as_str().unwrap().starts_with("woop-watertight/"));
    // No f32 form errs by so little.
    let exact = answer(&["--tolerance", "1e-12"]);
    assert_eq!(exact["variant"].as_str().unwrap().split('/').nth(1), Some("f64"));
    // The committed run may know nothing of preparing; then few rays get what prepares nothing.
    let few = answer(&["--rays-per-triangle", "1"]);
    assert!(few["because"].to_string().contains("1 ray per triangle"));
}

#[test]
fn texts_have_at_most_a_hundred_columns_and_tables_one_line() {
    let text = recommend(&FROM);
    let text = String::from_utf8(text.stdout).unwrap();
    let sentences = text.lines().skip_while(|line| *line != "because").skip(1);
    let sentences: Vec<&str> = sentences.take_while(|line| !line.is_empty()).collect();
    assert!(sentences.iter().all(|line| line.chars().count() <= 100), "{text}");
    assert!(sentences.len() > 3, "{text}");
    let table = recommend(&[&FROM[..], &["--format", "csv"]].concat());
    let mut reader = csv::Reader::from_reader(table.stdout.as_slice());
    assert_eq!(reader.headers().unwrap().get(0), Some("variant"));
    assert_eq!(reader.records().count(), 1);
}

#[test]
fn what_cannot_be_answered_is_refused() {
    let nowhere = std::env::temp_dir().join("ray_test-no-such-run");
    let refused: [(&[&str], &str); 6] = [
        (&["--from", nowhere.to_str().unwrap()], "no-such-run"),
        (&["--needs", "colour"], "colour"),
        (&["--rays-per-triangle", "0"], "is not in 1.."),
        (&["--tolerance", "-1"], "allowed: a number above 0"),
        (&[FROM[0], FROM[1], "--tolerance", "1e-300"], "that err more"),
        (&[FROM[0], FROM[1], "--precision", "f16"], "f16"),
    ];
    for (arguments, message) in refused {
        let output = recommend(arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(message), "{arguments:?}: {said}");
    }
}

/// The cells of the table under a heading of a report in Markdown, without its head.
fn table(report: &str, heading: &str) -> Vec<Vec<String>> {
    let lines = report.lines().skip_while(|line| *line != heading).skip(1);
    let lines = lines.skip_while(|line| !line.starts_with('|')).skip(2);
    let cells =
        |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    lines.take_while(|line| line.starts_with('|')).map(cells).collect()
}

#[test]
fn the_report_names_what_its_commands_name() {
    let out = std::env::temp_dir().join(format!("ray_test-answers-{}", std::process::id()));
    let mut command = Command::new(env!("CARGO_BIN_EXE_ray_test"));
    let drawn = command.args(["report", FROM[1], "--out"]).arg(&out).output().unwrap();
    let report = std::fs::read_to_string(out.join("report.md"));
    std::fs::remove_dir_all(&out).ok();
    assert_eq!(drawn.status.code(), Some(0), "{}", String::from_utf8_lossy(&drawn.stderr));
    let answers = table(&report.unwrap(), "## Which kernel to take on this machine");
    assert!(answers.len() >= 6, "{answers:?}");
    for cells in answers {
        let (variant, command) =
            (cells[1].trim_matches('`'), cells.last().unwrap().trim_matches('`'));
        let arguments: Vec<&str> = command.split(' ').skip(2).collect();
        // The committed run knows levels that this processor may lack: then another form is named.
        let named = answer(&arguments);
        if !named["because"].to_string().contains("a level that this processor lacks") {
            assert_eq!(named["variant"], variant, "{command}");
        }
    }
}

#[test]
fn every_stored_row_can_be_read_differences_of_times_included() {
    let read = |file: &Path| -> Vec<Row> {
        let rows = match file.extension().is_some_and(|ending| ending == "json") {
            true => read_json(file).map(|run| run.rows),
            false => read_csv(file),
        };
        rows.unwrap_or_else(|error| panic!("{error}"))
    };
    let (mut files, mut negative) = (0, 0);
    for experiment in std::fs::read_dir(FROM[1]).unwrap() {
        for name in ["rows.json", "rows.csv"] {
            let file = experiment.as_ref().unwrap().path().join(name);
            if file.exists() {
                let rows = read(&file);
                let is_negative = |row: &&Row| row.cycles_per_test.is_some_and(|one| one < 0.0);
                negative += rows.iter().filter(is_negative).count();
                files += 1;
            }
        }
    }
    // The mixture of codes foretells more cycles than were measured, in some rows.
    assert!(files > 80 && negative > 0, "{files} files, {negative} negative");
}

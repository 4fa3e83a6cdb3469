//! Runs that were interrupted, files that are broken, folders that hold nothing.

use super::support::*;
use crate::results::LoadError;
use crate::table::{Header, Journal, Journaled, Row, RunKey};
use serde_json::json;
use std::fs;

fn journal(place: &Place, run: &str, rows: &[Row]) {
    let file = place.0.join(run).join("b-4.2/rows.ndjson");
    let header = Header::new(RunKey::default(), "b-4.2", 1);
    let pieces = vec![("cell 0".to_owned(), rows.to_vec())];
    write(&file, "");
    Journal::begin(&file, &Journaled { header, pieces }).expect("ours");
}

#[test]
fn a_killed_run_has_what_its_journal_has() {
    let place = Place::new();
    let rows = [timed("wald", 0.0, 2.0), timed("keidy", 0.0, 3.0)];
    journal(&place, "killed", &rows);
    let environment = environment("P", "3");
    write(&place.0.join("killed/environment.json"), &environment.to_string());
    let results = place.load(&["killed"]).expect("it is there");
    assert_eq!(results.chapters[0].rows, rows);
    assert!(!results.chapters[0].complete);
    assert_eq!(results.sources[0].label, "P");
    assert_eq!(results.sources[0].environment, environment);
}

#[test]
fn of_file_and_journal_the_one_with_more_counts() {
    let place = Place::new();
    let (one, other) = (timed("wald", 0.0, 2.0), timed("keidy", 0.0, 3.0));
    let later = Row { status: "not-measured".into(), ns_per_test: None, ..other.clone() };
    let interrupted = json!({ "complete": false });
    let saved = [one.clone(), later];
    place.run("first", &environment("P", "3"), "b-4.2", &saved, interrupted.clone());
    journal(&place, "first", std::slice::from_ref(&one));
    place.run("second", &environment("P", "3"), "b-4.2", &saved, interrupted);
    journal(&place, "second", &[one.clone(), other.clone()]);
    let rows = |run: &str| {
        let chapter = place.load(&[run]).expect("it is there").chapters.remove(0);
        assert!(!chapter.complete);
        chapter.rows
    };
    assert_eq!(rows("first"), saved);
    assert_eq!(rows("second"), [one, other]);
}

#[test]
fn one_experiments_folder_is_enough_and_its_text_describes_it() {
    let place = Place::new();
    let machine = environment("P", "3");
    place.run("run", &machine, "b-4.2", &[timed("wald", 0.0, 2.0)], ended());
    place.run("run", &machine, "h-11", &[exact("wald", 1, 0.5)], ended());
    write(&place.0.join("run/h-11/experiment.toml"), "Its text");
    let results = place.load(&["run/h-11"]).expect("it is there");
    assert_eq!(results.chapters.len(), 1);
    assert_eq!(results.chapters[0].about.title, "Its text");
    assert_eq!(results.chapters[0].workload_hash, "hash of h-11");
    assert_eq!(results.sources[0].label, "P");
    let both = place.load(&["run"]).expect("it is there");
    let titles: Vec<&str> = both.chapters.iter().map(|one| one.about.title.as_str()).collect();
    assert_eq!(titles, ["b-4.2", "Its text"]);
    assert!(both.chapter("b-4.2").is_some_and(|one| one.about.figures.is_empty()));
}

#[test]
fn a_run_without_rows_is_no_error() {
    let place = Place::new();
    place.run("empty", &environment("P", "3"), "b-4.2", &[], ended());
    let results = place.load(&["empty"]).expect("it is there");
    assert_eq!((results.chapters[0].about.id.as_str(), results.rows().count()), ("b-4.2", 0));
}

#[test]
fn what_cannot_be_read_is_named_with_what_is_allowed() {
    let place = Place::new();
    fs::create_dir_all(place.0.join("nothing/at/all")).expect("ours");
    write(&place.0.join("syntax/b-4.2/rows.json"), "{\n oops");
    write(&place.0.join("journal/b-4.2/rows.ndjson"), "{}\n");
    place.run("cell", &environment("P", "3"), "b-4.2", &[timed("a", 0.0, 2.0)], ended());
    let file = place.0.join("cell/b-4.2/rows.json");
    let text = fs::read_to_string(&file).expect("it was written");
    fs::write(&file, text.replace("\"ns_per_test\":2.0", "\"ns_per_test\":\"two\"")).expect("ours");
    place.run("environment", &environment("P", "3"), "b-4.2", &[], ended());
    write(&place.0.join("environment/environment.json"), "{\n oops");
    for (run, id) in [("above", "../../evil"), ("root", "/evil"), ("below", "a/b"), ("here", ".")] {
        let row = Row { experiment: id.into(), ..timed("a", 0.0, 2.0) };
        place.run(run, &environment("P", "3"), "b-4.2", &[row], ended());
    }
    for (run, words) in [
        ("missing", &["missing"][..]),
        ("nothing", &["nothing", "rows.json"]),
        ("syntax", &["rows.json", "line 2"]),
        ("journal", &["rows.ndjson", "line 1"]),
        ("cell", &["rows.json", "row 1", "ns_per_test", "two"]),
        ("environment", &["environment.json", "line 2"]),
        // What is made of them would go elsewhere.
        ("above", &["b-4.2", "experiment", "'../../evil'"]),
        ("root", &["b-4.2", "experiment", "'/evil'"]),
        ("below", &["b-4.2", "experiment", "'a/b'"]),
        ("here", &["b-4.2", "experiment", "'.'"]),
    ] {
        let error = place.load(&[run]).map(|_| ()).expect_err(run);
        let message = error.to_string();
        for word in words.iter().chain(&["allowed"]) {
            assert!(message.contains(word), "{run}: no '{word}' in: {message}");
        }
        assert_eq!(matches!(error, LoadError::Nothing(_)), run == "nothing");
    }
}

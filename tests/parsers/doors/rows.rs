//! What runs have stored.

use super::folder::Folder;
use super::picture::finite;
use ray_test::chart::{timeline, timeline_words};
use ray_test::cli::doors;
use ray_test::table::{
    Journal, RoundsFile, read_csv, read_journal, read_json, read_rounds, write_csv, write_json,
};
use std::path::Path;

/// Tables, rounds and journals: what can be read comes out of a file again as it went in.
pub fn stored(bytes: &[u8]) {
    let folder = Folder::new();
    let (file, again) = (folder.write("stored", bytes), folder.path().join("again"));
    if let Ok(rows) = read_csv(&file) {
        write_csv(&again, &rows).expect("it can be written");
        assert_eq!(read_csv(&again).expect("it is ours"), rows);
    }
    if let Ok(rounds) = read_rounds(&file) {
        RoundsFile::begin(&again, &rounds).expect("it can be written");
        assert_eq!(read_rounds(&again).expect("it is ours"), rounds);
        finite(&timeline(&rounds, false).expect("whatever the rounds"));
        timeline_words(&rounds);
    }
    if let Ok(journal) = read_journal(&file) {
        let journal = journal.expect("it is there");
        Journal::begin(&again, &journal).expect("it can be written");
        assert_eq!(read_journal(&again).expect("it is ours"), Some(journal));
    }
}

/// Rows with what they were measured on: again as they were, against themselves, and what they recommend.
pub fn rows_json(bytes: &[u8]) {
    let folder = Folder::new();
    let file = folder.write("b-4.2/rows.json", bytes);
    let Ok(run) = read_json(&file) else { return };
    let again = folder.path().join("again.json");
    write_json(&again, &run).expect("it can be written");
    assert_eq!(read_json(&again).expect("it is ours"), run);
    doors::comparison(&file, folder.path()).ok();
    doors::recommendation(folder.path()).ok();
}

/// What stands between the files of [`report`].
const BETWEEN: &[u8] = b"\n%%%%\n";

/// A whole folder, to its report: `rows.json`, `experiment.toml`, `environment.json`, `rounds.csv`, `rows.ndjson`,
/// of which those behind may be missing.
pub fn report(bytes: &[u8]) {
    const NAMES: [&str; 5] = [
        "b-4.2/rows.json",
        "b-4.2/experiment.toml",
        "environment.json",
        "b-4.2/rounds.csv",
        "b-4.2/rows.ndjson",
    ];
    let folder = Folder::new();
    for (name, part) in NAMES.iter().zip(parts(bytes)) {
        folder.write(&format!("run/{name}"), part);
    }
    let out = folder.path().join("out");
    doors::report(&folder.path().join("run"), &out).ok();
    // Whatever the rows call themselves, nothing is written beside what was asked for.
    let beside = std::fs::read_dir(folder.path()).expect("it is ours").flatten();
    assert!(beside.map(|entry| entry.path()).all(|path| path == out || path.ends_with("run")));
    each_picture(&out);
}

fn parts(bytes: &[u8]) -> Vec<&[u8]> {
    let mut parts = Vec::new();
    let mut rest = bytes;
    while let Some(at) = rest.windows(BETWEEN.len()).position(|window| window == BETWEEN) {
        parts.push(&rest[..at]);
        rest = &rest[at + BETWEEN.len()..];
    }
    parts.push(rest);
    parts
}

fn each_picture(folder: &Path) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            each_picture(&path);
        } else if path.extension().is_some_and(|ending| ending == "svg") {
            finite(&std::fs::read_to_string(path).expect("a picture of ours"));
        }
    }
}

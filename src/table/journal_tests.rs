//! Tests of the journal: what was cut is dropped, what is wrong is named.

use super::tests::Folder;
use super::*;
use std::fs;

fn header() -> Header {
    let run_key = RunKey { config: "a".into(), binary: "b".into(), machine: "c".into() };
    Header::new(run_key, "b-4.1", 7)
}

fn rows(id: &str, number: u64) -> Vec<Row> {
    let row = |code| Row { id: id.into(), code: Some(code), density: Some(0.1), ..Row::default() };
    (0..number).map(row).collect()
}

/// A journal of two pieces: its path, and its text.
fn two_pieces(folder: &Folder) -> (PathBuf, String) {
    let path = folder.file("rows.ndjson");
    let mut journal = Journal::begin(&path, &Journaled { header: header(), pieces: vec![] });
    let journal = journal.as_mut().unwrap();
    journal.append("first", &rows("a", 3)).unwrap();
    journal.append("second", &rows("b", 2)).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    (path, text)
}

#[test]
fn what_was_appended_comes_back() {
    let folder = Folder::new("journal");
    let (path, text) = two_pieces(&folder);
    assert_eq!(text.lines().count(), 1 + 3 + 2);
    let journaled = read_journal(&path).unwrap().unwrap();
    assert_eq!(journaled.header, header());
    let pieces = [("first".to_owned(), rows("a", 3)), ("second".to_owned(), rows("b", 2))];
    assert_eq!(journaled.pieces, pieces);
    assert_eq!(read_journal(&folder.file("none.ndjson")).unwrap(), None);
    // Begun again with what was read, it is the same to the byte.
    Journal::begin(&path, &journaled).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
}

#[test]
fn wherever_it_is_cut_whole_pieces_remain() {
    let folder = Folder::new("journal-cut");
    let (path, text) = two_pieces(&folder);
    let ends: Vec<usize> = text.match_indices('\n').map(|(at, _)| at + 1).collect();
    for length in ends[0]..text.len() {
        fs::write(&path, &text[..length]).unwrap();
        let read = read_journal(&path).unwrap().unwrap();
        let whole = usize::from(length >= ends[3]) + usize::from(length >= ends[5]);
        assert_eq!(read.pieces.len(), whole, "{length} bytes");
    }
    // A last line that is no JSON counts as cut, too: a power cut may leave anything there.
    fs::write(&path, format!("{text}\0\0\0\n")).unwrap();
    assert_eq!(read_journal(&path).unwrap().unwrap().pieces.len(), 2);
}

#[test]
fn a_bad_line_is_named_with_what_is_allowed() {
    let folder = Folder::new("journal-bad");
    let (path, text) = two_pieces(&folder);
    let refused = |text: &str, parts: &[&str]| {
        fs::write(&path, text).unwrap();
        let message = read_journal(&path).unwrap_err().to_string();
        for part in parts.iter().chain(&["rows.ndjson"]) {
            assert!(message.contains(part), "'{part}' is not in: {message}");
        }
    };
    refused("", &["line 1", "allowed: a header"]);
    refused(&text.replacen("\"machine\"", "\"engine\"", 1), &["line 1", "machine", "allowed"]);
    refused(&text.replacen("\"1.0\"", "\"2.0\"", 1), &["schema_version '2.0'", "1.0"]);
    refused(&text.replacen("\"first\"", "first", 1), &["line 2", "allowed: one JSON object"]);
    refused(&text.replacen("rows_of_piece", "rows", 1), &["line 2", "rows_of_piece"]);
    refused(&text.replacen("0.1", "\"x\"", 1), &["line 2", "density", "'x'", "allowed"]);
}

#[test]
fn temporary_files_are_removed_and_nothing_else() {
    let folder = Folder::new("partial");
    for name in [".rows.json.17-0.partial", "rows.json", ".hidden", "partial"] {
        fs::write(folder.file(name), "x").unwrap();
    }
    remove_partial_files(&folder.file(""));
    remove_partial_files(&folder.file("no-such-folder"));
    let names = fs::read_dir(folder.file("")).unwrap().map(|entry| entry.unwrap().file_name());
    let mut names: Vec<_> = names.collect();
    names.sort();
    assert_eq!(names, [".hidden", "partial", "rows.json"]);
}

#[test]
fn the_part_of_a_key_that_differs_is_named() {
    let key = header().run_key;
    let other = RunKey { binary: "x".into(), machine: "y".into(), ..key.clone() };
    assert_eq!(key.difference(&key), None);
    assert_eq!(key.difference(&other), Some(("binary", "b", "x")));
}

//! Runs that are killed, interrupted and gone on with: what they leave parses, and what becomes of
//! them is what an undisturbed run gives. `RAY_TEST_KILLS` is how many are killed at random.
#![cfg(feature = "cli")]

mod support;

use std::fs;
use std::process::{Child, Output};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use ray_test::table::{Journal, Row, read_journal, read_json};
use support::*;

/// One at a time: these tests start programs that measure.
fn turn() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The rows of an undisturbed run, and how long it took. Taken in one's turn.
fn undisturbed() -> &'static (Vec<Row>, Duration) {
    static RUN: OnceLock<(Vec<Row>, Duration)> = OnceLock::new();
    RUN.get_or_init(|| {
        let place = Place::new("undisturbed");
        let start = Instant::now();
        place.finish("out", &[]);
        (place.rows("out"), start.elapsed())
    })
}

/// Starts a run, and waits until the journal of an experiment has so many lines.
fn begun(place: &Place, more: &[&str], id: &str, number: usize) -> Child {
    let child = place.run("out", more).spawn().expect("the program starts");
    wait_for("a journal", || lines(&place.journal("out", id)) >= number);
    child
}

/// A run that was killed between two pieces of an experiment, the last line of what it kept cut.
fn cut(place: &Place) {
    assert!(kill(begun(place, &["--profile", "standard"], "searches", 5)));
    let journal = place.journal("out", "searches");
    let text = fs::read_to_string(&journal).expect("it was waited for");
    fs::write(&journal, &text[..text.trim_end().len() - 40]).expect("ours");
}

/// Such a run, gone on with until it has dropped the cut piece and measures it again.
#[cfg(unix)]
fn gone_on_with(place: &Place) -> Child {
    cut(place);
    let journal = place.journal("out", "searches");
    let before = lines(&journal);
    let child = place.run("out", &["--profile", "standard", "--resume"]).spawn();
    wait_for("a journal without the cut piece", || lines(&journal) < before);
    child.expect("the program starts")
}

/// Kills a run; whether it was still there.
fn kill(mut child: Child) -> bool {
    let here = child.try_wait().expect("it is our child").is_none();
    child.kill().expect("it is our child");
    child.wait().expect("it is our child");
    here
}

fn code_and_stderr(output: &Output) -> (Option<i32>, String) {
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn killed_at_any_moment_and_gone_on_with() {
    let _turn = turn();
    let (undisturbed, span) = undisturbed();
    let kills = std::env::var("RAY_TEST_KILLS").ok().and_then(|text| text.parse().ok());
    let kills: u32 = kills.unwrap_or(5);
    // Spread over the run, at random within each part of it (Knuth's 64-bit generator).
    let mut state = 0x5eed_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1u64 << 24) as f64
    };
    let (mut were_running, mut rows_kept) = (0, 0);
    for number in 0..kills {
        let when = format!("kill {number}");
        let place = Place::new(&format!("kill-{number}"));
        let delay = span.mul_f64((f64::from(number) + random()) / f64::from(kills));
        let child = place.run("out", &[]).spawn().expect("the program starts");
        std::thread::sleep(delay);
        were_running += u32::from(kill(child));
        let mut kept = place.read_everything("out");
        if number % 3 == 0 {
            // What goes on with a run can be killed as well.
            let child = place.run("out", &["--resume"]).spawn().expect("the program starts");
            std::thread::sleep(span.mul_f64(random() / 2.0));
            kill(child);
            kept.extend(place.read_everything("out"));
        }
        rows_kept += kept.len();
        place.finish("out", &["--resume"]);
        let rows = place.rows("out");
        assert_same(&rows, undisturbed, &when);
        assert_taken(&kept, &rows, &when);
    }
    println!("{kills} killed, {were_running} while running; {rows_kept} rows came from journals");
}

#[test]
fn a_cut_last_line_is_measured_again() {
    let _turn = turn();
    let place = Place::new("cut");
    cut(&place);
    let kept = place.read_everything("out");
    assert!(!kept.is_empty());
    place.finish("out", &["--resume", "--profile", "standard"]);
    let rows = place.rows("out");
    assert_same(&rows, &undisturbed().0, "cut");
    assert_taken(&kept, &rows, "cut");
}

#[test]
fn what_differs_is_refused_by_name_and_nothing_is_touched() {
    let _turn = turn();
    let place = Place::new("refused");
    assert!(kill(begun(&place, &["--profile", "standard"], "searches", 5)));
    let journal = place.journal("out", "searches");
    // Without the piece that it was killed in, which is dropped as soon as a run goes on.
    let whole = read_journal(&journal).expect("it can be read").expect("it was waited for");
    Journal::begin(&journal, &whole).expect("ours");
    let text = fs::read_to_string(&journal).expect("ours");
    let refused = |more: &[&str], parts: &[&str]| {
        let before = fs::read(&journal).expect("it is still there");
        let output = place.run("out", &[&["--resume"], more].concat()).output();
        let (code, message) = code_and_stderr(&output.expect("the program starts"));
        assert_eq!(code, Some(2), "{message}");
        for part in parts.iter().chain(&["--resume", "allowed"]) {
            assert!(message.contains(part), "no '{part}' in: {message}");
        }
        assert!(fs::read(&journal).expect("it is still there") == before, "{message}");
    };
    let same = ["--profile", "standard"];
    refused(&[], &["another config", "--profile standard", "--profile quick"]);
    refused(&[same[0], same[1], "--filter", "."], &["another config", "--filter ."]);
    let tampered = |from: &str, to: &str, parts: &[&str]| {
        assert!(text.contains(from), "{from}");
        fs::write(&journal, text.replacen(from, to, 1)).expect("ours");
        refused(&same, parts);
    };
    tampered("\"machine\":\"", "\"machine\":\"x", &["another machine", "'x"]);
    tampered("\"binary\":\"", "\"binary\":\"x", &["another binary", "'x"]);
    tampered("\"workload_hash\":\"", "\"workload_hash\":\"x", &["workload_hash", "'x", "now"]);
    tampered("\"tests\":", "\"tests\":-", &["rows.ndjson", "line 2", "tests"]);
    fs::write(&journal, &text).expect("ours");
    let config = place.path("pairs.toml");
    let changed = fs::read_to_string(&config).expect("ours").replace("0.25", "0.75");
    fs::write(&config, changed).expect("ours");
    refused(&same, &["another config", "text"]);
}

#[test]
fn one_run_at_a_time() {
    let _turn = turn();
    let place = Place::new("lock");
    let first = begun(&place, &["--profile", "standard"], "pairs", 1);
    let second = place.run("second", &[]).output().expect("the program starts");
    let (code, message) = code_and_stderr(&second);
    assert_eq!(code, Some(1), "{message}");
    for part in [format!("pid {}", first.id()).as_str(), "two at once spoil each other's times"] {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
    assert!(!place.path("second").exists());
    // What measures nothing needs no lock; and a lock ends with its holder, however that ends.
    place.finish("second", &["--dry-run"]);
    assert!(kill(first));
    place.finish("second", &[]);
}

#[cfg(unix)]
#[test]
fn interrupted_it_saves_shows_and_says_how_to_go_on() {
    let _turn = turn();
    for (signal, id) in [("-INT", "searches"), ("-TERM", "codes")] {
        let place = Place::new(&format!("signal{signal}"));
        let child = match id {
            "searches" => gone_on_with(&place),
            _ => begun(&place, &["--profile", "standard"], id, 1),
        };
        let mut kill = std::process::Command::new("kill");
        assert!(kill.arg(signal).arg(child.id().to_string()).status().expect("a kill").success());
        let output = child.wait_with_output().expect("it is our child");
        let (code, message) = code_and_stderr(&output);
        assert_eq!(code, Some(130), "{signal}: {message}");
        assert!(message.contains("--out out --profile standard --resume"), "{message}");
        let table = format!("out/{id}/rows.csv");
        let shown = String::from_utf8_lossy(&output.stdout);
        assert!(shown.contains(&table), "{shown}");
        // What was measured is drawn; the report waits for the rest.
        assert!(place.path("out/pairs/pairs.svg").is_file(), "{message}");
        assert!(!place.path("out/report.html").exists());
        let kept = place.read_everything("out");
        let run = read_json(&place.path("out").join(id).join("rows.json")).expect("it was saved");
        assert_eq!(run.environment["complete"], false);
        // What it had before it was gone on with is there, and nothing but that is kept.
        assert_eq!(kept.is_empty(), id == "codes", "{message}");
        assert_taken(&kept, &run.rows, signal);
        // On a machine that is never quiet nothing has a time.
        let is_timed = run.rows.iter().any(|row| row.ns_per_test.is_some());
        assert_eq!(shown.contains("ns_per_test"), is_timed, "{shown}");
        assert!(place.journal("out", id).exists());
        place.finish("out", &["--profile", "standard", "--resume"]);
        assert!(place.path("out/report.html").is_file());
        let rows = place.rows("out");
        assert_same(&rows, &undisturbed().0, signal);
        assert_taken(&kept, &rows, signal);
    }
}

#[test]
fn an_older_run_in_the_same_folder_does_not_count() {
    let _turn = turn();
    let place = Place::new("older");
    place.finish("out", &[]);
    let older = place.rows("out");
    assert!(kill(begun(&place, &[], "pairs", 2)));
    for id in experiments() {
        assert!(place.journal("out", id).exists(), "{id} counts as finished");
    }
    place.finish("out", &["--resume"]);
    let rows = place.rows("out");
    assert_same(&rows, &older, "older");
    assert!(rows.iter().all(|row| row.ns_per_test.is_none() || !older.contains(row)));
    let output = place.finish("out", &["--resume"]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(message.matches("finished before").count(), experiments().count(), "{message}");
    assert_eq!(place.rows("out"), rows);
}

//! Tests of other crates beside ours (feature `peers`), and what a build without them makes of their
//! experiments.
#![cfg(feature = "cli")]

#[cfg(feature = "peers")]
mod answers;
#[cfg(feature = "peers")]
#[path = "../support/mod.rs"]
mod support;

use std::process::{Command, Output};

/// The program at the top of the package.
fn program(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ray_test"))
        .args(words)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("the program was built")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// The first words of the lines of a table.
fn first_words(table: &[u8]) -> Vec<String> {
    let word = |line: &str| line.split([',', ' ']).next().map(str::to_owned);
    text(table).lines().filter_map(word).collect()
}

const EXPERIMENTS: [&str; 2] = ["peers", "peers-facing"];

#[test]
fn their_experiments_are_listed_by_every_build() {
    let listed = first_words(&program(&["list", "experiments", "--format", "csv"]).stdout);
    for id in EXPERIMENTS {
        assert!(listed.iter().any(|word| word == id), "no {id} in {listed:?}");
    }
}

#[test]
#[cfg(feature = "peers")]
fn a_build_with_them_plans_their_experiments() {
    let output = program(&["reproduce", "--dry-run"]);
    let planned = first_words(&output.stdout);
    for id in EXPERIMENTS {
        assert!(planned.iter().any(|word| word == id), "no {id} in {planned:?}");
    }
    assert!(!text(&output.stderr).contains("skipped"), "{}", text(&output.stderr));
}

#[test]
#[cfg(not(feature = "peers"))]
fn a_build_without_them_skips_their_experiments_and_says_so_once() {
    let output = program(&["reproduce", "--dry-run"]);
    let planned = first_words(&output.stdout);
    assert!(planned.iter().any(|word| word == "b-4.1"), "{planned:?}");
    let said = text(&output.stderr);
    assert_eq!(said.matches("skipped 2 (peers-facing, peers)").count(), 1, "{said}");
    assert!(said.contains("--features peers"), "{said}");
    for id in EXPERIMENTS {
        assert!(planned.iter().all(|word| word != id), "{id} in {planned:?}");
    }
}

#[test]
#[cfg(not(feature = "peers"))]
fn a_run_of_nothing_else_is_no_failure_and_writes_nothing() {
    let folder = std::env::temp_dir().join(format!("ray_test-peers-{}", std::process::id()));
    let path = folder.display().to_string();
    for more in [&[][..], &["--filter", "^peer-"]] {
        let output = program(&[&["run", "configs/peers.toml", "--out", &path], more].concat());
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert!(text(&output.stderr).contains("skipped 1 (peers)"), "{}", text(&output.stderr));
        assert!(output.stdout.is_empty() && !folder.exists());
    }
}

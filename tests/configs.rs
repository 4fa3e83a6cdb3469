//! The experiments that are part of the program, as files. Whether their variants exist is a
//! matter of the registry, and is checked when they are run.
#![cfg(feature = "cli")]

use ray_test::claims::Ledger;
use ray_test::experiment::Experiment;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const IDS: [&str; 48] = [
    "arithmetic",
    "b-4.1",
    "b-4.10",
    "b-4.2",
    "b-4.3",
    "b-4.4",
    "b-4.5",
    "b-4.7",
    "b-4.9",
    "batches",
    "branches-packets",
    "branches",
    "bundles",
    "calls",
    "coherence",
    "common-origin",
    "groups",
    "h-10",
    "h-11",
    "h-4",
    "h-5",
    "h-6",
    "h-7",
    "h-8",
    "h-9",
    "h-double",
    "lanes",
    "layouts",
    "limit",
    "memory",
    "outputs",
    "packets",
    "padding",
    "parallel",
    "peers-facing",
    "peers-scene",
    "peers",
    "pictures",
    "points",
    "precision",
    "precompute",
    "projection",
    "reciprocal",
    "single-vector",
    "structures-million",
    "structures",
    "tests-form",
    "tests-order",
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("configs")
}

/// File names without `.toml`, and what the files hold.
fn experiments() -> Vec<(String, Experiment)> {
    let files = fs::read_dir(folder()).unwrap().map(|file| file.unwrap().path());
    let mut files: Vec<PathBuf> =
        files.filter(|path| path.extension().is_some_and(|ending| ending == "toml")).collect();
    files.sort();
    let parsed = |path: PathBuf| {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(&path).unwrap();
        let experiment = Experiment::parse(&path.display().to_string(), &text);
        (name, experiment.unwrap_or_else(|error| panic!("{error}")))
    };
    files.into_iter().map(parsed).collect()
}

#[test]
fn the_experiments_are_these_and_each_is_named_as_its_file() {
    let found = experiments();
    let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, IDS);
    for (name, experiment) in &found {
        assert_eq!(*name, experiment.id);
    }
}

#[test]
fn every_question_is_a_question() {
    let is_question = |text: &str| text.trim_end().ends_with('?');
    for (name, experiment) in experiments() {
        assert!(is_question(&experiment.title), "{name}: {}", experiment.title);
        assert!(is_question(&experiment.question), "{name}: {}", experiment.question);
        assert!(experiment.why.len() > 100, "{name} does not say why");
        assert!(!experiment.figure.is_empty(), "{name} draws nothing");
        for figure in &experiment.figure {
            assert!(is_question(&figure.question), "{name}: {}", figure.question);
        }
    }
}

#[test]
fn every_claim_is_listed_once_and_every_experiment_names_listed_ones() {
    let ledger = Ledger::embedded().unwrap_or_else(|error| panic!("{error}"));
    let ids: BTreeSet<&str> = ledger.claims().iter().map(|claim| claim.id.as_str()).collect();
    assert_eq!(ids.len(), ledger.claims().len());
    for claim in ledger.claims() {
        assert!(claim.statement.ends_with('.'), "{}", claim.id);
    }
    for (name, experiment) in experiments() {
        let mirrors = !experiment.mirrors.is_empty();
        assert!(!mirrors || !experiment.claims.is_empty(), "{name} decides nothing");
        let own: BTreeSet<&str> = experiment.claims.iter().map(String::as_str).collect();
        assert_eq!(own.len(), experiment.claims.len(), "{name} names a claim twice");
        assert!(own.is_subset(&ids), "{name}: {:?}", own.difference(&ids));
    }
}

#[test]
fn patterns_are_of_whole_ids() {
    for (name, experiment) in experiments() {
        for pattern in &experiment.variants {
            assert!(pattern.starts_with('^') && pattern.ends_with('$'), "{name}: {pattern}");
        }
    }
}

#[test]
fn a_figures_file_is_named_after_its_experiment_and_no_two_are_the_same() {
    for (name, experiment) in experiments() {
        let files: BTreeSet<&str> = experiment.figure.iter().map(|f| f.file.as_str()).collect();
        assert_eq!(files.len(), experiment.figure.len(), "{name}");
        assert_eq!(experiment.figure.first().map(|f| f.file.as_str()), Some(name.as_str()));
        assert!(files.iter().all(|file| file.starts_with(&name)), "{name}: {files:?}");
    }
}

#[test]
fn the_theses_experiments_are_set_up_as_the_theses_are() {
    for (name, experiment) in experiments() {
        let words = format!("{:?}", experiment.workload);
        match name.get(..2) {
            Some("b-") if !words.starts_with("Counts") => {
                // Pairs of a rare code are too few for a block in an order of their own.
                let codes = words.starts_with("Codes");
                let orders = match name.as_str() {
                    // What is compared there is computers, in the thesis's own order.
                    "b-4.3" => "[Literal]",
                    _ if codes => "[Literal, Fixed]",
                    _ => "[Literal, Fixed, Reshuffled]",
                };
                assert!(words.contains(orders), "{name}: {words}");
                assert!(experiment.reference.starts_with("moller1/f32/single/sse2/"), "{name}");
            }
            // Errors have no clock, and so no order.
            Some("h-") if words.starts_with("Errors") => {}
            Some("h-") => assert!(words.contains("[Fixed, Reshuffled]"), "{name}: {words}"),
            _ => {}
        }
    }
}

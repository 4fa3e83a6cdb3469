//! The ledger and the experiments name each other.
#![cfg(feature = "cli")]

use ray_test::claims::{Claim, Ledger};
use ray_test::experiment::Experiment;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Ids of experiments and the claims that each says it decides.
fn experiments() -> BTreeMap<String, BTreeSet<String>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs");
    let files = fs::read_dir(folder).unwrap().map(|file| file.unwrap().path());
    let files = files.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let read = |path: std::path::PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let experiment = Experiment::parse(&path.display().to_string(), &text).unwrap();
        (experiment.id, experiment.claims.into_iter().collect())
    };
    files.map(read).collect()
}

fn ledger() -> Ledger {
    Ledger::embedded().unwrap_or_else(|error| panic!("{error}"))
}

/// The sweep of stiff cases is a verb of its own, without a config.
const WITHOUT_CONFIG: &str = ray_test::stability::EXPERIMENT;

#[test]
fn every_experiment_of_a_claim_exists() {
    let experiments = experiments();
    for claim in ledger().claims() {
        for id in claim.experiments() {
            let exists = experiments.contains_key(id) || id == WITHOUT_CONFIG;
            assert!(exists, "{} is judged by {id}, which does not exist", claim.id);
        }
        assert_eq!(claim.experiments().is_empty(), !claim.is_testable(), "{}", claim.id);
    }
}

#[test]
fn experiments_name_the_claims_that_are_judged_by_them_and_no_others() {
    let ledger = ledger();
    let of = |id: &String| -> BTreeSet<String> {
        let uses = |claim: &&Claim| claim.experiments().contains(&id.as_str());
        ledger.claims().iter().filter(uses).map(|claim| claim.id.clone()).collect()
    };
    for (id, named) in experiments() {
        assert_eq!(named, of(&id), "{id}");
    }
}

/// A claim's filters name kernels and levels that exist, so that it is not undecided for ever.
#[cfg(target_arch = "x86_64")]
#[test]
fn words_of_filters_exist() {
    use ray_test::chart::Wanted;
    use ray_test::registry::variants;
    fn words(wanted: &Wanted) -> Vec<&str> {
        match wanted {
            Wanted::Any(all) => all.iter().flat_map(words).collect(),
            Wanted::Word(word) => vec![word],
            Wanted::Number(_) => Vec::new(),
        }
    }
    let values: BTreeMap<&str, BTreeSet<String>> = ["kernel", "drive", "stored", "reciprocal"]
        .into_iter()
        .map(|column| {
            let place = ray_test::registry::COLUMNS.iter().position(|own| *own == column).unwrap();
            let of =
                |variant: &ray_test::registry::Variant| variant.axes.values()[place].to_owned();
            (column, variants().iter().map(of).collect())
        })
        .collect();
    for claim in ledger().claims() {
        for (column, wanted) in claim.series.values().flat_map(|series| &series.filter) {
            let Some(known) = values.get(column.as_str()) else { continue };
            for word in words(wanted).into_iter().filter(|word| *word != "stream") {
                assert!(known.contains(word), "{}: {column} = {word}", claim.id);
            }
        }
    }
}

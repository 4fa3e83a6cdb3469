//! Whether two results may be compared: the same machine, the same inputs.
//!
//! Load, date, clock frequency and commit may differ; so may the profile and its rounds.

use std::collections::HashSet;

use serde_json::Value;

use super::cell::Matched;
use super::finding::{Place, Refusal};
use super::side::{Side, Source};
use crate::table::{Row, SETTING_COLUMNS};

/// Everything that forbids the comparison, each difference once.
pub(super) fn refusals(base: &Side, new: &Side, matched: &Matched<'_>) -> Vec<Refusal> {
    let mut refusals = Refusals::default();
    for (old, new) in files(base, new) {
        of_files(&mut refusals, old, new);
    }
    for (entry, settings) in &matched.apart {
        let both = entry.settings.iter().zip(settings);
        for (key, (base, new)) in SETTING_COLUMNS.into_iter().zip(both) {
            refusals.add(key, base, new, || place(entry.row));
        }
    }
    for (old, new) in &matched.pairs {
        if !old.workload_hash.is_empty() && !new.workload_hash.is_empty() {
            refusals.add("workload_hash", &old.workload_hash, &new.workload_hash, || place(new));
        }
    }
    if refusals.found.is_empty() && matched.pairs.is_empty() {
        nothing_in_common(&mut refusals, base, new);
    }
    refusals.found
}

#[derive(Default)]
struct Refusals {
    found: Vec<Refusal>,
    known: HashSet<(&'static str, String, String)>,
}

impl Refusals {
    fn add(&mut self, key: &'static str, base: &str, new: &str, place: impl FnOnce() -> String) {
        if base == new || !self.known.insert((key, base.to_owned(), new.to_owned())) {
            return;
        }
        let value = |text: &str| (!text.is_empty()).then(|| text.to_owned());
        let (base, new) = (value(base), value(new));
        self.found.push(Refusal { key, base, new, place: place() });
    }
}

/// Files about the same experiment. Two single files belong together whatever they are about.
fn files<'a>(base: &'a Side, new: &'a Side) -> Vec<(&'a Source, &'a Source)> {
    if let ([old], [new]) = (&base.sources[..], &new.sources[..]) {
        return vec![(old, new)];
    }
    let experiments = |source: &'a Source| -> HashSet<&'a str> {
        source.run.rows.iter().map(|row| row.experiment.as_str()).collect()
    };
    let mut pairs = Vec::new();
    for old in &base.sources {
        let of_old = experiments(old);
        let others = new.sources.iter().filter(|new| !of_old.is_disjoint(&experiments(new)));
        pairs.extend(others.map(|new| (old, new)));
    }
    pairs
}

fn of_files(refusals: &mut Refusals, old: &Source, new: &Source) {
    let place = || new.path.display().to_string();
    let field = |source: &Source, pointer: &str| match source.field(pointer) {
        Some(Value::String(text)) => text.clone(),
        Some(other) => other.to_string(),
        None => String::new(),
    };
    let mut environment = |key, pointer: &str| {
        refusals.add(key, &field(old, pointer), &field(new, pointer), place);
    };
    environment("testbed_id", "/testbed_id");
    environment("debug_assertions", "/build/debug_assertions");
    refusals.add("seed", &old.run.seed.to_string(), &new.run.seed.to_string(), place);
    // The file's hash is that of its rows' workloads in their order. Where the rows are the same,
    // it must be the same; where rows were left out or come in another order, each row's own tells.
    if same_sequence(&old.run.rows, &new.run.rows) {
        let hashes = (&old.run.workload_hash, &new.run.workload_hash);
        refusals.add("workload_hash", hashes.0, hashes.1, place);
    }
}

/// Whether two files have the same rows in the same order, figures aside.
fn same_sequence(base: &[Row], new: &[Row]) -> bool {
    let same = |(a, b): (&Row, &Row)| {
        (&a.id, &a.kernel, a.code, &a.priced) == (&b.id, &b.kernel, b.code, &b.priced)
            && (&a.workload, &a.order, a.density) == (&b.workload, &b.order, b.density)
    };
    base.len() == new.len() && base.iter().zip(new).all(same)
}

/// Says in what two sides without a common cell differ.
fn nothing_in_common(refusals: &mut Refusals, base: &Side, new: &Side) {
    let names = |side: &Side, of: fn(&Row) -> String| {
        let mut names: Vec<String> = Vec::new();
        for name in side.rows().map(of) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    };
    let both = |of: fn(&Row) -> String| (names(base, of), names(new, of));
    let (old_experiments, new_experiments) = both(|row| row.experiment.clone());
    let shared = old_experiments.iter().any(|name| new_experiments.contains(name));
    let everywhere = || "no cell of one is in the other".to_owned();
    if shared {
        let (old_ids, new_ids) = both(|row| Place::of(row).id);
        refusals.add("id", &shortened(&old_ids), &shortened(&new_ids), everywhere);
    } else {
        let (old, new) = (shortened(&old_experiments), shortened(&new_experiments));
        refusals.add("experiment", &old, &new, everywhere);
    }
    if refusals.found.is_empty() {
        // The same ids, each of them about another code, output or experiment.
        let (base, new) = ("cells of the base".to_owned(), "others".to_owned());
        refusals.add("cell", &base, &new, everywhere);
    }
}

/// The first few of a list.
fn shortened(names: &[String]) -> String {
    const MOST: usize = 3;
    let more = if names.len() > MOST { ", ..." } else { "" };
    format!("{}{more}", names[..names.len().min(MOST)].join(", "))
}

/// A row's place as one line.
fn place(row: &Row) -> String {
    let place = Place::of(row);
    let density = place.density.map(|density| density.to_string()).unwrap_or_default();
    let words = [place.experiment, place.workload, place.order, density, place.id];
    words.into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

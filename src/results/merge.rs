//! Several folders into one, by the rules that stand above the module.

use super::machine::{build, identity, labels};
use super::order::order;
use super::part::{Part, Share};
use super::{About, Chapter, Describe, Results, Source};
use crate::chart::stability_figures;
use crate::table::{Row, SETTING_COLUMNS, SUBJECT_COLUMNS};
use serde_json::Value;
use std::collections::HashMap;

/// A source with what was measured on it.
struct Measured {
    environment: Value,
    folders: Vec<String>,
    parts: Vec<Part>,
}

/// Puts the parts of each folder together.
pub(super) fn merge(folders: Vec<Vec<Part>>, describe: Describe<'_>) -> Results {
    let mut measured: Vec<Measured> = Vec::new();
    for run in folders.into_iter().flat_map(runs) {
        match measured.iter_mut().find(|source| source.takes(&run)) {
            Some(source) => source.add(run),
            None => measured.push(Measured::of(run)),
        }
    }
    let environments: Vec<&Value> = measured.iter().map(|source| &source.environment).collect();
    let sources: Vec<Source> = labels(&environments)
        .into_iter()
        .zip(&measured)
        .map(|(label, source)| Source {
            label,
            folders: source.folders.clone(),
            environment: source.environment.clone(),
        })
        .collect();
    let parts: Vec<(usize, Part)> = measured
        .into_iter()
        .enumerate()
        .flat_map(|(source, measured)| measured.parts.into_iter().map(move |part| (source, part)))
        .collect();
    Results { chapters: chapters(parts, &sources, describe), sources, rounds: Vec::new() }
}

/// The parts of a folder that were measured together: on one machine, with one build.
fn runs(parts: Vec<Part>) -> Vec<Vec<Part>> {
    let mut runs: Vec<Vec<Part>> = Vec::new();
    for part in parts {
        match runs.iter_mut().find(|run| run[0].run() == part.run()) {
            Some(run) => run.push(part),
            None => runs.push(vec![part]),
        }
    }
    runs
}

impl Measured {
    fn of(mut run: Vec<Part>) -> Self {
        let mut environment = run.first().map(|part| part.environment.clone()).unwrap_or_default();
        if let Some(fields) = environment.as_object_mut() {
            // Of the file, not of the machine.
            super::files::OF_A_FILE.iter().for_each(|field| drop(fields.remove(*field)));
        }
        let folders = run.iter().take(1).map(|part| part.folder.clone()).collect();
        run.iter_mut().for_each(|part| part.environment = Value::Null);
        Measured { environment, folders, parts: run }
    }

    /// Whether a run is of this source: the same machine, build and experiments, and no other
    /// figure for the same thing.
    fn takes(&self, run: &[Part]) -> bool {
        let same = |of: fn(&Value) -> Option<Value>| {
            let own = of(&self.environment);
            own.is_some() && run.first().is_some_and(|part| of(&part.environment) == own)
        };
        let is_shared = |parts: &[Part]| parts.iter().all(|part| part.share.is_some());
        let is_of_shards = is_shared(&self.parts) && is_shared(run);
        (same(identity) || (is_of_shards && same(build)))
            && run.iter().all(|part| self.agrees(part))
    }

    fn agrees(&self, part: &Part) -> bool {
        let mut known = HashMap::new();
        for other in self.parts.iter().filter(|other| other.experiment == part.experiment) {
            let texts = part.text.as_ref().zip(other.text.as_ref());
            if texts.is_some_and(|(one, other)| one != other) {
                return false;
            }
            known.extend(keyed(&other.rows));
        }
        let differs = |(key, row): &(Key, &Row)| known.get(key).is_some_and(|other| other != row);
        !keyed(&part.rows).iter().any(differs)
    }

    fn add(&mut self, run: Vec<Part>) {
        for part in run {
            if !self.folders.contains(&part.folder) {
                self.folders.push(part.folder.clone());
            }
            self.parts.push(part);
        }
    }
}

/// What a row is about, and how many rows of its file that are about the same stand before it.
type Key = (Vec<String>, usize);

fn keyed(rows: &[Row]) -> Vec<(Key, &Row)> {
    let mut seen: HashMap<Vec<String>, usize> = HashMap::new();
    let key = |row| {
        let mut about = Row::texts(row, &["id"]);
        about.extend(row.texts(&SUBJECT_COLUMNS));
        about.extend(row.texts(&SETTING_COLUMNS));
        let before = seen.entry(about.clone()).or_default();
        *before += 1;
        ((about, *before - 1), row)
    };
    rows.iter().map(key).collect()
}

fn chapters(parts: Vec<(usize, Part)>, sources: &[Source], describe: Describe<'_>) -> Vec<Chapter> {
    let mut ids: Vec<String> = Vec::new();
    for (_, part) in &parts {
        if !ids.contains(&part.experiment) {
            ids.push(part.experiment.clone());
        }
    }
    ids.sort_by(|one, other| order(one).cmp(&order(other)));
    let chapter = |id: &String| {
        let mut of_sources: Vec<Vec<&Part>> = vec![Vec::new(); sources.len()];
        for (source, part) in parts.iter().filter(|(_, part)| part.experiment == *id) {
            of_sources[*source].push(part);
        }
        chapter(id, &of_sources, sources, describe)
    };
    ids.iter().map(chapter).collect()
}

fn chapter(
    id: &str,
    of_sources: &[Vec<&Part>],
    sources: &[Source],
    describe: Describe<'_>,
) -> Chapter {
    let mut rows = Vec::new();
    for (parts, source) in of_sources.iter().zip(sources) {
        let label = if sources.len() > 1 { source.label.as_str() } else { "" };
        rows.extend(in_order(parts).into_iter().map(|row| Row { machine: label.into(), ..row }));
    }
    let parts = || of_sources.iter().flatten();
    let text = parts().find_map(|part| part.text.as_deref());
    let mut about = describe(id, text).unwrap_or_else(|| About::unknown(id));
    if about.figures.is_empty() {
        // Of stiff cases there is to be drawn what there is in the rows; of others there is nothing.
        about.figures = stability_figures(&rows);
    }
    let mut hashes: Vec<&str> = Vec::new();
    for part in parts().filter(|part| !part.workload_hash.is_empty()) {
        if !hashes.contains(&part.workload_hash.as_str()) {
            hashes.push(&part.workload_hash);
        }
    }
    let complete = of_sources.iter().filter(|parts| !parts.is_empty()).all(|parts| is_whole(parts));
    Chapter { workload_hash: hashes.join(", "), about, rows, complete }
}

/// The rows of one source in the order of the unsplit run, each once.
fn in_order(parts: &[&Part]) -> Vec<Row> {
    let mut placed: Vec<(Option<u64>, Key, &Row)> = Vec::new();
    for part in parts {
        let places = part.share.as_ref().map(|share| share.places.as_slice());
        for (index, (key, row)) in keyed(&part.rows).into_iter().enumerate() {
            let place = places.and_then(|places| places.get(index).copied());
            placed.push((place, key, row));
        }
    }
    // Stable, and without a place comes first.
    placed.sort_by_key(|(place, ..)| *place);
    let mut seen = std::collections::HashSet::new();
    let first = |(_, key, row): (Option<u64>, Key, &Row)| seen.insert(key).then(|| row.clone());
    placed.into_iter().filter_map(first).collect()
}

/// Whether an experiment was run to its end, by one part or by all shards together.
fn is_whole(parts: &[&Part]) -> bool {
    let ended = || parts.iter().filter(|part| part.complete);
    let whole = ended().any(|part| part.share.is_none());
    let is_interrupted = parts.iter().any(|part| !part.complete && part.share.is_none());
    (whole && !is_interrupted) || Share::cover(ended().filter_map(|part| part.share.as_ref()))
}

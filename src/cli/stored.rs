//! Rows in files: what is said around them, and rows of several folders in one.

use std::path::Path;

use serde_json::{Value, json};

use super::failure::Failure;
use crate::results::{
    COMPLETE, Chapter, DESCRIPTION, ENVIRONMENT, ROWS, Results, SHARD, SOURCES, TABLE,
};
use crate::shard::Shard;
use crate::stability::EXPERIMENT as STABILITY;
use crate::table::{
    Row, RunFile, SCHEMA_VERSION, make_folder, write_atomically, write_csv, write_json,
};
use crate::workload::hash::Fnv;

/// Says which share of the work a file of rows holds, and where they stand in the whole.
pub fn put_shard(environment: &mut Value, shard: Option<Shard>, places: &[u64]) {
    if let Some(shard) = shard {
        environment[SHARD] = json!({ "part": shard.to_string(), "places": places });
    }
}

/// Hash of what rows are about: of the hashes of their workloads, or in the sweep of stiff cases,
/// where rows have none, of what these are drawn by.
pub fn workload_hash(experiment: &str, rows: &[Row]) -> String {
    let mut hash = Fnv::default();
    for row in rows {
        if experiment == STABILITY {
            hash.bytes(format!("{} {:?} {:?}", row.workload, row.knob, row.cases).as_bytes());
        } else {
            hash.bytes(row.workload_hash.as_bytes());
        }
    }
    format!("{:016x}", hash.finish())
}

/// Writes the rows of results, and what they were measured on, as a run writes its own: what was
/// put together can be read again as one folder.
///
/// # Errors
/// When a file cannot be written.
pub fn write(results: &Results, out: &Path) -> Result<(), Failure> {
    let environment = environment(results);
    let text = serde_json::to_vec_pretty(&environment);
    let text = text.map_err(|error| Failure::Runtime(error.into()))?;
    make_folder(out)?;
    write_atomically(&out.join(ENVIRONMENT), &text)?;
    for chapter in &results.chapters {
        let folder = out.join(&chapter.about.id);
        make_folder(&folder)?;
        write_csv(&folder.join(TABLE), &chapter.rows)?;
        write_json(&folder.join(ROWS), &run_file(chapter, &environment))?;
        if let Some(text) = description(results, &chapter.about.id) {
            write_atomically(&folder.join(DESCRIPTION), &text)?;
        }
    }
    Ok(())
}

/// The text of an experiment from the first folder that has it.
fn description(results: &Results, id: &str) -> Option<Vec<u8>> {
    let folders = results.sources.iter().flat_map(|source| &source.folders).map(Path::new);
    // A folder is that of a run, or that of the experiment itself.
    let files = folders.flat_map(|folder| {
        let own = folder.canonicalize().ok().filter(|own| own.ends_with(id));
        own.map(|own| own.join(DESCRIPTION)).into_iter().chain([folder.join(id).join(DESCRIPTION)])
    });
    files.filter_map(|file| std::fs::read(file).ok()).next()
}

/// That of the only source, or a list of all.
fn environment(results: &Results) -> Value {
    if let [only] = results.sources.as_slice()
        && only.environment.is_object()
    {
        return only.environment.clone();
    }
    let sources = results.sources.iter().map(|source| {
        json!({
            "label": source.label,
            "folders": source.folders,
            "environment": source.environment,
        })
    });
    json!({ SOURCES: sources.collect::<Vec<Value>>() })
}

fn run_file(chapter: &Chapter, environment: &Value) -> RunFile {
    let mut environment = environment.clone();
    environment[COMPLETE] = json!(chapter.complete);
    RunFile {
        schema_version: SCHEMA_VERSION.to_owned(),
        environment,
        // The smallest: where there are several, it is the experiment's, which the others follow.
        seed: chapter.rows.iter().filter_map(|row| row.seed).min().unwrap_or(0),
        workload_hash: workload_hash(&chapter.about.id, &chapter.rows),
        rows: chapter.rows.clone(),
    }
}

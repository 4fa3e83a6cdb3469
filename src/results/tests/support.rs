//! Folders of results for the tests.

use crate::results::{About, LoadError, Results, load};
use crate::table::{Row, RunFile, SCHEMA_VERSION, write_csv, write_json};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder that is removed when the test ends.
pub struct Place(pub PathBuf);

impl Place {
    pub fn new() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("ray_test-results-{}-{number}", std::process::id());
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).expect("a folder for temporary files");
        Place(path)
    }

    /// Writes an experiment of a run, with what its file says besides.
    pub fn run(&self, run: &str, environment: &Value, id: &str, rows: &[Row], more: Value) {
        let folder = self.0.join(run);
        fs::create_dir_all(folder.join(id)).expect("ours");
        fs::write(folder.join("environment.json"), environment.to_string()).expect("ours");
        let mut environment = environment.clone();
        for (field, value) in more.as_object().expect("fields") {
            environment[field] = value.clone();
        }
        let file = RunFile {
            schema_version: SCHEMA_VERSION.into(),
            environment,
            seed: 1,
            workload_hash: format!("hash of {id}"),
            rows: rows.to_vec(),
        };
        write_json(&folder.join(id).join("rows.json"), &file).expect("ours");
    }

    pub fn load(&self, runs: &[&str]) -> Result<Results, LoadError> {
        let folders: Vec<PathBuf> = runs.iter().map(|run| self.0.join(run)).collect();
        load(&folders, &describe)
    }

    /// The bytes of a table of these rows.
    pub fn csv(&self, rows: &[Row]) -> Vec<u8> {
        let file = self.0.join("table.csv");
        write_csv(&file, rows).expect("ours");
        fs::read(file).expect("it was written")
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Knows the text that is beside the rows, and otherwise nothing.
pub fn describe(id: &str, text: Option<&str>) -> Option<About> {
    text.map(|text| About { id: id.into(), title: text.into(), ..About::default() })
}

pub fn environment(processor: &str, opt_level: &str) -> Value {
    json!({
        "testbed_id": format!("id of {processor}"),
        "machine": { "processor": processor },
        "build": { "target": "x86_64", "opt_level": opt_level },
        "date": "2026-01-01T00:00:00Z",
    })
}

/// What the file of a run says that was run to its end.
pub fn ended() -> Value {
    json!({ "complete": true })
}

/// A row that was timed.
pub fn timed(id: &str, density: f64, ns: f64) -> Row {
    Row {
        experiment: "b-4.2".into(),
        id: id.into(),
        order: "literal".into(),
        density: Some(density),
        status: "ok".into(),
        ns_per_test: Some(ns),
        ..Row::default()
    }
}

/// A row without a clock.
pub fn exact(id: &str, seed: u64, error: f64) -> Row {
    Row {
        experiment: "h-11".into(),
        id: id.into(),
        workload: "errors-random".into(),
        seed: Some(seed),
        status: "ok".into(),
        err_tuv_mean_rel: Some(error),
        ..Row::default()
    }
}

/// A file of text below a place.
pub fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("in a folder")).expect("ours");
    fs::write(path, text).expect("ours");
}

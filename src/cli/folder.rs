//! Where results go, and the experiments that are compiled in.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::failure::Failure;
use crate::chart::{Published, draw};
use crate::experiment::{Experiment, Outcome, Plan};
use crate::measure::{Environment, now_rfc3339};
use crate::table::{RunFile, SCHEMA_VERSION, read_json, write_atomically, write_csv, write_json};
use crate::workload::hash::Fnv;

/// The experiments under `configs/`, as file name and text; made by the build script.
mod embedded {
    include!(concat!(env!("OUT_DIR"), "/configs.rs"));
}

/// An experiment's file name and text.
pub type Source = (String, String);

/// The files that are compiled in.
pub fn built_in_sources() -> Vec<Source> {
    let owned = |(name, text): &(&str, &str)| (format!("configs/{name}"), (*text).to_owned());
    embedded::CONFIGS.iter().map(owned).collect()
}

/// The experiments that are compiled in, with their files.
///
/// # Errors
/// None, unless a file was compiled in that no test has read.
pub fn built_in() -> Result<Vec<(String, Experiment)>, Failure> {
    let parse = |(name, text): Source| Ok((name.clone(), Experiment::parse(&name, &text)?));
    built_in_sources().into_iter().map(parse).collect()
}

/// The folder of one run.
pub struct Folder {
    path: PathBuf,
    environment: Environment,
    /// Tells runs of other files, profiles and filters apart.
    config_hash: u64,
}

impl Folder {
    /// The folder; nothing is written yet.
    pub fn new(out: Option<&Path>, config_hash: u64, environment: Environment) -> Self {
        let default = || {
            let time = now_rfc3339().replace([':', '-'], "");
            PathBuf::from("results").join(format!("{time}-{:08x}", config_hash as u32))
        };
        let path = out.map_or_else(default, Path::to_path_buf);
        Folder { path, environment, config_hash }
    }

    /// Creates it and finds out whether it can be written, before anything runs.
    ///
    /// # Errors
    /// Usage, if it cannot be created or written to.
    pub fn create(&self) -> Result<(), Failure> {
        let folder = self;
        let refused = |error: &dyn std::fmt::Display| {
            Failure::Usage(format!(
                "--out: {} cannot be written: {error}; allowed: a folder that can be created or \
                 written",
                folder.path.display()
            ))
        };
        std::fs::create_dir_all(&folder.path).map_err(|error| refused(&error))?;
        let json = serde_json::to_vec_pretty(&folder.environment)
            .map_err(|error| Failure::Runtime(error.into()))?;
        write_atomically(&folder.path.join("environment.json"), &json)
            .map_err(|error| refused(&error))
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// If an experiment was finished in this folder before: the variants that were wrong in it.
    ///
    /// # Errors
    /// Usage, if it was finished with another configuration, build or machine.
    pub fn finished(&self, id: &str) -> Result<Option<Vec<String>>, Failure> {
        let file = self.path.join(id).join("rows.json");
        let Ok(run) = read_json(&file) else { return Ok(None) };
        let hash = run.environment.get(CONFIG_HASH).and_then(Value::as_str).unwrap_or("");
        if hash != self.hash_text() {
            return Err(Failure::Usage(format!(
                "--resume: {} was made with another {CONFIG_HASH} ({hash}, now {}); allowed: the \
                 same experiments, --profile, --filter, build and machine, or another --out",
                file.display(),
                self.hash_text()
            )));
        }
        if run.environment.get(COMPLETE).and_then(Value::as_bool) != Some(true) {
            return Ok(None);
        }
        let mut wrong: Vec<String> = Vec::new();
        for row in run.rows.iter().filter(|row| row.status == "wrong-result") {
            if !wrong.contains(&row.id) {
                wrong.push(row.id.clone());
            }
        }
        Ok(Some(wrong))
    }

    fn hash_text(&self) -> String {
        format!("{:016x}", self.config_hash)
    }

    /// Writes rows and figures of an experiment; returns the figures' paths.
    ///
    /// # Errors
    /// When a file cannot be written or a figure not be drawn.
    pub fn save(&self, plan: &Plan, outcome: &Outcome) -> Result<Vec<PathBuf>, Failure> {
        let folder = self.path.join(&plan.experiment.id);
        std::fs::create_dir_all(&folder)?;
        write_csv(&folder.join("rows.csv"), &outcome.rows)?;
        let published = Published::embedded().map_err(|error| Failure::Runtime(error.into()))?;
        let mut figures = Vec::new();
        for figure in &plan.experiment.figure {
            let svg = draw(figure, &outcome.rows, &published)
                .map_err(|error| Failure::Runtime(error.into()))?;
            let file = folder.join(format!("{}.svg", figure.file));
            write_atomically(&file, svg.as_bytes())?;
            figures.push(file);
        }
        // Last: it says that the experiment is complete.
        write_json(&folder.join("rows.json"), &self.run_file(plan, outcome)?)?;
        Ok(figures)
    }

    fn run_file(&self, plan: &Plan, outcome: &Outcome) -> Result<RunFile, Failure> {
        let mut environment = serde_json::to_value(&self.environment)
            .map_err(|error| Failure::Runtime(error.into()))?;
        environment[CONFIG_HASH] = json!(self.hash_text());
        environment[COMPLETE] = json!(!outcome.interrupted);
        let mut hash = Fnv::default();
        for row in &outcome.rows {
            hash.bytes(row.workload_hash.as_bytes());
        }
        Ok(RunFile {
            schema_version: SCHEMA_VERSION.to_owned(),
            environment,
            seed: plan.experiment.seed,
            workload_hash: format!("{:016x}", hash.finish()),
            rows: outcome.rows.clone(),
        })
    }
}

const CONFIG_HASH: &str = "config_hash";
const COMPLETE: &str = "complete";

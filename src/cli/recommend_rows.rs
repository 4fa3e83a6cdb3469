//! The rows that a recommendation starts from.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::failure::Failure;
use super::publish::read as read_folders;
use crate::results::{ENVIRONMENT, ROWS, Results};

/// Where runs lie by default.
const RUNS: &str = "results";

/// The rows of these folders, or of the newest run.
///
/// # Errors
/// Usage for a folder that cannot be read or holds no rows, and where there is no run.
pub fn read(folders: &[PathBuf]) -> Result<Results, Failure> {
    let newest = if folders.is_empty() { vec![newest_run(Path::new(RUNS))?] } else { Vec::new() };
    let folders: Vec<PathBuf> = folders.iter().chain(&newest).cloned().collect();
    read_folders(&folders).map_err(|error| {
        Failure::Usage(format!(
            "--from: {error} (`ray_test reproduce --out DIR` makes such a folder)"
        ))
    })
}

/// Whether a folder is that of a run: it has a folder with rows.
fn is_run(folder: &Path) -> bool {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    entries.into_iter().any(|entry| entry.path().join(ROWS).is_file())
}

/// When it was measured, as text that sorts; empty if it does not say.
fn date(folder: &Path) -> String {
    let text = std::fs::read_to_string(folder.join(ENVIRONMENT)).unwrap_or_default();
    let environment: Value = serde_json::from_str(&text).unwrap_or_default();
    environment.get("date").and_then(Value::as_str).unwrap_or_default().to_owned()
}

/// The run with the latest date in its `environment.json`; among equals the last by name.
fn newest_run(runs: &Path) -> Result<PathBuf, Failure> {
    let entries = std::fs::read_dir(runs).into_iter().flatten().flatten();
    let folders = entries.map(|entry| entry.path()).filter(|folder| is_run(folder));
    folders.max_by_key(|folder| (date(folder), folder.clone())).ok_or_else(|| {
        Failure::Usage(format!(
            "there is no run under {}/ to recommend by; allowed: `ray_test reproduce` first (about \
             two minutes), or --from with the folder of a run",
            runs.display()
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::{Row, RunFile, SCHEMA_VERSION, write_json};
    use serde_json::json;

    fn write(folder: &Path, date: &str, experiment: &str) {
        let path = folder.join(experiment);
        std::fs::create_dir_all(&path).expect("a folder for a test");
        let run = RunFile {
            schema_version: SCHEMA_VERSION.to_owned(),
            environment: json!({ "complete": true }),
            seed: 1,
            workload_hash: "0".into(),
            rows: vec![Row { id: experiment.into(), ..Row::default() }],
        };
        write_json(&path.join(ROWS), &run).expect("a file for a test");
        let environment = json!({ "date": date }).to_string();
        std::fs::write(folder.join("environment.json"), environment).expect("a file for a test");
    }

    #[test]
    fn the_newest_run_is_the_one_with_the_latest_date() {
        let runs = std::env::temp_dir().join(format!("ray_test-newest-{}", std::process::id()));
        assert!(newest_run(&runs).is_err());
        write(&runs.join("z"), "2026-01-01T00:00:00Z", "h-4");
        write(&runs.join("a"), "2026-02-01T00:00:00Z", "h-4");
        write(&runs.join("a"), "2026-02-01T00:00:00Z", "b-4.1");
        std::fs::create_dir_all(runs.join("empty")).expect("a folder for a test");
        let newest = newest_run(&runs).ok();
        let results = read(&[runs.join("a")]).ok();
        let no_rows = read(&[runs.join("empty")]).is_err();
        let one = read(&[runs.join("z").join("h-4")]).ok();
        std::fs::remove_dir_all(&runs).ok();
        assert_eq!(newest, Some(runs.join("a")));
        let ids = |results: Option<Results>| {
            let results = results.expect("it has rows");
            results.chapters.into_iter().map(|chapter| chapter.about.id).collect::<Vec<_>>()
        };
        assert_eq!(ids(results), ["b-4.1", "h-4"]);
        assert_eq!(ids(one), ["h-4"]);
        assert!(no_rows);
    }
}

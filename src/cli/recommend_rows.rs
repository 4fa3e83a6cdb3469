//! The rows that a recommendation starts from.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::failure::Failure;
use crate::results::{About, Chapter, Results, Source};
use crate::table::read_json;

/// Where runs lie by default.
const RUNS: &str = "results";
const ROWS: &str = "rows.json";

/// The rows of these folders, or of the newest run.
///
/// # Errors
/// Usage for a folder that cannot be read or holds no rows, and where there is no run.
pub fn read(folders: &[PathBuf]) -> Result<Results, Failure> {
    let newest = if folders.is_empty() { vec![newest_run(Path::new(RUNS))?] } else { Vec::new() };
    let mut results = Results::default();
    for folder in folders.iter().chain(&newest) {
        let files = rows_files(folder).map_err(|error| refused(folder, &error.to_string()))?;
        if files.is_empty() {
            return Err(refused(folder, "there are no rows"));
        }
        for file in files {
            results.chapters.push(chapter(&file)?);
        }
        let (label, folders) = (String::new(), vec![folder.display().to_string()]);
        results.sources.push(Source { label, folders, environment: environment(folder) });
    }
    Ok(results)
}

fn refused(folder: &Path, why: &str) -> Failure {
    Failure::Usage(format!(
        "--from: {}: {why}; allowed: the folder of a run (`ray_test reproduce --out DIR`)",
        folder.display()
    ))
}

/// The files of rows in a folder, one for each experiment, by name; that of one experiment is a
/// folder, too.
fn rows_files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let own = folder.join(ROWS);
    if own.is_file() {
        return Ok(vec![own]);
    }
    let entries = std::fs::read_dir(folder)?.flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path().join(ROWS)).collect();
    files.retain(|file| file.is_file());
    files.sort();
    Ok(files)
}

fn chapter(file: &Path) -> Result<Chapter, Failure> {
    let run = read_json(file).map_err(|error| Failure::Usage(format!("--from: {error}")))?;
    let folder = file.parent().and_then(Path::file_name);
    let about = About {
        id: folder.map(|name| name.to_string_lossy().into_owned()).unwrap_or_default(),
        title: String::new(),
        mirrors: String::new(),
        question: String::new(),
        why: String::new(),
        config: String::new(),
        command: String::new(),
        claims: Vec::new(),
        figures: Vec::new(),
    };
    let complete = run.environment.get("complete").and_then(Value::as_bool) == Some(true);
    Ok(Chapter { about, rows: run.rows, complete, workload_hash: run.workload_hash })
}

fn environment(folder: &Path) -> Value {
    let text = std::fs::read_to_string(folder.join("environment.json"));
    text.ok().and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
}

/// The run with the latest date in its `environment.json`; among equals the last by name.
fn newest_run(runs: &Path) -> Result<PathBuf, Failure> {
    let entries = std::fs::read_dir(runs).into_iter().flatten().flatten();
    let has_rows = |folder: &PathBuf| rows_files(folder).is_ok_and(|files| !files.is_empty());
    let date = |folder: &PathBuf| {
        environment(folder).get("date").and_then(Value::as_str).unwrap_or_default().to_owned()
    };
    let folders = entries.map(|entry| entry.path()).filter(has_rows);
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

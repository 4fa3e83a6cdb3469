//! Tests of the waist: what is written comes back, what is wrong is named.

use super::*;
use std::fs;

/// A folder of its own, removed when the test ends.
pub(super) struct Folder(PathBuf);

impl Folder {
    pub(super) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("ray_test-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    pub(super) fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).ok();
    }
}

fn rows() -> Vec<Row> {
    let odd = Row {
        experiment: "b-4.1".into(),
        kernel: "with \"quotes\", commas\nand a line".into(),
        density: Some(0.1 + 0.2),
        ns_per_test: Some(f64::MIN_POSITIVE),
        ns_high: Some(f64::MAX),
        price_low: Some(-1.0 / 3.0),
        err_t_mean_rel: Some(1.2345678901234567e-14),
        seed: Some(u64::MAX),
        code: Some(0),
        workload_hash: "f00d".into(),
        ..Row::default()
    };
    // Of a row that says what it is about, JSON has only what is there.
    let sparse = Row { record: "cases".into(), knob: Some(3.0), ..Row::default() };
    vec![odd, Row::default(), sparse]
}

fn run_file(rows: Vec<Row>) -> RunFile {
    let environment = serde_json::json!({ "processor": "test", "cores": 2 });
    let schema_version = SCHEMA_VERSION.to_owned();
    RunFile { schema_version, environment, seed: 7, workload_hash: "beef".into(), rows }
}

#[test]
fn the_header_is_the_contracts() {
    let folder = Folder::new("header");
    write_csv(&folder.file("rows.csv"), &[]).unwrap();
    let contract = "experiment,kernel,precision,drive,level,exit,division,rounding,output,layout,\
        workload,order,density,triangles,rays,tests,hits,status,ns_per_test,ns_low,ns_high,min_ns,\
        mtests_per_s,cycles_per_test,rounds,dirty_rounds,ratio_to_reference,ratio_low,ratio_high,\
        instructions_per_test,mispredicts_per_test,bytes_per_triangle,ops_add,ops_sub,ops_neg,\
        ops_mul,ops_div,ops_condition,code,false_hits,false_misses,nan_outputs,err_t_mean_rel,\
        err_t_p999_ulp,err_t_max_ulp,err_u_max_abs,err_v_max_abs,seed";
    let text = fs::read_to_string(folder.file("rows.csv")).unwrap();
    // Ours follow.
    assert!(text.starts_with(&format!("{contract},id,")) && text.ends_with('\n'), "{text}");
    assert_eq!(contract.split(',').count(), REQUIRED);
}

#[test]
fn csv_comes_back_bit_for_bit() {
    let folder = Folder::new("csv");
    write_csv(&folder.file("rows.csv"), &rows()).unwrap();
    assert_eq!(read_csv(&folder.file("rows.csv")).unwrap(), rows());
}

#[test]
fn json_comes_back_bit_for_bit() {
    let folder = Folder::new("json");
    let run = run_file(rows());
    write_json(&folder.file("rows.json"), &run).unwrap();
    let read = read_json(&folder.file("rows.json")).unwrap();
    assert_eq!(
        (&read.environment, read.seed, &read.workload_hash, &read.schema_version),
        (&run.environment, run.seed, &run.workload_hash, &run.schema_version)
    );
    assert_eq!(read.rows, run.rows);
}

#[test]
fn what_is_not_finite_is_written_as_missing() {
    let folder = Folder::new("finite");
    let bad = Row { ns_low: Some(f64::NAN), ns_high: Some(f64::INFINITY), ..Row::default() };
    write_csv(&folder.file("rows.csv"), std::slice::from_ref(&bad)).unwrap();
    write_json(&folder.file("rows.json"), &run_file(vec![bad])).unwrap();
    assert_eq!(read_csv(&folder.file("rows.csv")).unwrap(), [Row::default()]);
    assert_eq!(read_json(&folder.file("rows.json")).unwrap().rows, [Row::default()]);
    let text = fs::read_to_string(folder.file("rows.csv")).unwrap();
    assert_eq!(text.lines().nth(1), Some(",".repeat(COLUMNS.len() - 1).as_str()));
}

#[test]
fn a_bad_cell_is_named_with_what_is_allowed() {
    let folder = Folder::new("bad-cell");
    let path = folder.file("rows.csv");
    for (column, bad) in [
        ("density", "NaN"),
        ("density", "half"),
        ("rounds", "-1"),
        ("ns_per_test", "-1"),
        ("ratio_low", "-1e-300"),
        ("price", "inf"),
    ] {
        let row: Vec<_> =
            COLUMNS.iter().map(|name| if *name == column { bad } else { "" }).collect();
        let good = ",".repeat(COLUMNS.len() - 1);
        fs::write(&path, format!("{}\n{good}\n{}\n", COLUMNS.join(","), row.join(","))).unwrap();
        let message = read_csv(&path).unwrap_err().to_string();
        for part in ["rows.csv", "line 3", column, bad, "allowed: a "] {
            assert!(message.contains(part), "'{part}' is not in: {message}");
        }
    }
    let mut json = serde_json::to_value(run_file(vec![Row::default()])).unwrap();
    json["rows"][0]["hits"] = serde_json::json!(1.5);
    fs::write(&path, json.to_string()).unwrap();
    let message = read_json(&path).unwrap_err().to_string();
    assert!(message.contains("row 1, column 'hits': '1.5' is not allowed"), "{message}");
    json["rows"][0]["hits"] = serde_json::json!(null);
    json["rows"][0]["ns_per_test"] = serde_json::json!(-1.0);
    fs::write(&path, json.to_string()).unwrap();
    let message = read_json(&path).unwrap_err().to_string();
    let place = "row 1, column 'ns_per_test': '-1.0' is not allowed";
    assert!(message.contains(place) && message.contains("not negative"), "{message}");
}

#[test]
fn what_can_be_negative_is_read_and_nothing_else() {
    let takes = |column: &str, text: &str| Row::default().set(column, text).is_ok();
    let numbers = COLUMNS.iter().copied().filter(|column| !takes(column, "word"));
    let (signed, others): (Vec<&str>, Vec<&str>) = numbers.partition(|name| takes(name, "-1"));
    // Differences of times, exponents, and settings that are drawn on an axis.
    let expected = [
        "cycles_per_test",
        "percent_slower",
        "price",
        "price_low",
        "price_high",
        "cycles_low",
        "cycles_high",
        "knob",
        "knee",
        "growth",
        "intersection_percent",
    ];
    assert_eq!(signed, expected);
    assert!(others.iter().all(|name| takes(name, "0") && takes(name, "1") && takes(name, "")));
}

#[test]
fn unknown_columns_are_ignored_and_missing_ones_refused() {
    let folder = Folder::new("columns");
    let path = folder.file("rows.csv");
    let contract = COLUMNS[..REQUIRED].join(",");
    fs::write(&path, format!("{contract},from_the_future\nb-4.1{},x\n", ",".repeat(REQUIRED - 1)))
        .unwrap();
    let expected = Row { experiment: "b-4.1".into(), ..Row::default() };
    assert_eq!(read_csv(&path).unwrap(), [expected]);
    for column in &COLUMNS[..REQUIRED] {
        let fewer: Vec<_> = COLUMNS.iter().filter(|name| *name != column).copied().collect();
        fs::write(&path, format!("{}\n", fewer.join(","))).unwrap();
        let message = read_csv(&path).unwrap_err().to_string();
        assert!(message.contains(&format!("column '{column}' is missing")), "{message}");
    }
}

#[test]
fn a_later_schema_and_broken_text_are_refused() {
    let folder = Folder::new("schema");
    let path = folder.file("rows.json");
    let later = RunFile { schema_version: "2.0".into(), ..run_file(vec![]) };
    write_json(&path, &later).unwrap();
    assert!(matches!(read_json(&path), Err(TableError::Schema { .. })));
    fs::write(&path, "{\n\"rows\": [\n").unwrap();
    assert!(matches!(read_json(&path), Err(TableError::Syntax { line: 3, .. })));
    assert!(matches!(read_csv(&folder.file("none.csv")), Err(TableError::Io { .. })));
}

#[test]
fn a_failed_write_leaves_the_old_and_no_partial_file() {
    let folder = Folder::new("atomic");
    // A file cannot be renamed onto a folder that is not empty: the last step fails.
    let target = folder.file("rows.csv");
    fs::create_dir(&target).unwrap();
    fs::write(target.join("kept"), "old").unwrap();
    assert!(write_csv(&target, &rows()).is_err());
    let names: Vec<_> = fs::read_dir(&folder.0).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(names, ["rows.csv"]);
    assert_eq!(fs::read_to_string(target.join("kept")).unwrap(), "old");
    assert!(write_atomically(&folder.file("no-such-folder/rows.csv"), b"x").is_err());
    assert!(!folder.file("no-such-folder").exists());
}

#[test]
fn a_second_write_replaces_the_first() {
    let folder = Folder::new("replace");
    let path = folder.file("note");
    write_atomically(&path, b"a long first text").unwrap();
    write_atomically(&path, b"second").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"second");
    assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 1);
}

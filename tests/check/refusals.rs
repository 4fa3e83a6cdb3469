//! Bad input and wrong words: exit 2, where, and what is allowed.

use super::support::{File, HEADER, check, rows, said};

const GOOD: &str = "1,1,2,0,0,-1,0,0,0,4,0,0,0,4,0";
const ONE_KERNEL: [&str; 5] = ["--kernels", "wald", "--precision", "f32", "--format"];

fn with(file: &str, format: &'static str) -> Vec<String> {
    let words = [file].into_iter().chain(ONE_KERNEL).chain([format]);
    words.map(str::to_owned).collect()
}

fn refused(words: &[&str], input: &str, parts: &[&str]) {
    let output = check(words, input);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    for part in parts {
        assert!(said.contains(part), "no '{part}' in: {said}");
    }
    assert!(!said.contains("panicked"), "{said}");
}

#[test]
fn nothing_is_refused_without_output() {
    for text in ["", "\n\n", HEADER] {
        let output = check(&["-", "--format", "json"], text);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{text}");
        assert!(said(&output).contains("stdin: no case"), "{}", said(&output));
    }
    refused(&["/no/such/file"], "", &["/no/such/file"]);
    refused(&["/"], "", &["a folder"]);
    refused(&[], "", &["<FILE>"]);
}

#[test]
fn wrong_rows_are_named_by_file_line_and_column() {
    let file = File::new("rows", &format!("{HEADER}\n{GOOD}\n1,1,2,0,0,-1,0,0,zero,4,0,0,0,4,0\n"));
    refused(&[file.path()], "", &[file.path(), "line 3", "column 9 (az)", "'zero'", "a number"]);
    let fourteen = GOOD.rsplit_once(',').expect("it has commas").0;
    let text = format!("{HEADER}\n{fourteen}\n");
    refused(&["-"], &text, &["stdin, line 2", "column 15", "14 values", "15"]);
    let header = HEADER.replace("dx,", "");
    refused(&["-"], &format!("{header}\n{fourteen}\n"), &["line 1", "missing columns: dx"]);
    let text = format!("{HEADER},t_max\n{GOOD},1\n");
    refused(&["-"], &text, &["line 1, column 16", "'t_max'", "Did you mean 'tmax'?"]);
    let text = format!("{HEADER},cz\n{GOOD},1\n");
    refused(&["-"], &text, &["line 1, column 16", "'cz' stands there twice"]);
    refused(&["-"], "{\"ox\": 1}\n", &["line 1", "missing fields: oy, oz"]);
}

#[test]
fn rows_before_a_bad_line_are_printed_whole() {
    let text = format!("{HEADER}\n{GOOD}\n{GOOD}\n{GOOD},1\n{GOOD}\n");
    let words = with("-", "csv");
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let output = check(&words, &text);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("line 4"));
    let ids: Vec<String> = rows(&output).iter().map(|row| row.cell("id").to_owned()).collect();
    assert_eq!(ids, ["1", "2"]);
    let words = with("-", "json");
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let output = check(&words, &text);
    assert_eq!(output.status.code(), Some(2));
    let array: serde_json::Value =
        serde_json::from_slice(&output.stdout).expect("the array is closed");
    assert_eq!(array.as_array().map(Vec::len), Some(2));
}

#[test]
fn formats_say_the_same() {
    // An id with what CSV and JSON have to quote.
    let text = format!("id,{HEADER}\n\"a,\"\"b\\\",{GOOD}\n");
    let csv = rows(&check(&["-", "--format", "csv"], &text));
    let json = check(&["-", "--format", "json"], &text);
    let array: Vec<serde_json::Map<String, serde_json::Value>> =
        serde_json::from_slice(&json.stdout).expect("it is an array of objects");
    assert_eq!(array.len(), csv.len());
    assert_eq!(csv[0].cell("id"), "a,\"b\\");
    for (object, row) in array.iter().zip(&csv) {
        for (name, value) in object {
            let cell = row.cell(name);
            match value {
                serde_json::Value::Null => assert_eq!(cell, "", "{name}"),
                serde_json::Value::String(text) => assert_eq!(cell, text, "{name}"),
                serde_json::Value::Bool(flag) => assert_eq!(cell, flag.to_string(), "{name}"),
                other => assert_eq!(cell.parse().ok(), other.as_f64(), "{name}"),
            }
        }
    }
    let object = r#"{"id":"a,\"b\\","ox":1,"oy":1,"oz":2,"dx":0,"dy":0,"dz":-1,"ax":0,"ay":0,"az":0,"bx":4,"by":0,"bz":0,"cx":0,"cy":4,"cz":0}"#;
    assert_eq!(check(&["-", "--format", "json"], object).stdout, json.stdout);
    // To read: a line for each row, and a summary on stderr.
    let read = check(&["-"], &text);
    assert_eq!(String::from_utf8_lossy(&read.stdout).lines().count(), csv.len() + 1);
    assert_eq!(said(&read).lines().count(), csv.len() + 1);
}

#[test]
fn kernels_and_precisions_are_chosen_by_words() {
    let text = format!("{HEADER}\n{GOOD}\n");
    let form = "wald/f64/single/avx2/early/first/fused/tuv";
    let output = check(&["-", "--kernels", &format!("keidy,{form}"), "--format", "csv"], &text);
    let found: Vec<(String, String)> = rows(&output)
        .iter()
        .map(|row| (row.cell("kernel").to_owned(), row.cell("precision").to_owned()))
        .collect();
    if cfg!(any(target_arch = "x86", target_arch = "x86_64")) {
        let pair = |kernel: &str, precision: &str| (kernel.to_owned(), precision.to_owned());
        assert_eq!(found, [pair("keidy", "f32"), pair("keidy", "f64"), pair(form, "f64")]);
        let wrong = ["-", "--kernels", form, "--precision", "f32"];
        refused(&wrong, &text, &["no form in that precision", "--precision f64"]);
        let slip = form.replace("fused", "fussed");
        let meant = format!("Did you mean '{form}'?");
        refused(&["-", "--kernels", &slip], &text, &[&meant]);
    }
    let one = check(&["-", "--precision", "f64", "--kernels", "wald", "--format", "csv"], &text);
    assert_eq!(rows(&one).len(), 1);
    refused(&["-", "--kernels", "walt"], &text, &["'walt'", "Did you mean 'wald'?"]);
    refused(&["-", "--kernels", "wald,wald"], &text, &["'wald' stands there twice"]);
    refused(&["-", "--precision", "f16"], &text, &["f32", "f64"]);
    refused(&["-", "--kernels", "wald", "--answers", "x"], &text, &["--answers"]);
}

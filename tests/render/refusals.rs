//! What is refused, before anything runs.

use super::support::{Folder, said};

fn refused(folder: &Folder, words: &[&str], parts: &[&str]) {
    let before = folder.names();
    let output = folder.render(words);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{words:?}: {said}");
    for part in parts {
        assert!(said.contains(part), "no '{part}' in: {said}");
    }
    assert!(!said.contains("panicked"), "{said}");
    assert!(output.stdout.is_empty());
    assert_eq!(folder.names(), before);
}

#[test]
fn unknown_words_are_named_with_what_is_allowed() {
    let folder = Folder::new("words");
    let with = |words: &[&'static str]| [&["icosphere:0"], words].concat();
    refused(&folder, &with(&["--kernel", "wold"]), &["--kernel: 'wold'", "Did you mean 'wald'?"]);
    let in_f64 = "wald/f64/single/sse2/early/last/plain/tuv";
    refused(&folder, &with(&["--kernel", in_f64]), &[in_f64, "in f32"]);
    refused(&folder, &with(&["--kernel", "wald,wald"]), &["stands there twice"]);
    refused(&folder, &with(&["--structure", "tree"]), &["'tree'", "kd-tree"]);
    refused(&folder, &["icospher:2"], &["icospher:2", "Did you mean 'icosphere'?"]);
    refused(&folder, &["icosphere:99"], &["icosphere:99", "allowed behind the colon"]);
    refused(&folder, &["nothing.obj"], &["nothing.obj"]);
}

#[test]
fn sizes_and_numbers_out_of_range_are_refused() {
    let folder = Folder::new("numbers");
    for size in ["400", "0x10", "10x0", "-1x5", "16385x1", "axb", "1x2x3"] {
        let word = format!("--size={size}");
        refused(&folder, &["icosphere:0", &word], &["1 to 16384"]);
    }
    refused(&folder, &["icosphere:0", "--tolerance", "1.5"], &["a number from 0 to 1"]);
    refused(&folder, &["icosphere:0", "--tolerance", "nan"], &["a number from 0 to 1"]);
    refused(&folder, &["icosphere:0", "--frames", "0"], &["1..=100000"]);
    refused(&folder, &["icosphere:0", "--grid", "0x4"], &["1 to 16384"]);
}

#[test]
fn files_that_cannot_be_written_are_found_out_first() {
    let folder = Folder::new("files");
    refused(&folder, &["icosphere:0", "-o", "picture.jpg"], &["picture.jpg", ".png"]);
    refused(&folder, &["icosphere:0", "-o", "no/such/folder.png"], &["no/such/folder.png"]);
    folder.write("file", "");
    refused(&folder, &["icosphere:0", "-o", "file/under.png"], &["file/under.png"]);
}

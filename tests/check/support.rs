//! Cases as text, and the program run on them.

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// The columns that must be there.
pub const HEADER: &str = "ox,oy,oz,dx,dy,dz,ax,ay,az,bx,by,bz,cx,cy,cz";

/// A file that is removed when the test ends.
pub struct File(pub PathBuf);

impl File {
    /// `name` must be unique among the tests.
    pub fn new(name: &str, text: &str) -> Self {
        let path =
            std::env::temp_dir().join(format!("ray_test-check-{}-{name}", std::process::id()));
        fs::write(&path, text).expect("the folder for temporary files can be written");
        File(path)
    }

    /// Its path as an argument.
    pub fn path(&self) -> &str {
        self.0.to_str().expect("the folder for temporary files has a name in UTF-8")
    }
}

impl Drop for File {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

/// Runs `ray_test check` with these words, `input` at its stdin.
pub fn check(words: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_ray_test"))
        .arg("check")
        .args(words)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program was built for this test");
    // It may end before it has read everything, and the output must not fill up meanwhile.
    let mut stdin = child.stdin.take().expect("it is a pipe");
    let input = input.to_owned();
    let writer = std::thread::spawn(move || drop(stdin.write_all(input.as_bytes())));
    let output = child.wait_with_output().expect("it ran");
    writer.join().expect("writing does not panic");
    output
}

/// What it says on stderr.
pub fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// One row of CSV.
pub struct Row(Vec<String>, csv::StringRecord);

impl Row {
    /// The cell of a column.
    pub fn cell(&self, column: &str) -> &str {
        let place = self.0.iter().position(|name| name == column);
        &self.1[place.unwrap_or_else(|| panic!("no column {column}"))]
    }

    /// The cell as a number.
    pub fn number(&self, column: &str) -> f64 {
        let cell = self.cell(column);
        cell.parse().unwrap_or_else(|_| panic!("{column}: '{cell}' is no number"))
    }
}

/// The rows of a run that printed CSV.
pub fn rows(output: &Output) -> Vec<Row> {
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let names: Vec<String> =
        reader.headers().expect("it is CSV").iter().map(str::to_owned).collect();
    reader.records().map(|record| Row(names.clone(), record.expect("it is CSV"))).collect()
}

//! The program, in a folder of its own.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A folder that is removed when the test ends.
pub struct Folder(PathBuf);

impl Folder {
    /// `name` must be unique among the tests.
    pub fn new(name: &str) -> Self {
        let path =
            std::env::temp_dir().join(format!("ray_test-render-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).expect("the folder for temporary files can be written");
        Folder(path)
    }

    /// Writes a file.
    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).expect("the folder can be written");
    }

    /// A file's bytes.
    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.0.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The names of its files, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("it is there");
        let name = |entry: std::io::Result<fs::DirEntry>| {
            entry.expect("it can be read").file_name().to_string_lossy().into_owned()
        };
        let mut names: Vec<String> = entries.map(name).collect();
        names.sort();
        names
    }

    /// Beside the folder, so that it is none of its files.
    fn lock(&self) -> PathBuf {
        self.0.with_extension("lock")
    }

    /// Runs `ray_test render` there, with a lock of its own.
    pub fn render(&self, words: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ray_test"));
        command.arg("render").args(words).current_dir(&self.0);
        command.env("RAY_TEST_LOCK", self.lock());
        command.output().expect("the program was built for this test")
    }

    /// Runs it, asserts the exit code, and returns its rows, as JSON.
    pub fn rows(&self, words: &[&str], code: i32) -> Vec<serde_json::Value> {
        let output = self.render(&[words, &["--format", "json"]].concat());
        assert_eq!(output.status.code(), Some(code), "{}", said(&output));
        serde_json::from_slice(&output.stdout).expect("an array of objects")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
        let _ = fs::remove_file(self.lock());
    }
}

/// What it says on stderr.
pub fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

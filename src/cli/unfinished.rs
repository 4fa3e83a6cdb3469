//! Runs that are not finished: their journal, and what is said of them.

use std::ffi::{OsStr, OsString};
use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::arguments::Format;
use super::failure::Failure;
use super::rounds::RoundsLog;
use super::show::{Sheet, print, rounded};
use crate::experiment::{Keep, Pieces};
use crate::measure::{Protocol, RoundTrace};
use crate::report::count;
use crate::table::{Journal, Journaled, Row, TableError};

/// A journal, with what it held when the run was gone on with and that was not handed out yet.
pub struct Keeper {
    journal: Journal,
    before: Pieces,
    rounds: RoundsLog,
}

impl Keeper {
    /// Begins the journal of an experiment, with what was kept of it before.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn begin(path: &Path, before: Journaled, rounds: RoundsLog) -> Result<Self, TableError> {
        let journal = Journal::begin(path, &before)?;
        Ok(Keeper { journal, before: Pieces(before.pieces), rounds })
    }
}

impl Keep for Keeper {
    fn is_kept(&self, piece: &str) -> bool {
        self.before.has(piece)
    }

    fn hand_out(&mut self, piece: &str) -> Option<Vec<Row>> {
        self.before.take(piece)
    }

    fn hand_out_rest(&mut self) -> Vec<Row> {
        self.before.take_rest()
    }

    fn keep(&mut self, piece: &str, rows: &[Row]) -> Result<(), TableError> {
        self.rounds.failure()?;
        self.journal.append(piece, rows)
    }

    fn take_down(&mut self, protocol: &Protocol, rounds: &[RoundTrace]) {
        self.rounds.take_down(protocol, rounds);
    }
}

/// Rows that are printed of an interrupted experiment.
const MOST_ROWS: usize = 40;

/// Prints what was measured of an interrupted experiment, and where all of it is.
///
/// # Errors
/// When stdout cannot be written.
pub fn print_rows(rows: &[Row], file: &Path) -> Result<(), Failure> {
    let measured = rows.iter().filter(|row| row.ns_per_test.is_some() && row.price.is_none());
    let measured: Vec<&Row> = measured.collect();
    let shown = &measured[..measured.len().min(MOST_ROWS)];
    let columns = ["id", "order", "density", "code", "ns_per_test", "cycles_per_test"];
    let has = |column: &&str| shown.iter().any(|row| !value(row, column).is_null());
    let columns: Vec<&'static str> = columns.into_iter().filter(has).collect();
    let values = |row: &&Row| {
        let mut values: Vec<Value> = columns.iter().map(|column| value(row, column)).collect();
        values.push(json!(ratio(row)));
        values
    };
    let sheet_rows = shown.iter().map(values).collect();
    let mut sheet = Sheet { columns: columns.clone(), rows: sheet_rows };
    sheet.columns.push("ratio");
    if !shown.is_empty() {
        print(&sheet, Format::Text)?;
    }
    let mut out = std::io::stdout().lock();
    match measured.len() - shown.len() {
        0 => writeln!(out, "{} in {}", count(measured.len(), "row", "rows"), file.display())?,
        more => writeln!(out, "... and {more} more in {}", file.display())?,
    }
    Ok(())
}

fn value(row: &Row, column: &str) -> Value {
    row.cell(column).map_or(Value::Null, |cell| json!(cell))
}

/// The ratio to the reference with its interval.
fn ratio(row: &Row) -> String {
    let text = |number: Option<f64>| number.map(|number| rounded(&json!(number)));
    match (text(row.ratio_to_reference), text(row.ratio_low), text(row.ratio_high)) {
        (Some(ratio), Some(low), Some(high)) => format!("{ratio} ({low} to {high})"),
        (Some(ratio), ..) => ratio,
        _ => String::new(),
    }
}

/// The command that goes on with the run of these arguments in a folder.
pub fn resume_command(arguments: impl Iterator<Item = OsString>, out: &Path) -> String {
    let mut words: Vec<OsString> = arguments.collect();
    let is_out =
        |word: &OsString| word == "--out" || word.as_encoded_bytes().starts_with(b"--out=");
    if !words.iter().any(is_out) {
        words.extend(["--out".into(), out.as_os_str().to_owned()]);
    }
    if !words.iter().any(|word| word == "--resume") {
        words.push("--resume".into());
    }
    words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ")
}

/// A word as a shell takes it: byte by byte (`$'...'` of bash, zsh, ksh and POSIX of 2024) where it is no
/// text, or holds what a terminal would take for itself.
fn quoted(word: &OsStr) -> String {
    let text = word.to_str().filter(|text| !text.contains(char::is_control));
    let Some(word) = text else { return in_bytes(word.as_encoded_bytes()) };
    let plain = |c: char| c.is_alphanumeric() || "-_./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', r"'\''"))
}

fn in_bytes(bytes: &[u8]) -> String {
    let mut word = String::from("$'");
    for byte in bytes {
        match byte {
            b'\'' | b'\\' => word.extend(['\\', char::from(*byte)]),
            b' '..=b'~' => word.push(char::from(*byte)),
            // Two digits, so that none that follows is taken for one of them. A string takes all.
            _ => write!(word, "\\x{byte:02x}").unwrap_or_default(),
        }
    }
    word.push('\'');
    word
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_is_the_same_with_folder_and_resume() {
        let command = |words: &str| {
            let words = words.split(' ').map(OsString::from);
            resume_command(words, Path::new("results/it's"))
        };
        assert_eq!(
            command("ray_test run a.toml --filter ^wald/"),
            r"ray_test run a.toml --filter '^wald/' --out 'results/it'\''s' --resume"
        );
        for same in ["ray_test reproduce --out=x --resume", "ray_test run a b --resume --out x"] {
            assert_eq!(command(same), same);
        }
    }

    #[test]
    #[cfg(unix)]
    fn a_path_that_is_no_text_comes_back_from_a_shell_as_it_was() {
        use std::os::unix::ffi::OsStrExt;

        let out = |bytes: &[u8]| {
            let words = ["ray_test", "run", "a.toml"].map(OsString::from).into_iter();
            resume_command(words, Path::new(OsStr::from_bytes(bytes)))
        };
        assert_eq!(out(b"a\xffb"), r"ray_test run a.toml --out $'a\xffb' --resume");
        assert_eq!(out(b"it's \\ \n"), r"ray_test run a.toml --out $'it\'s \\ \x0a' --resume");
        assert_eq!(out("ö".as_bytes()), "ray_test run a.toml --out ö --resume");
        let own = [b"ray_test".as_slice(), b"--out=\xfe", b"--resume"];
        let own = own.map(|word| OsStr::from_bytes(word).to_owned()).into_iter();
        assert_eq!(resume_command(own, Path::new("x")), r"ray_test $'--out=\xfe' --resume");
    }

    #[test]
    fn a_ratio_has_its_interval() {
        let row = Row {
            ratio_to_reference: Some(1.23456),
            ratio_low: Some(1.2),
            ratio_high: Some(1.25),
            ..Row::default()
        };
        assert_eq!(ratio(&row), "1.235 (1.200 to 1.250)");
        assert_eq!(ratio(&Row::default()), "");
    }
}

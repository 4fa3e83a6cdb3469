//! `rounds.csv`: what became of every round, and how long the reference took in it.
//!
//! It is appended to while an experiment is measured, group by group, each by one write. What ends
//! the program in the middle of one leaves a last line without an end, which is not read.

use super::TableError;
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// A round of a group of contestants.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Round {
    /// Experiment id.
    pub experiment: String,
    /// The group: its number in the experiment, the order, and what is timed if that is unusual.
    pub cell: String,
    /// Number in the group, from 0, dropped ones included.
    pub round: u64,
    /// Seconds since the run began; where it was gone on with, since it began for the first time,
    /// without the pause.
    pub at_s: f64,
    /// Time of the group's reference; none where it has no reference.
    pub reference_ns_per_test: Option<f64>,
    /// `clean`; `crowded`, with a neighbour on the core; `dirty`, dropped because something else ran.
    pub state: String,
}

/// Words of the column `state`.
const STATES: [&str; 3] = ["clean", "crowded", "dirty"];

/// A file of rounds that is being written.
#[derive(Debug)]
pub struct RoundsFile {
    path: PathBuf,
    file: File,
}

impl RoundsFile {
    /// Begins a file with rounds that were taken down before.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn begin(path: &Path, before: &[Round]) -> Result<Self, TableError> {
        let header = "experiment,cell,round,at_s,reference_ns_per_test,state\n";
        let mut bytes = header.as_bytes().to_vec();
        bytes.extend(lines(path, before)?);
        super::write_atomically(path, &bytes)?;
        let opened = OpenOptions::new().append(true).open(path);
        let file = opened.map_err(|source| TableError::Io { file: path.to_owned(), source })?;
        Ok(RoundsFile { path: path.to_owned(), file })
    }

    /// Appends rounds.
    ///
    /// # Errors
    /// When they cannot be written.
    pub fn append(&mut self, rounds: &[Round]) -> Result<(), TableError> {
        let bytes = lines(&self.path, rounds)?;
        let failed = |source| TableError::Io { file: self.path.clone(), source };
        self.file.write_all(&bytes).map_err(failed)
    }
}

fn lines(path: &Path, rounds: &[Round]) -> Result<Vec<u8>, TableError> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    for round in rounds {
        writer.serialize(round).map_err(|error| syntax(path, &error))?;
    }
    writer
        .into_inner()
        .map_err(|error| TableError::Io { file: path.to_owned(), source: error.into_error() })
}

/// Reads rounds; none if there is no such file.
///
/// # Errors
/// When it cannot be read, or a line says what none may say.
pub fn read_rounds(path: &Path) -> Result<Vec<Round>, TableError> {
    let bytes = match std::fs::read(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        bytes => bytes.map_err(|source| TableError::Io { file: path.to_owned(), source })?,
    };
    let whole = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1);
    let mut reader = csv::Reader::from_reader(&bytes[..whole]);
    let mut rounds = Vec::new();
    for record in reader.deserialize() {
        let round: Round = record.map_err(|error| syntax(path, &error))?;
        let place = || format!("line {}", rounds.len() + 2);
        if !STATES.contains(&round.state.as_str()) {
            let allowed = "clean, crowded or dirty";
            return Err(TableError::cell(path, place(), "state", &round.state, allowed));
        }
        if !round.at_s.is_finite()
            || round.reference_ns_per_test.is_some_and(|ns| !ns.is_finite() || ns <= 0.0)
        {
            let text = format!("{} and {:?}", round.at_s, round.reference_ns_per_test);
            let (columns, allowed) = ("at_s, reference_ns_per_test", "finite numbers, above 0");
            return Err(TableError::cell(path, place(), columns, &text, allowed));
        }
        rounds.push(round);
    }
    Ok(rounds)
}

fn syntax(path: &Path, error: &csv::Error) -> TableError {
    let line = error.position().map_or(0, csv::Position::line);
    TableError::Syntax { file: path.to_owned(), line, message: error.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn round(number: u64, state: &str) -> Round {
        Round {
            experiment: "h-4".into(),
            cell: "0 fixed".into(),
            round: number,
            at_s: 0.25 + number as f64,
            reference_ns_per_test: (number != 1).then_some(3.5),
            state: state.into(),
        }
    }

    #[test]
    fn what_is_appended_is_read_back_but_for_a_line_that_was_cut_off() {
        let path = std::env::temp_dir().join(format!("rounds-{}.csv", std::process::id()));
        let all = [round(0, "clean"), round(1, "crowded"), round(2, "dirty")];
        let mut file = RoundsFile::begin(&path, &all[..1]).expect("a file for a test");
        file.append(&all[1..]).expect("it can be written");
        let whole = read_rounds(&path);
        let text = std::fs::read_to_string(&path).expect("it is there");
        std::fs::write(&path, &text[..text.len() - 3]).expect("a file for a test");
        let cut = read_rounds(&path);
        std::fs::write(&path, text.replace("dirty", "muddy")).expect("a file for a test");
        let wrong = read_rounds(&path);
        std::fs::write(&path, text.replace("3.5", "-1")).expect("a file for a test");
        let negative = read_rounds(&path);
        std::fs::remove_file(&path).ok();
        assert_eq!(whole.expect("it can be read"), all);
        assert_eq!(cut.expect("it can be read"), all[..2]);
        let message = wrong.expect_err("muddy is no state").to_string();
        assert!(message.contains("line 4") && message.contains("'muddy'"), "{message}");
        assert!(negative.is_err());
        assert!(read_rounds(&path).is_ok_and(|rounds| rounds.is_empty()));
    }
}

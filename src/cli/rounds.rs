//! The rounds of a run: taken down group by group, drawn with its figures.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::failure::Failure;
use crate::chart::timeline;
use crate::measure::{Pace, Protocol, RoundTrace};
use crate::table::{Round, RoundsFile, TableError, read_rounds, write_atomically};

/// The file of an experiment's rounds.
pub const ROUNDS: &str = "rounds.csv";
const TIMELINE: &str = "timeline.svg";

/// The rounds of one experiment, on their way into its file.
pub struct RoundsLog {
    experiment: String,
    file: RoundsFile,
    /// Groups so far.
    groups: usize,
    /// When the program began, seconds after the run's first program did.
    began_s: f64,
    failure: Option<TableError>,
}

impl RoundsLog {
    /// Begins the file of an experiment; `goes_on` keeps the rounds that it has.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn begin(folder: &Path, began_s: f64, goes_on: bool) -> Result<Self, TableError> {
        let path = folder.join(ROUNDS);
        // Times only illustrate: a file that cannot be read is begun anew.
        let before = if goes_on { read_rounds(&path).unwrap_or_default() } else { Vec::new() };
        let cells: BTreeSet<&str> = before.iter().map(|round| round.cell.as_str()).collect();
        let groups = cells.len();
        let experiment = folder.file_name().map(|name| name.to_string_lossy().into_owned());
        let (experiment, file) =
            (experiment.unwrap_or_default(), RoundsFile::begin(&path, &before)?);
        Ok(RoundsLog { experiment, file, groups, began_s, failure: None })
    }

    /// Takes down the rounds of a group; what cannot be written is told by [`RoundsLog::failure`].
    pub fn take_down(&mut self, protocol: &Protocol, rounds: &[RoundTrace]) {
        if rounds.is_empty() {
            return;
        }
        let pace = match protocol.pace {
            Pace::Throughput => "",
            Pace::Walk => ", walk",
            Pace::Latency => ", latency",
            Pace::Cold => ", cold",
        };
        let cell = format!("{} {}{pace}", self.groups, protocol.order);
        self.groups += 1;
        let line = |(number, round): (u64, &RoundTrace)| Round {
            experiment: self.experiment.clone(),
            cell: cell.clone(),
            round: number,
            at_s: self.began_s + (round.at_ns / 1000) as f64 / 1e6,
            reference_ns_per_test: round.reference_ns_per_test.filter(|ns| *ns > 0.0),
            state: round.state.word().to_owned(),
        };
        let lines: Vec<Round> = (0..).zip(rounds).map(line).collect();
        if let Err(error) = self.file.append(&lines) {
            self.failure = Some(error);
        }
    }

    /// What could not be written since the last call.
    ///
    /// # Errors
    /// That.
    pub fn failure(&mut self) -> Result<(), TableError> {
        self.failure.take().map_or(Ok(()), Err)
    }
}

/// The rounds of every experiment in the folder of a run, in the order of time.
///
/// # Errors
/// When one of the files cannot be read.
pub fn rounds_of(folder: &Path) -> Result<Vec<Round>, TableError> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path().join(ROUNDS)).collect();
    files.retain(|file| file.is_file());
    files.sort();
    let mut rounds = Vec::new();
    for file in files {
        rounds.extend(read_rounds(&file)?);
    }
    rounds.sort_by(|one, other| one.at_s.total_cmp(&other.at_s));
    Ok(rounds)
}

/// When the last round of a folder ended, in seconds; 0 without one.
pub fn last_s(folder: &Path) -> f64 {
    let rounds = rounds_of(folder).unwrap_or_default();
    rounds.last().map_or(0.0, |round| round.at_s)
}

/// Draws rounds into the folder of a run, if there are any.
///
/// # Errors
/// When the picture cannot be drawn or written.
pub fn draw_rounds(rounds: &[Round], folder: &Path) -> Result<(), Failure> {
    if rounds.is_empty() {
        return Ok(());
    }
    let svg = timeline(rounds, false).map_err(|error| Failure::Runtime(error.into()))?;
    Ok(write_atomically(&folder.join(TIMELINE), svg.as_bytes())?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{Order, RoundState};

    fn trace(at_ns: u64) -> RoundTrace {
        RoundTrace::new(at_ns, Some(2.0), RoundState::Clean)
    }

    #[test]
    fn a_run_that_goes_on_keeps_its_rounds_and_its_time() {
        let run = std::env::temp_dir().join(format!("ray_test-rounds-{}", std::process::id()));
        let folder = run.join("h-4");
        std::fs::create_dir_all(&folder).expect("a folder for a test");
        let protocol = Protocol::new(Order::Fixed, 1);
        let mut log = RoundsLog::begin(&folder, 0.0, false).expect("it can be written");
        log.take_down(&protocol, &[trace(1_000_000_000), trace(2_000_000_000)]);
        let mut log = RoundsLog::begin(&folder, last_s(&run), true).expect("it can be written");
        log.take_down(&Protocol { pace: Pace::Cold, ..protocol.clone() }, &[trace(500_000_000)]);
        let kept = rounds_of(&run).expect("they can be read");
        let drawn = draw_rounds(&kept, &run).is_ok() && run.join(TIMELINE).is_file();
        RoundsLog::begin(&folder, 0.0, false).expect("it can be written");
        let anew = rounds_of(&run).expect("they can be read");
        std::fs::remove_dir_all(&run).ok();
        let of = |round: &Round| (round.cell.clone(), round.round, round.at_s);
        let expected = [("0 fixed", 0, 1.0), ("0 fixed", 1, 2.0), ("1 fixed, cold", 0, 2.5)];
        let expected = expected.map(|(cell, round, at_s)| (cell.to_owned(), round, at_s));
        assert_eq!(kept.iter().map(of).collect::<Vec<_>>(), expected);
        assert!(drawn && anew.is_empty() && last_s(&run) == 0.0);
    }
}

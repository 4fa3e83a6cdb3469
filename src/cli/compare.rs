//! `ray_test compare`: two results against each other.

use std::io::Write;
use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::comparison::{csv, json, markdown, text};
use super::failure::Failure;
use crate::compare::{Comparison, InputError, Side, Threshold, Verdict, compare};

/// `ray_test compare`
#[derive(Args, Debug)]
pub struct Compare {
    /// What it was: a rows.json, or the folder of a run
    pub base: PathBuf,
    /// What it is now
    pub new: PathBuf,
    /// From when on a change of time counts, such as 3% or 0.03
    #[arg(long, default_value = "3%")]
    pub threshold: Threshold,
    /// How the comparison is printed
    #[arg(long, value_enum, default_value_t = CompareFormat::Text)]
    pub format: CompareFormat,
}

/// How a comparison is printed.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompareFormat {
    /// A summary to read
    Text,
    /// CSV with a header, one line per finding
    Csv,
    /// One JSON object
    Json,
    /// A table for a pull request
    Markdown,
}

/// Compares, prints and judges.
///
/// # Errors
/// Usage for files that cannot be read or compared; a regression is an error as well.
pub fn run(arguments: &Compare) -> Result<(), Failure> {
    let (base, new) = (Side::read(&arguments.base)?, Side::read(&arguments.new)?);
    report(&base, &new, arguments.threshold, arguments.format)
}

/// Compares two sides, prints the comparison on stdout, and fails if its verdict is a failure.
///
/// # Errors
/// Usage if they cannot be compared, a regression if there is one.
pub fn report(
    base: &Side,
    new: &Side,
    threshold: Threshold,
    format: CompareFormat,
) -> Result<(), Failure> {
    for file in base.unfinished().chain(new.unfinished()) {
        say!("note: {}: of an interrupted run; compared is what it has", file.display());
    }
    let comparison = compare(base, new, threshold);
    let printed = match format {
        CompareFormat::Text => text(&comparison, base, new),
        CompareFormat::Csv => csv(&comparison)?,
        CompareFormat::Json => json(&comparison)?,
        CompareFormat::Markdown => markdown(&comparison, base, new),
    };
    let written = writeln!(std::io::stdout(), "{}", printed.trim_end());
    // A stdout that nobody reads any more does not change what came of it.
    outcome(&comparison)?;
    Ok(written?)
}

fn outcome(comparison: &Comparison) -> Result<(), Failure> {
    match comparison.verdict {
        Verdict::Refused => {
            let value = |text: &Option<String>| text.clone().unwrap_or_else(|| "nothing".into());
            let differs = comparison.refused.iter().map(|refusal| {
                let (base, new) = (value(&refusal.base), value(&refusal.new));
                format!("\n  {}: {base} and {new} ({})", refusal.key, refusal.place)
            });
            let differs: String = differs.collect();
            Err(Failure::Usage(format!(
                "the two cannot be compared; in this they differ and must be the same:{differs}"
            )))
        }
        Verdict::Regressed => Err(Failure::Regressed(comparison.regressions.len())),
        Verdict::Same | Verdict::Improved | Verdict::Unresolved => Ok(()),
    }
}

impl From<InputError> for Failure {
    fn from(error: InputError) -> Self {
        Failure::Usage(error.to_string())
    }
}

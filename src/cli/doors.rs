//! Ways into what the command line reads, past its clock and its streams: for fuzzing (`tests/fuzz`) and for
//! the test that goes through what was found again. Each does what a verb does before, or instead of, measuring.

use std::ffi::OsString;
use std::io::{self, BufRead};
use std::path::Path;

use super::arguments::{Arguments, Batch, Format, Verb, parse};
use super::check_rows::Printer;
use super::failure::Failure;
use super::known::known_variants;
use super::{
    batch, check, check_forms, comparison, doctor, estimate, manual, publish, recommend, render,
    scene, stability, thesis_asked,
};
use crate::check::Precision;
use crate::check::read::{Answered, Answers, Cases};
use crate::compare::{Side, compare};
use crate::experiment::Profile;
use crate::recommend::Question;

/// What is said where something is refused.
type Refusal = String;

fn told(failure: Failure) -> Refusal {
    match failure {
        Failure::Usage(message) => message,
        other => format!("{other:?}"),
    }
}

/// Arguments behind the name of the program, read and checked as far as the verb does without files.
///
/// # Errors
/// What is not allowed.
pub fn arguments(words: impl IntoIterator<Item = OsString>) -> Result<(), Refusal> {
    let words = std::iter::once(OsString::from("ray_test")).chain(words);
    let arguments = parse(words).map_err(|error| error.to_string())?;
    checked(&arguments).map_err(told)
}

fn checked(arguments: &Arguments) -> Result<(), Failure> {
    let of_batch = |batch: &Batch| batch::filter(batch).map(drop);
    match &arguments.verb {
        None => thesis_asked::checked(&arguments.thesis).map(drop),
        Some(Verb::Run(run)) => of_batch(&run.batch),
        Some(Verb::Reproduce(reproduce)) => of_batch(&reproduce.batch),
        Some(Verb::Doctor(doctor)) => doctor::injected_share(doctor).map(drop),
        Some(Verb::Stability(stability)) => stability::sweep(stability).map(drop),
        Some(Verb::Check(check)) => check_forms::chosen(check.kernels.as_deref(), None).map(drop),
        Some(Verb::Scene(asked)) => {
            scene::wanted(asked);
            Ok(())
        }
        Some(Verb::Recommend(asked)) => {
            recommend::question(asked);
            Ok(())
        }
        Some(Verb::Render(asked)) => render::known(&asked.structure).map(drop),
        Some(Verb::Man(asked)) => manual::page(asked.verb.as_deref()).map(drop),
        Some(Verb::List(_) | Verb::Compare(_) | Verb::Report(_) | Verb::Completions(_)) => Ok(()),
    }
}

/// The text of an experiment, read, planned and estimated in every profile, as by `run --dry-run`.
///
/// # Errors
/// What is not allowed in it.
pub fn experiment(text: &str) -> Result<(), Refusal> {
    let sources = [("experiment.toml".to_owned(), text.to_owned())];
    for plan in batch::plans(&sources, None).map_err(told)? {
        for profile in [Profile::Quick, Profile::Standard, Profile::Thorough] {
            let seconds = estimate::estimate(&plan, profile, None).total();
            assert!(seconds.is_finite() && seconds >= 0.0, "it takes {seconds} s");
            plan.blocks(profile);
        }
    }
    Ok(())
}

/// Cases, each through every kernel, and the rows that are printed.
///
/// # Errors
/// What is wrong with a case, and where.
pub fn check(cases: impl BufRead, is_json: bool) -> Result<(), Refusal> {
    let chosen = check_forms::chosen(None, None).map_err(told)?;
    let mut printer = printer(is_json);
    check::ask(Cases::new(cases, "cases"), &chosen, &mut printer).map_err(told)
}

/// Cases with somebody else's answers, and the rows that are printed.
///
/// # Errors
/// What is wrong with a case or an answer, and where.
pub fn answers(cases: impl BufRead, answers: impl BufRead) -> Result<(), Refusal> {
    let answered = Answered::new(Cases::new(cases, "cases"), Answers::new(answers, "answers"));
    check::judge(answered, Precision::F32, &mut printer(false)).map_err(told)
}

fn printer(is_json: bool) -> Printer {
    let format = if is_json { Format::Json } else { Format::Text };
    Printer::new(format, Box::new(io::sink()))
}

/// A folder of results, read, judged, drawn and reported into another.
///
/// # Errors
/// What is wrong with a file in it.
pub fn report(folder: &Path, out: &Path) -> Result<(), Refusal> {
    let results = publish::read(&[folder.to_owned()]).map_err(|error| error.to_string())?;
    std::fs::create_dir_all(out).map_err(|error| error.to_string())?;
    publish::publish(&results, out).map(drop).map_err(told)
}

/// What is recommended by a folder of results.
///
/// # Errors
/// What is wrong with a file in it; that nothing fits.
pub fn recommendation(folder: &Path) -> Result<(), Refusal> {
    let results = publish::read(&[folder.to_owned()]).map_err(|error| error.to_string())?;
    let question = Question::default();
    let found = crate::recommend::recommend(&results, &question, &known_variants());
    found.map(|found| drop(recommend::text(&found))).map_err(|error| error.to_string())
}

/// Two results against each other, and every form in which that is printed.
///
/// # Errors
/// What is wrong with a file.
pub fn comparison(base: &Path, new: &Path) -> Result<(), Refusal> {
    let read = |path: &Path| Side::read(path).map_err(|error| error.to_string());
    let (base, new) = (read(base)?, read(new)?);
    let threshold = "3%".parse().map_err(|error| format!("{error}"))?;
    let found = compare(&base, &new, threshold);
    comparison::text(&found, &base, &new);
    comparison::markdown(&found, &base, &new);
    comparison::csv(&found).map_err(told)?;
    comparison::json(&found).map(drop).map_err(told)
}

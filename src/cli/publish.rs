//! What a reader opens, made from results: figures, tables, report.

use std::path::{Path, PathBuf};

use super::describe::describe;
use super::failure::Failure;
use super::known::known_variants;
use super::rounds::{draw_rounds, rounds_of};
use crate::chart::{ChartError, Published, draw, placeholder};
use crate::claims::{Ledger, judge, to_csv};
use crate::report::{Report, ReportError, figure_csv};
use crate::results::{Chapter, LoadError, ROWS, Results, Source, TABLE, derived, drawings, load};
use crate::table::{Row, make_folder, write_atomically, write_csv};

/// What is made of all experiments of a folder: verdicts and report.
pub const REPORTS: [&str; 3] = ["claims.csv", "report.md", "report.html"];

/// What folders hold, with what follows from it: the mixture of return codes, behind their shares.
///
/// # Errors
/// For folders that hold no results, or broken ones.
pub fn read(folders: &[PathBuf]) -> Result<Results, LoadError> {
    let mut results = load(folders, &describe)?;
    if let Some(mixture) = derived::mixture(&results) {
        let codes = results.chapters.iter().position(|chapter| chapter.about.id == "b-4.5");
        results.chapters.insert(codes.map_or(0, |place| place + 1), mixture);
    }
    if let [only] = folders {
        results.rounds = rounds_of(only)?;
    }
    Ok(results)
}

/// Draws what there is to be drawn, and writes verdicts and report; gives the summary that a terminal
/// shows.
///
/// # Errors
/// When a file cannot be written.
pub fn publish(results: &Results, out: &Path) -> Result<String, Failure> {
    draw_all(results, out)?;
    let rows: Vec<&Row> = results.rows().collect();
    let findings = judge(&Ledger::embedded()?, &rows);
    let [claims, markdown, html] = REPORTS.map(|name| out.join(name));
    write_atomically(&claims, &to_csv(&findings))?;
    let report = Report::new(results, &findings, &known_variants())?;
    write_atomically(&markdown, report.markdown()?.as_bytes())?;
    write_atomically(&html, report.html()?.as_bytes())?;
    Ok(report.terminal())
}

/// Draws the figures of every experiment into its folder under `out`, and the rounds. It is called
/// once at the end of a run, and where one is interrupted: nothing is drawn while there is yet to be
/// measured.
///
/// # Errors
/// When a file cannot be written. A figure that its rows do not fit becomes a picture that says so.
pub fn draw_all(results: &Results, out: &Path) -> Result<(), Failure> {
    for chapter in &results.chapters {
        let folder = out.join(&chapter.about.id);
        make_folder(&folder)?;
        // Some follow from the rows of others: nobody has measured them.
        let is_derived = chapter.about.command.is_empty() && !folder.join(ROWS).exists();
        if is_derived || !folder.join(TABLE).exists() {
            write_csv(&folder.join(TABLE), &chapter.rows)?;
        }
        draw_chapter(chapter, &results.sources, &folder)?;
    }
    draw_rounds(&results.rounds, out)
}

/// Draws the figures of an experiment, each with its numbers beside it; gives how many. Where figure and
/// rows do not go together the picture says why there is none, and numbers there are none.
///
/// # Errors
/// As [`draw_all`].
pub fn draw_chapter(chapter: &Chapter, sources: &[Source], to: &Path) -> Result<usize, Failure> {
    let published = Published::embedded().map_err(of_chart)?;
    let drawings = drawings(chapter, sources);
    for drawing in &drawings {
        let file = |ending: &str| to.join(format!("{}.{ending}", drawing.file));
        match draw(&drawing.figure, drawing.rows, &published) {
            Err(error @ (ChartError::Ambiguous { .. } | ChartError::Wrong { .. })) => {
                say!("note: {}: {error}", chapter.about.id);
                let svg = placeholder(&drawing.figure, &error.to_string());
                write_atomically(&file("svg"), svg.map_err(of_chart)?.as_bytes())?;
            }
            svg => {
                write_atomically(&file("svg"), svg.map_err(of_chart)?.as_bytes())?;
                let numbers = figure_csv(&drawing.figure, drawing.rows)?;
                write_atomically(&file("csv"), &numbers)?;
            }
        }
    }
    Ok(drawings.len())
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        Failure::Runtime(error.into())
    }
}

fn of_chart(error: ChartError) -> Failure {
    Failure::Runtime(error.into())
}

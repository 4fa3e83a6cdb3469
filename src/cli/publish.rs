//! What a reader opens, made from results: figures, tables, report.

use std::path::{Path, PathBuf};

use super::describe::describe;
use super::failure::Failure;
use super::rounds::rounds_of;
use crate::chart::{ChartError, Published, draw, placeholder};
use crate::claims::{Ledger, judge, to_csv};
use crate::report::{ReportError, figure_csv, html, markdown, terminal};
use crate::results::{Chapter, Drawing, LoadError, ROWS, Results, TABLE, derived, drawings, load};
use crate::table::{Row, write_atomically, write_csv};

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

/// Draws every figure into the folder of its experiment under `out`, with its numbers beside it, and
/// writes verdicts and report; gives the summary that a terminal shows.
///
/// # Errors
/// When a file cannot be written. A figure that its rows do not fit becomes a picture that says so.
pub fn publish(results: &Results, out: &Path) -> Result<String, Failure> {
    let published = Published::embedded().map_err(|error| Failure::Runtime(error.into()))?;
    for chapter in &results.chapters {
        let folder = out.join(&chapter.about.id);
        std::fs::create_dir_all(&folder)?;
        if chapter.about.command.is_empty() && !folder.join(ROWS).exists() {
            // Nobody has measured these: they follow from the rows of others.
            write_csv(&folder.join(TABLE), &chapter.rows)?;
        }
        for drawing in drawings(chapter, &results.sources) {
            let svg = drawn(&drawing, chapter, &published)?;
            write_atomically(&folder.join(format!("{}.svg", drawing.file)), svg.as_bytes())?;
            let numbers = figure_csv(&drawing.figure, drawing.rows)?;
            write_atomically(&folder.join(format!("{}.csv", drawing.file)), &numbers)?;
        }
    }
    let rows: Vec<&Row> = results.rows().collect();
    let findings = judge(&Ledger::embedded()?, &rows);
    write_atomically(&out.join("claims.csv"), &to_csv(&findings))?;
    write_atomically(&out.join("report.md"), markdown(results, &findings)?.as_bytes())?;
    write_atomically(&out.join("report.html"), html(results, &findings)?.as_bytes())?;
    Ok(terminal(results, &findings))
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        Failure::Runtime(error.into())
    }
}

/// The picture; one that says why there is none, where figure and rows do not go together.
fn drawn(
    drawing: &Drawing<'_>,
    chapter: &Chapter,
    published: &Published,
) -> Result<String, Failure> {
    let svg = match draw(&drawing.figure, drawing.rows, published) {
        Err(error @ (ChartError::Ambiguous { .. } | ChartError::Wrong { .. })) => {
            eprintln!("note: {}: {error}", chapter.about.id);
            placeholder(&drawing.figure, &error.to_string())
        }
        svg => svg,
    };
    svg.map_err(|error| Failure::Runtime(error.into()))
}

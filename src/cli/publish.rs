//! What a reader opens, made from results: figures, tables, report.

use std::path::Path;

use super::failure::Failure;
use crate::chart::{ChartError, Published, draw, placeholder};
use crate::results::{Chapter, Drawing, Results, drawings};
use crate::table::write_atomically;

/// Draws every figure into the folder of its experiment under `out`; gives the summary that a terminal
/// shows.
///
/// # Errors
/// When a file cannot be written. A figure that its rows do not fit becomes a picture that says so.
pub fn publish(results: &Results, out: &Path) -> Result<String, Failure> {
    let published = Published::embedded().map_err(|error| Failure::Runtime(error.into()))?;
    for chapter in &results.chapters {
        let folder = out.join(&chapter.about.id);
        std::fs::create_dir_all(&folder)?;
        for drawing in drawings(chapter, &results.sources) {
            let svg = drawn(&drawing, chapter, &published)?;
            write_atomically(&folder.join(format!("{}.svg", drawing.file)), svg.as_bytes())?;
        }
    }
    Ok(String::new())
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

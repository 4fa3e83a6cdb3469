//! What is drawn of a chapter: each figure once, or once for every machine.

use super::{Chapter, Source};
use crate::chart::Figure;
use crate::table::Row;

/// The column that tells sources apart.
const MACHINE: &str = "machine";

/// One picture.
#[derive(Clone, Debug)]
pub struct Drawing<'a> {
    /// What is drawn. Its `file` is that of the drawing; its subtitle names the machine.
    pub figure: Figure,
    /// The file's name without its ending: `b-4.2`, or with several sources `b-4.2--2`.
    pub file: String,
    /// Label of the machine that it is of; empty where it is of all.
    pub machine: &'a str,
    /// The rows that it is drawn from.
    pub rows: &'a [Row],
}

/// The pictures of a chapter. With one source, a figure is one picture. With several, a figure that
/// names the column `machine` (as x, series, panels, or in a filter) is one picture of all, and
/// any other is one for each source that has rows, with the source's number behind its name:
/// two machines in one place of a figure would be ambiguous.
pub fn drawings<'a>(chapter: &'a Chapter, sources: &[Source]) -> Vec<Drawing<'a>> {
    let mut drawings = Vec::new();
    for figure in &chapter.about.figures {
        if sources.len() < 2 || chapter.rows.is_empty() || is_of_all(figure) {
            let (figure, file) = (figure.clone(), figure.file.clone());
            drawings.push(Drawing { figure, file, machine: "", rows: &chapter.rows });
            continue;
        }
        // Rows stand source by source.
        for rows in chapter.rows.chunk_by(|one, other| one.machine == other.machine) {
            let machine = rows[0].machine.as_str();
            let place = sources.iter().position(|source| source.label == machine);
            let file = format!("{}--{}", figure.file, place.map_or(0, |place| place + 1));
            let mut figure = Figure { file: file.clone(), ..figure.clone() };
            figure.subtitle = format!("{} Machine: {machine}.", figure.subtitle).trim().to_owned();
            drawings.push(Drawing { figure, file, machine, rows });
        }
    }
    drawings
}

fn is_of_all(figure: &Figure) -> bool {
    let axes = figure.x.list().iter().chain(figure.series.list()).chain(&figure.panels);
    axes.into_iter().any(|column| column == MACHINE) || figure.filter.contains_key(MACHINE)
}

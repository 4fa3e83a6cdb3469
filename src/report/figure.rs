//! A figure in the report: picture, sentence, numbers.

use super::ReportError;
use super::numbers::{Table, table};
use super::sentence::sentences;
use super::words::slug;
use crate::chart::{ChartError, Figure, Kind, Published, draw, numbers, placeholder};
use crate::results::{Chapter, Results};
use crate::table::Row;

/// A figure of an experiment, ready to be shown.
pub(super) struct Plate {
    /// File name without its ending.
    pub file: String,
    pub question: String,
    pub subtitle: String,
    /// The picture without its titles; empty where the report links to the file.
    pub svg: String,
    /// What it shows, a sentence each.
    pub says: Vec<String>,
    pub table: Table,
    /// Whether its colours may be inverted for a dark page: those of a field of colours may not.
    pub inverts: bool,
}

/// What is drawn of a chapter: each figure with the rows that it is drawn from. Where results of
/// several machines claim the same places in a figure, there is one for each machine, its file and
/// its subtitle named after it.
pub fn drawings(results: &Results, chapter: &Chapter) -> Vec<(Figure, Vec<Row>)> {
    let Ok(published) = Published::embedded() else { return Vec::new() };
    let mut drawings = Vec::new();
    for figure in &chapter.about.figures {
        let clash =
            matches!(numbers(figure, &chapter.rows, &published), Err(ChartError::Ambiguous { .. }));
        if results.sources.len() < 2 || !clash {
            drawings.push((figure.clone(), chapter.rows.clone()));
            continue;
        }
        for source in &results.sources {
            let is_its = |row: &&Row| row.machine == source.label;
            let rows: Vec<Row> = chapter.rows.iter().filter(is_its).cloned().collect();
            if rows.is_empty() {
                continue;
            }
            let mut figure = figure.clone();
            figure.file = format!("{}-{}", figure.file, slug(&source.label));
            figure.subtitle = format!("{}. {}", source.label, figure.subtitle);
            drawings.push((figure, rows));
        }
    }
    drawings
}

impl Plate {
    /// Draws it. `number` is different for each figure of a report: titles and descriptions of
    /// pictures are named by it.
    pub fn new(
        figure: &Figure,
        rows: &[Row],
        published: &Published,
        number: usize,
        inside: bool,
    ) -> Result<Self, ReportError> {
        let svg = if inside { picture(figure, rows, published, number)? } else { String::new() };
        let (says, table) = match numbers(figure, rows, published) {
            Ok(numbers) => (sentences(figure, &numbers), table(figure, &numbers)),
            Err(error) => (vec![format!("Not drawn: {error}.")], Table::default()),
        };
        Ok(Plate {
            file: figure.file.clone(),
            question: figure.question.clone(),
            subtitle: figure.subtitle.clone(),
            svg,
            says,
            table,
            inverts: figure.kind != Kind::Heat,
        })
    }
}

impl Plate {
    /// Width of the picture at its own size.
    pub fn width(&self) -> &str {
        let box_of_view = self.svg.split("viewBox=\"").nth(1).unwrap_or_default();
        box_of_view.split('"').next().unwrap_or_default().split(' ').nth(2).unwrap_or("760")
    }
}

/// The picture without question and subtitle, which the page has; one that cannot be drawn says so.
fn picture(
    figure: &Figure,
    rows: &[Row],
    published: &Published,
    number: usize,
) -> Result<String, ReportError> {
    let bare = Figure { bare: true, file: format!("f{number}"), ..figure.clone() };
    match draw(&bare, rows, published) {
        Ok(svg) => Ok(svg),
        Err(error) => Ok(placeholder(&bare, &error.to_string())?),
    }
}

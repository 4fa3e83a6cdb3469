//! A figure in the report: picture, sentence, numbers.

use super::ReportError;
use super::numbers::{Table, table};
use super::sentence::sentences;
use crate::chart::{Figure, Kind, Published, draw, numbers, placeholder};
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

//! An experiment in the report, and the parts that experiments stand in.

use super::ReportError;
use super::figure::Plate;
use super::words::count;
use crate::chart::{Figure, Kind, Published};
use crate::results::{Chapter, Results, drawings};
use crate::table::Row;

/// Experiments of a kind.
pub(super) struct Part {
    pub anchor: &'static str,
    pub title: &'static str,
    pub sections: Vec<Section>,
}

/// An experiment.
pub(super) struct Section {
    pub id: String,
    pub title: String,
    pub mirrors: String,
    pub question: String,
    /// Paragraphs.
    pub why: Vec<String>,
    pub config: String,
    pub command: String,
    pub claims: Vec<String>,
    /// What is to be said of its rows: how many, and what is missing.
    pub rows: String,
    /// Whether the table of its rows lies beside the report. That of the stiff cases is large and
    /// the same on every machine, so that copies of a run may lack it: no link leads there.
    pub has_table: bool,
    pub plates: Vec<Plate>,
    /// Figures that stand in files beside the report: file and question.
    pub linked: Vec<(String, String)>,
}

/// The parts, in their order: anchor, title, and which chapters stand there.
type Belongs = fn(&Chapter) -> bool;
const PARTS: [(&str, &str, Belongs); 5] = [
    ("part-thesis-b", "Thesis B, table by table", |chapter| kind(chapter) == "thesis-b"),
    ("part-thesis-h", "Thesis H, illustration by illustration", |chapter| {
        kind(chapter) == "thesis-h"
    }),
    ("part-performance", "Our own: performance", |chapter| kind(chapter) == "performance"),
    ("part-exactness", "Our own: exactness", |chapter| kind(chapter) == "exactness"),
    ("part-stability", "Our own: stability", |chapter| kind(chapter) == "stability"),
];

/// Where a chapter stands: by what it mirrors, else by what its rows hold.
fn kind(chapter: &Chapter) -> &'static str {
    let timed = chapter.rows.iter().any(|row| row.ns_per_test.is_some());
    match chapter.about.mirrors.as_str() {
        mirrors if mirrors.starts_with("thesis B") => "thesis-b",
        mirrors if mirrors.starts_with("thesis H") => "thesis-h",
        _ if timed || chapter.rows.is_empty() => "performance",
        _ if chapter.rows.iter().any(|row| !row.record.is_empty()) => "stability",
        _ => "exactness",
    }
}

/// The parts that have chapters.
pub(super) fn parts(results: &Results) -> Result<Vec<Part>, ReportError> {
    let published = Published::embedded()?;
    let mut drawn = Drawn::default();
    let mut parts = Vec::new();
    for (anchor, title, belongs) in PARTS {
        let mut sections = Vec::new();
        for chapter in results.chapters.iter().filter(|chapter| belongs(chapter)) {
            sections.push(section(results, chapter, &published, &mut drawn)?);
        }
        if !sections.is_empty() {
            parts.push(Part { anchor, title, sections });
        }
    }
    Ok(parts)
}

/// What was drawn into the page so far.
#[derive(Default)]
struct Drawn {
    number: usize,
    bytes: usize,
}

impl Drawn {
    /// A figure; its picture and its table are left to the files beside the page where the pictures
    /// before it have used up the room.
    fn plate(
        &mut self,
        figure: &Figure,
        rows: &[Row],
        published: &Published,
    ) -> Result<Plate, ReportError> {
        self.number += 1;
        let inside = self.bytes < PICTURES;
        let mut plate = Plate::new(figure, rows, published, self.number, inside)?;
        if !inside {
            plate.table = Default::default();
        }
        self.bytes += plate.svg.len();
        Ok(plate)
    }
}

/// Bytes that pictures may take of a page of 5 MB; numbers and words take a third of that.
const PICTURES: usize = 3_300_000;

fn section(
    results: &Results,
    chapter: &Chapter,
    published: &Published,
    drawn: &mut Drawn,
) -> Result<Section, ReportError> {
    let about = &chapter.about;
    let swept = kind(chapter) == "stability";
    let mut plates = Vec::new();
    let mut linked = Vec::new();
    for drawing in drawings(chapter, &results.sources) {
        let figure = &drawing.figure;
        if swept && !is_summary(figure) {
            linked.push((figure.file.clone(), figure.question.clone()));
            continue;
        }
        plates.push(drawn.plate(figure, drawing.rows, published)?);
    }
    let paragraphs = about.why.split("\n\n").map(str::trim).filter(|text| !text.is_empty());
    Ok(Section {
        id: about.id.clone(),
        title: about.title.clone(),
        mirrors: about.mirrors.clone(),
        question: about.question.clone(),
        why: paragraphs.map(|text| text.split_whitespace().collect::<Vec<_>>().join(" ")).collect(),
        config: about.config.clone(),
        command: about.command.clone(),
        claims: about.claims.clone(),
        rows: rows(chapter),
        has_table: !swept,
        plates,
        linked,
    })
}

/// Knees and leaks sum a sweep up; a figure per family is too much for one page.
fn is_summary(figure: &Figure) -> bool {
    figure.kind == Kind::Heat || figure.kind == Kind::Bars
}

fn rows(chapter: &Chapter) -> String {
    let of = |status: &str| chapter.rows.iter().filter(|row| row.status == status).count();
    let mut words = count(chapter.rows.len(), "row", "rows");
    for status in ["wrong-result", "skipped", "inexact", "invalid", "not-measured"] {
        if of(status) > 0 {
            words += &format!(", {} {status}", of(status));
        }
    }
    if !chapter.complete {
        words += "; NOT COMPLETE: the run was interrupted";
    }
    words
}

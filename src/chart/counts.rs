//! Operation counts as a table: ours, what was published, and whether they are the same, told by
//! a tick or a cross as well as by colour.

use super::canvas::{Anchor, Canvas, Place, Type};
use super::figure::Figure;
use super::frame::{Frame, MARGIN, published_note};
use super::palette::{AGREES, DIFFERS, FAINT, GREY, INK, LEADER};
use super::published::{Measure, Published};
use super::select::{self, Point, Selection};
use super::{ChartError, text};
use crate::table::Row;

const CELL: f64 = 104.0;
const LINE: f64 = 40.0;
const SIZE: f64 = 15.0;

/// Heading, published name and our columns; a change of sign is a subtraction, as the thesis counts.
pub(super) const OPERATIONS: [(&str, &str, &str); 5] = [
    ("+", "add", "additions"),
    ("−", "sub", "subtractions"),
    ("×", "mul", "multiplications"),
    ("÷", "div", "divisions"),
    ("if", "condition", "conditions"),
];

/// One kernel's counts.
pub(super) struct Line {
    pub name: String,
    pub ours: [Option<u64>; 5],
}

/// Draws the figure.
pub(super) fn draw(
    figure: &Figure,
    rows: &[Row],
    published: &Published,
) -> Result<String, ChartError> {
    let selection = Selection::new(figure, rows)?;
    let lines = lines(figure, &selection);
    if lines.iter().all(|line| line.ours.iter().all(Option::is_none)) {
        return Err(ChartError::Nothing("no row has operation counts".to_owned()));
    }
    let theirs = select::published(figure, published, Measure::Count, &[String::new()]);
    let names = lines.iter().map(|line| text::width(&figure.label(&line.name), SIZE, true));
    let left = MARGIN + names.fold(90.0, f64::max) + 28.0;
    let width = (left + CELL * OPERATIONS.len() as f64 + MARGIN).max(640.0);
    let mut frame = Frame::new(figure, width);
    header(&mut frame, left);
    for line in &lines {
        kernel_line(&mut frame, figure, line, &theirs, left);
    }
    let marks = if theirs.is_empty() { "" } else { "tick = the same, cross = not the same" };
    let notes = [
        selection.source(),
        published_note(figure),
        marks.to_owned(),
        "a change of sign counts as −".to_owned(),
    ];
    let description = described(figure, &lines, &theirs);
    let bottom = frame.top;
    frame.close(figure, bottom, &notes, &description)
}

/// The largest count of each operation over a kernel's rows: rows by return code count shorter paths.
pub(super) fn lines(figure: &Figure, selection: &Selection<'_>) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for row in &selection.rows {
        let name = select::joined(row, &figure.series);
        let subtractions = match (row.ops_sub, row.ops_neg) {
            (None, None) => None,
            (sub, neg) => Some(sub.unwrap_or(0).saturating_add(neg.unwrap_or(0))),
        };
        let ours = [row.ops_add, subtractions, row.ops_mul, row.ops_div, row.ops_condition];
        match lines.iter_mut().find(|line| line.name == name) {
            Some(line) => {
                line.ours.iter_mut().zip(ours).for_each(|(most, count)| *most = (*most).max(count));
            }
            None => lines.push(Line { name, ours }),
        }
    }
    lines
}

fn header(frame: &mut Frame, left: f64) {
    for (index, (sign, _, words)) in OPERATIONS.iter().enumerate() {
        let x = left + CELL * (index as f64 + 0.5);
        frame.canvas.text(
            (x, frame.top + 10.0),
            sign,
            Type::new(17.0, INK).bold().at(Anchor::Middle),
        );
        frame.canvas.text((x, frame.top + 30.0), words, Type::new(11.0, GREY).at(Anchor::Middle));
    }
    frame.top += 44.0;
    let right = left + CELL * OPERATIONS.len() as f64;
    frame.canvas.line(&[(MARGIN, frame.top), (right, frame.top)], LEADER, 1.2);
}

/// One kernel's line of the table.
fn kernel_line(frame: &mut Frame, figure: &Figure, line: &Line, theirs: &[Point], left: f64) {
    let y = frame.top + LINE / 2.0;
    frame.canvas.text((MARGIN, y), &figure.label(&line.name), Type::new(SIZE, INK).bold());
    for (index, (_, operation, _)) in OPERATIONS.iter().enumerate() {
        let wanted = |point: &&Point| point.series == line.name && point.x == *operation;
        let published = theirs.iter().find(wanted).map(|point| point.y);
        cell(
            &mut frame.canvas,
            (left + CELL * (index as f64 + 0.5), y),
            line.ours[index],
            published,
        );
    }
    frame.top += LINE;
    let right = left + CELL * OPERATIONS.len() as f64;
    frame.canvas.line(&[(MARGIN, frame.top), (right, frame.top)], FAINT, 1.0);
}

/// Our count, the mark, and the published count in grey.
fn cell(canvas: &mut Canvas, (x, y): Place, ours: Option<u64>, published: Option<f64>) {
    let words = ours.map_or("–".to_owned(), |count| count.to_string());
    let Some(published) = published else {
        canvas.text((x, y), &words, Type::new(SIZE, INK).at(Anchor::Middle));
        return;
    };
    canvas.text((x - 11.0, y), &words, Type::new(SIZE, INK).at(Anchor::End));
    if ours.is_some_and(|count| count as f64 == published) {
        canvas.line(&[(x - 5.0, y), (x - 1.0, y + 4.5), (x + 6.0, y - 5.0)], AGREES, 2.2);
    } else {
        canvas.line(&[(x - 4.5, y - 4.5), (x + 4.5, y + 4.5)], DIFFERS, 2.2);
        canvas.line(&[(x - 4.5, y + 4.5), (x + 4.5, y - 4.5)], DIFFERS, 2.2);
    }
    canvas.text((x + 13.0, y), &published.to_string(), Type::new(12.0, GREY));
}

fn described(figure: &Figure, lines: &[Line], theirs: &[Point]) -> String {
    let line = |line: &Line| {
        let cells = OPERATIONS.iter().zip(line.ours).map(|((_, operation, words), ours)| {
            let ours = ours.map_or("no".to_owned(), |count| count.to_string());
            let wanted = |point: &&Point| point.series == line.name && point.x == *operation;
            let published =
                theirs.iter().find(wanted).map(|point| format!(" (published {})", point.y));
            format!("{ours} {words}{}", published.unwrap_or_default())
        });
        format!("{}: {}.", figure.label(&line.name), cells.collect::<Vec<_>>().join(", "))
    };
    format!("Table. {}", lines.iter().map(line).collect::<Vec<_>>().join(" "))
}

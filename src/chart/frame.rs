//! What every figure has around its drawing: question, subtitle, footer, and the placeholder.

use super::canvas::{Anchor, Canvas, Type};
use super::figure::{Figure, Kind};
use super::palette::{GREY, INK, LEADER};
use super::{ChartError, svg, text};

/// Ground left free at the sides.
pub(super) const MARGIN: f64 = 24.0;
/// Size of labels and ticks.
pub(super) const SMALL: f64 = 12.0;
const TITLE: f64 = 21.0;
const SUBTITLE: f64 = 13.0;
const FOOTER: f64 = 10.5;

/// A figure being drawn.
pub(super) struct Frame {
    /// Where to draw.
    pub canvas: Canvas,
    /// Height at which the drawing may begin.
    pub top: f64,
    width: f64,
}

impl Frame {
    /// Starts a figure: the question in bold, then the subtitle, unless the page has them.
    pub fn new(figure: &Figure, width: f64) -> Self {
        let mut frame = Frame { canvas: Canvas::default(), top: 14.0, width };
        if figure.bare {
            return frame;
        }
        frame.paragraph(&figure.question, Type::new(TITLE, INK).bold());
        frame.top += 4.0;
        frame.paragraph(&figure.subtitle, Type::new(SUBTITLE, GREY));
        frame.top += 14.0;
        frame
    }

    /// Text over the whole width, as many lines as it needs.
    pub fn paragraph(&mut self, words: &str, style: Type) {
        let limit = self.width - 2.0 * MARGIN;
        let broken = if style.bold { text::balanced } else { text::wrap };
        for line in broken(words, style.size, style.bold, limit) {
            let height = style.size * 1.35;
            // A separator has nothing to part at the end of a line.
            let line = line.trim_end_matches(" ·");
            self.canvas.text((MARGIN, self.top + height / 2.0), line, style);
            self.top += height;
        }
    }

    /// Ends a figure whose drawing reaches down to `bottom`: footer, title and description.
    pub fn close(
        mut self,
        figure: &Figure,
        bottom: f64,
        footer: &[String],
        description: &str,
    ) -> Result<String, ChartError> {
        self.top = bottom + 12.0;
        let notes: Vec<&str> =
            footer.iter().map(String::as_str).filter(|note| !note.is_empty()).collect();
        self.paragraph(&notes.join(" · "), Type::new(FOOTER, GREY));
        let drawn = self.canvas.render(self.width, self.top + 10.0)?;
        let description = format!("{} {description} {}", figure.subtitle, notes.join("; "));
        Ok(svg::described(&drawn, &figure.file, &figure.question, description.trim()))
    }
}

/// What the footer says of published figures.
pub(super) fn published_note(figure: &Figure) -> String {
    let Some(beside) = &figure.published else { return String::new() };
    let table = beside.table.replacen("table_", "table ", 1).replace('_', ".");
    let how = if figure.kind == Kind::Counts { "grey" } else { "hollow" };
    if beside.note.is_empty() {
        format!("{how} = published, {table}")
    } else {
        format!("{how} = published, {table}, {}", beside.note)
    }
}

/// What the footer says of bounds.
pub(super) fn bound_note(figure: &Figure) -> String {
    match figure.bound {
        Some(_) => "hollow: none seen; the rate is below with a probability of 95 %".to_owned(),
        None => String::new(),
    }
}

/// A figure without a drawing that says why there is none.
pub(super) fn placeholder(figure: &Figure, reason: &str) -> Result<String, ChartError> {
    const WIDTH: f64 = 760.0;
    const HEIGHT: f64 = 150.0;
    let mut frame = Frame::new(figure, WIDTH);
    let (left, right, top) = (MARGIN, WIDTH - MARGIN, frame.top);
    let bottom = top + HEIGHT;
    frame.canvas.dashed(
        &[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)],
        LEADER,
        1.0,
    );
    let words = format!("Not drawn: {reason}.");
    let style = Type::new(14.0, GREY).at(Anchor::Middle);
    let lines = text::wrap(&words, style.size, false, WIDTH - 4.0 * MARGIN);
    let first = (top + bottom) / 2.0 - 20.0 * (lines.len().saturating_sub(1)) as f64 / 2.0;
    for (index, line) in lines.iter().enumerate() {
        frame.canvas.text((WIDTH / 2.0, first + 20.0 * index as f64), line, style);
    }
    frame.close(figure, bottom, &[], &words)
}

/// A column's title on an axis, with its unit.
pub fn title(column: &str) -> String {
    let known = match column {
        "density" => "density: share of the pairs that hit",
        "ns_per_test" | "min_ns" => "nanoseconds per test",
        "mtests_per_s" => "million tests per second",
        "cycles_per_test" => "cycles per test",
        "seconds" => "seconds",
        "ratio_to_reference" => "time relative to the reference",
        "share" => "share of the calls, %",
        "code" => "return code",
        "percent_slower" => "% slower than the fastest",
        "price" => "price",
        "instructions_per_test" => "instructions per test",
        "mispredicts_per_test" => "mispredicted branches per test",
        "bytes_per_triangle" => "bytes per triangle",
        "spread" => "spread of the rays of a bunch, radii of the scene",
        "useful_lanes" => "share of the lanes' work that is useful",
        other => return other.replace('_', " "),
    };
    known.to_owned()
}

/// The words over a small multiple: which value of which column it is about.
pub(super) fn heading(figure: &Figure, panel: &str, width: f64) -> Vec<String> {
    let words = match &figure.panels {
        Some(column) => format!("{}: {}", column.replace('_', " "), figure.label(panel)),
        // A panel a column.
        None if !figure.also.is_empty() => figure.label(panel),
        None => return Vec::new(),
    };
    text::wrap(&words, 13.0, true, width)
}

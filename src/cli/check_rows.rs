//! Rows of `check` on stdout, one at a time: to read, as CSV, as a JSON array.

use std::fmt::Write as _;
use std::io::{self, BufWriter, Write};

use super::arguments::Format;
use super::check_summary::Summary;
use super::failure::Failure;
use crate::check::{Judged, Known};
use crate::table::Cell;

/// The contract's columns, then ours.
const COLUMNS: [&str; 18] = [
    "id",
    "kernel",
    "precision",
    "hit",
    "t",
    "u",
    "v",
    "exact_hit",
    "exact_t",
    "exact_u",
    "exact_v",
    "where",
    "err_t_ulp",
    "err_u_ulp",
    "err_v_ulp",
    "verdict",
    "err_barycentric_abs",
    "non_finite",
];

/// What the text table shows, with the width of each.
const SHOWN: [(&str, usize); 14] = [
    ("id", 10),
    ("kernel", 20),
    ("precision", 9),
    ("hit", 5),
    ("t", 13),
    ("u", 12),
    ("v", 12),
    ("where", 10),
    ("exact_t", 13),
    ("err_t_ulp", 10),
    ("err_u_ulp", 10),
    ("err_v_ulp", 10),
    ("verdict", 10),
    ("non_finite", 0),
];

/// Whose answer a row is.
#[derive(Clone, Copy)]
pub struct Label<'a> {
    /// The case.
    pub id: &'a str,
    /// The kernel.
    pub kernel: &'a str,
}

/// A value of a row.
#[derive(Clone, Copy)]
enum Value<'a> {
    Flag(bool),
    Of(Cell<'a>),
}

/// Prints rows as they come; what stands around them with the first and at the end.
pub struct Printer {
    out: BufWriter<Box<dyn Write>>,
    format: Format,
    rows: u64,
    summary: Summary,
    /// The line that is being made, kept for its memory.
    line: String,
}

impl Printer {
    /// Nothing is printed yet.
    pub fn new(format: Format, out: Box<dyn Write>) -> Self {
        let out = BufWriter::with_capacity(1 << 16, out);
        Printer { out, format, rows: 0, summary: Summary::default(), line: String::new() }
    }

    /// Prints a row.
    pub fn row(&mut self, label: Label<'_>, known: &Known, judged: &Judged) -> io::Result<()> {
        let values = values(label, known, judged);
        self.line.clear();
        match self.format {
            Format::Text => {
                self.summary.add(label.kernel, known.precision, judged);
                text(&mut self.line, &values);
            }
            Format::Csv => csv(&mut self.line, &values),
            Format::Json => json(&mut self.line, &values)?,
        }
        self.start_row()?;
        self.rows += 1;
        self.out.write_all(self.line.as_bytes())
    }

    /// Hands on what is printed so far.
    pub fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }

    /// Prints what stands behind the rows; the summary of a table to read goes to stderr.
    ///
    /// # Errors
    /// When stdout cannot be written.
    pub fn finish(mut self) -> Result<(), Failure> {
        if self.rows > 0 && self.format == Format::Json {
            self.out.write_all(b"\n]\n")?;
        }
        self.out.flush()?;
        if self.rows > 0 && self.format == Format::Text {
            say!("{}", self.summary.text());
        }
        Ok(())
    }

    fn start_row(&mut self) -> io::Result<()> {
        match (self.format, self.rows) {
            (Format::Json, 0) => self.out.write_all(b"[\n"),
            (Format::Json, _) => self.out.write_all(b",\n"),
            (Format::Csv, 0) => writeln!(self.out, "{}", COLUMNS.join(",")),
            (Format::Text, 0) => {
                let header = SHOWN.map(|(name, width)| format!("{name:<width$}"));
                writeln!(self.out, "{}", header.join(" "))
            }
            _ => Ok(()),
        }
    }
}

/// The values of [`COLUMNS`].
fn values<'a>(label: Label<'a>, known: &Known, judged: &Judged) -> [Value<'a>; 18] {
    let number = |x: Option<f64>| Value::Of(x.map_or(Cell::Missing, Cell::Number));
    let word =
        |text: &'a str| Value::Of(if text.is_empty() { Cell::Missing } else { Cell::Text(text) });
    let ([t, u, v], exact, errors) = (judged.values, known.values(), judged.errors_ulp);
    [
        word(label.id),
        word(label.kernel),
        word(known.precision.name()),
        Value::Flag(judged.hit),
        number(t),
        number(u),
        number(v),
        Value::Flag(known.place.is_hit()),
        number(exact[0]),
        number(exact[1]),
        number(exact[2]),
        word(known.place.name()),
        number(errors[0]),
        number(errors[1]),
        number(errors[2]),
        word(judged.verdict.name()),
        number(judged.barycentric_error),
        word(judged.non_finite_names()),
    ]
}

fn csv(line: &mut String, values: &[Value<'_>]) {
    for (place, value) in values.iter().enumerate() {
        if place > 0 {
            line.push(',');
        }
        // Writing to a String cannot fail.
        let _ = match value {
            Value::Of(Cell::Text(text)) if text.contains([',', '"', '\n', '\r']) => {
                write!(line, "\"{}\"", text.replace('"', "\"\""))
            }
            Value::Of(cell) => write!(line, "{cell}"),
            Value::Flag(flag) => write!(line, "{flag}"),
        };
    }
    line.push('\n');
}

fn json(line: &mut String, values: &[Value<'_>]) -> io::Result<()> {
    for (place, (name, value)) in COLUMNS.iter().zip(values).enumerate() {
        line.push_str(if place == 0 { "{" } else { ", " });
        let text = match value {
            Value::Of(cell) => serde_json::to_string(cell)?,
            Value::Flag(flag) => flag.to_string(),
        };
        // Writing to a String cannot fail.
        let _ = write!(line, "\"{name}\": {text}");
    }
    line.push('}');
    Ok(())
}

fn text(line: &mut String, values: &[Value<'_>]) {
    let by_name = |name: &str| COLUMNS.iter().position(|column| *column == name);
    for (name, width) in SHOWN {
        let Some(value) = by_name(name).map(|place| values[place]) else { continue };
        let text = match value {
            Value::Flag(flag) => flag.to_string(),
            Value::Of(Cell::Number(number)) => short(number),
            Value::Of(Cell::Missing) if width > 0 => "-".into(),
            Value::Of(cell) => cell.to_string(),
        };
        // Writing to a String cannot fail.
        let _ = write!(line, "{text:<width$} ");
    }
    line.truncate(line.trim_end().len());
    line.push('\n');
}

/// Six significant digits; the other formats have all.
pub fn short(number: f64) -> String {
    match number.abs() {
        0.0 => format!("{number}"),
        size if (1e-3..1e6).contains(&size) => {
            let digits = 5 - size.log10().floor() as i32;
            let text = format!("{number:.*}", digits.clamp(0, 8) as usize);
            let text = if text.contains('.') { text.trim_end_matches('0') } else { &text };
            text.trim_end_matches('.').to_owned()
        }
        _ => format!("{number:.5e}"),
    }
}

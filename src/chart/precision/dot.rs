//! The points of a work-precision chart, and which of them nobody should take.

use crate::chart::ChartError;
use crate::chart::figure::Figure;
use crate::chart::select::{Selection, joined};
use crate::table::{Cell, Row, interval};

/// More than this many times the time of the front at the same error, in the same precision, and a
/// point is set apart instead of stretching the axis for all.
const FAR_TIME: f64 = 3.0;
/// The same of the error of the front at the same time.
const FAR_ERROR: f64 = 100.0;

/// What is to be thought of a point.
#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    /// No other of the same precision is surely better.
    Front,
    /// Some other of the same precision is surely better.
    Dominated,
    /// So much worse that it is listed, not drawn; in words.
    Apart(String),
}

/// An error and a time.
#[derive(Clone, Debug)]
pub struct Dot {
    /// Which small multiple; empty if there is only one.
    pub panel: String,
    /// Which series.
    pub name: String,
    /// `f32` or `f64`.
    pub precision: String,
    /// The error.
    pub error: f64,
    /// Two more quantiles of the same error, or the error itself.
    pub errors: (f64, f64),
    /// The time.
    pub time: f64,
    /// Its interval.
    pub times: (f64, f64),
    /// Whether it is on the front.
    pub standing: Standing,
}

impl Dot {
    /// Whether this one is better beyond doubt: its whole time interval is below the other's, and
    /// at none of the quantiles is its error larger. Errors are those of the same cases and have no
    /// noise; their range says how they scatter over the cases, not how well they are known.
    fn dominates(&self, other: &Dot) -> bool {
        self.times.1 < other.times.0
            && self.error <= other.error
            && self.errors.0 <= other.errors.0
            && self.errors.1 <= other.errors.1
    }
}

/// Rows that became no points.
#[derive(Debug, Default)]
pub(super) struct Without {
    /// Names of those with a time but no error.
    pub error: Vec<String>,
}

/// The points of a figure. Times are those of the rows that its filter lets through; errors are of
/// the same row, or of the row of the same id that `errors_from` lets through.
pub(super) fn dots(
    figure: &Figure,
    selection: &Selection<'_>,
    rows: &[Row],
) -> Result<(Vec<Dot>, Without), ChartError> {
    let mut dots: Vec<Dot> = Vec::new();
    let mut without = Without::default();
    for row in &selection.rows {
        let Some(time) = row.cell(&figure.y).and_then(Cell::number) else { continue };
        let of_errors = errors_of(figure, row, rows)?;
        let number = |column: &str| of_errors.and_then(|row| row.cell(column)?.number());
        let (name, precision) = (joined(row, &figure.series), row.precision.clone());
        let Some(error) = figure.x.list().first().and_then(|column| number(column)) else {
            let name = figure.label(&name);
            if !without.error.contains(&name) {
                without.error.push(name);
            }
            continue;
        };
        let end = |column: &Option<String>| column.as_deref().and_then(number).unwrap_or(error);
        let panel = figure.panels.as_deref().and_then(|panel| row.cell(panel));
        dots.push(Dot {
            panel: panel.map_or(String::new(), |cell| cell.to_string()),
            name,
            precision,
            error,
            errors: (end(&figure.x_low).min(error), end(&figure.x_high).max(error)),
            time,
            times: interval(row, &figure.y, time).unwrap_or((time, time)),
            standing: Standing::Front,
        });
    }
    if dots.is_empty() {
        let reason = format!("no row (of {}) has both a time and an error", selection.rows.len());
        return Err(ChartError::Nothing(reason));
    }
    twice(figure, &dots)?;
    judge(&mut dots);
    Ok((dots, without))
}

/// The row that a row's error stands in.
fn errors_of<'a>(
    figure: &Figure,
    row: &'a Row,
    rows: &'a [Row],
) -> Result<Option<&'a Row>, ChartError> {
    if figure.errors_from.is_empty() {
        return Ok(Some(row));
    }
    let mut same = rows.iter().filter(|other| other.id == row.id && figure.admits_errors(other));
    let first = same.next();
    match same.next() {
        Some(_) => {
            Err(several(figure, format!("the errors of {}", row.id), "what errors_from leaves out"))
        }
        None => Ok(first),
    }
}

fn several(figure: &Figure, place: String, differing: &str) -> ChartError {
    let (figure, differing) = (figure.file.clone(), differing.to_owned());
    ChartError::Ambiguous { figure, place, differing }
}

/// Refuses two points of one name.
fn twice(figure: &Figure, dots: &[Dot]) -> Result<(), ChartError> {
    let key = |dot: &Dot| (dot.panel.clone(), dot.name.clone(), dot.precision.clone());
    let mut keys: Vec<_> = dots.iter().map(key).collect();
    keys.sort();
    match keys.windows(2).find(|pair| pair[0] == pair[1]) {
        None => Ok(()),
        Some(pair) => {
            let (panel, name, precision) = &pair[0];
            Err(several(figure, format!("{panel} {name} {precision}"), "what series leaves out"))
        }
    }
}

/// Finds the front of each precision in each panel, and what is far behind it. Precisions are apart
/// since memory and lanes choose between them before error and time do.
fn judge(dots: &mut [Dot]) {
    let standings: Vec<Standing> = dots.iter().map(|dot| standing(dot, dots)).collect();
    for (dot, standing) in dots.iter_mut().zip(standings) {
        dot.standing = standing;
    }
}

fn standing(dot: &Dot, dots: &[Dot]) -> Standing {
    let is_rival = |other: &&Dot| other.panel == dot.panel && other.precision == dot.precision;
    let alike = || dots.iter().filter(is_rival);
    if !alike().any(|other| other.dominates(dot)) {
        return Standing::Front;
    }
    let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
    let time = least(&mut alike().filter(|o| o.error <= dot.error).map(|o| o.time));
    let error = least(&mut alike().filter(|o| o.time <= dot.time).map(|o| o.error));
    if dot.time > FAR_TIME * time {
        return Standing::Apart(format!("{:.1} times the time of the front", dot.time / time));
    }
    if dot.error > FAR_ERROR * error {
        return Standing::Apart(format!("{:.0} times the error of the front", dot.error / error));
    }
    Standing::Dominated
}

/// The steps of the front: from the fastest point on, each next one is slower and errs less.
pub(super) fn steps(dots: &[&Dot]) -> Vec<(f64, f64)> {
    on_steps(dots).iter().map(|dot| (dot.error, dot.time)).collect()
}

/// The points at those steps.
pub fn on_steps<'a>(dots: &[&'a Dot]) -> Vec<&'a Dot> {
    let mut order: Vec<&Dot> = dots.to_vec();
    order.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.error.total_cmp(&b.error)));
    let mut least = f64::INFINITY;
    order.retain(|dot| {
        let errs_less = dot.error < least;
        least = least.min(dot.error);
        errs_less
    });
    order
}

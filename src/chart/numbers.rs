//! What a figure draws, as numbers: what sentences and tables about it start from.

use super::figure::{Figure, Kind};
use super::precision::{self, Dot};
use super::published::{Measure, Published};
use super::select::{self, Point, Selection};
use super::{ChartError, bars, counts, heat, lines, shares};
use crate::table::Row;

/// The numbers of a figure, divided and put together as they are drawn.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// `lines` and `bars`.
    Points {
        /// Measured. Where several columns are drawn, they are the panels of lines and the series of bars.
        ours: Vec<Point>,
        /// Published.
        published: Vec<Point>,
        /// Bounds that stand where a value is 0.
        bounds: Vec<Point>,
    },
    /// `shares`: the upper chart (shares in percent), and the lower one if there is one.
    Shares {
        /// Measured, above.
        ours: Vec<Point>,
        /// Published, above.
        published: Vec<Point>,
        /// Measured, below.
        ours_below: Vec<Point>,
        /// Published, below.
        published_below: Vec<Point>,
    },
    /// `counts`.
    Counts(Vec<Count>),
    /// `heat`, without the series that are not drawn.
    Fields(Vec<Field>),
    /// `precision`.
    Dots(Vec<Dot>),
}

/// How often a kernel does an operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Count {
    /// Kernel.
    pub series: String,
    /// `additions`, `subtractions`, ...
    pub operation: &'static str,
    /// Counted.
    pub ours: Option<u64>,
    /// Published.
    pub published: Option<f64>,
}

/// A field of a heat map.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Line.
    pub series: String,
    /// Column.
    pub x: String,
    /// From 0 to 1, what colours it.
    pub share: f64,
    /// The number in it.
    pub shown: Option<f64>,
}

/// The numbers of a figure.
///
/// # Errors
/// As [`draw`](super::draw); [`ChartError::Nothing`] where it would draw a placeholder.
pub fn numbers(
    figure: &Figure,
    rows: &[Row],
    published: &Published,
) -> Result<Numbers, ChartError> {
    figure.validate(published)?;
    let selection = Selection::new(figure, rows)?;
    match figure.kind {
        Kind::Lines => points(lines::values(figure, &selection, published)?, Vec::new()),
        Kind::Bars => {
            points(bars::values(figure, &selection, published)?.0, selection.bounds(figure)?)
        }
        Kind::Shares => shares(figure, &selection, published),
        Kind::Counts => Ok(Numbers::Counts(counted(figure, &selection, published))),
        Kind::Precision => Ok(Numbers::Dots(precision::values(figure, rows)?)),
        Kind::Heat => Ok(Numbers::Fields(fields(figure, &selection)?)),
    }
}

fn points(values: select::Values, bounds: Vec<Point>) -> Result<Numbers, ChartError> {
    let (ours, published, _) = values;
    Ok(Numbers::Points { ours, published, bounds })
}

fn shares(
    figure: &Figure,
    selection: &Selection<'_>,
    published: &Published,
) -> Result<Numbers, ChartError> {
    let upper = shares::upper(figure, selection, published)?;
    let column = figure.y_below.as_ref();
    let lower = match column.map(|column| shares::lower(figure, column, selection, published)) {
        Some(Ok(half)) => Some(half),
        Some(Err(ChartError::Nothing(_))) | None => None,
        Some(Err(error)) => return Err(error),
    };
    let (ours_below, published_below) =
        lower.map_or_else(Default::default, |half| (half.ours, half.published));
    Ok(Numbers::Shares {
        ours: upper.ours,
        published: upper.published,
        ours_below,
        published_below,
    })
}

fn counted(figure: &Figure, selection: &Selection<'_>, published: &Published) -> Vec<Count> {
    let theirs = select::published(figure, published, Measure::Count, &[String::new()]);
    let of_line = |line: &counts::Line| {
        let cells = counts::OPERATIONS.iter().zip(line.ours);
        let count = |((_, operation, words), ours): (&(_, &str, &'static str), Option<u64>)| {
            let wanted = |point: &&Point| point.series == line.name && point.x == *operation;
            let published = theirs.iter().find(wanted).map(|point| point.y);
            Count { series: line.name.clone(), operation: words, ours, published }
        };
        cells.map(count).collect::<Vec<_>>()
    };
    counts::lines(figure, selection).iter().flat_map(of_line).collect()
}

fn fields(figure: &Figure, selection: &Selection<'_>) -> Result<Vec<Field>, ChartError> {
    let shares = selection.points(figure, &figure.y)?;
    let shown = heat::shown(figure, selection, &shares)?;
    let columns = select::distinct(&shares, |point| &point.x);
    let (drawn, _) = heat::ordered(figure, &shares, columns.len());
    let field = |point: &Point| {
        let same = |other: &&Point| other.series == point.series && other.x == point.x;
        Field {
            series: point.series.clone(),
            x: point.x.clone(),
            share: point.y,
            shown: shown.iter().find(same).map(|point| point.y),
        }
    };
    Ok(shares.iter().filter(|point| drawn.contains(&point.series)).map(field).collect())
}

//! The `[[figure]]` table of an experiment: what is drawn from its rows.

use super::envelope::Envelope;
use super::wanted::{Wanted, admits};
use super::{ChartError, Published};
use crate::table::{COLUMNS, Row};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Which chart is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// One line per series over a numeric `x`, one panel per value of `panels`.
    Lines,
    /// Horizontal bars from zero, grouped by `x`, coloured by `series` (points on a log axis).
    Bars,
    /// Upright bars per category, and below them a second figure on the same categories.
    Shares,
    /// Operation counts of each series as a table, with the published ones beside them.
    Counts,
    /// Time over error, both logarithmic: which form to take for an error, or a time, that one can
    /// afford. One point per series and `precision`, those of a series joined.
    Precision,
    /// A field per `series` and `x`, coloured by `y` from 0 (dark) to 1 (light), `shown` in it.
    Heat,
}

/// How values are placed on the axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// Evenly.
    #[default]
    Linear,
    /// By their logarithm; values that are not above zero are left out and counted in the footer.
    Log,
}

/// Whose value `normalise_to` divides by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Within {
    /// That of the panel, at the first x.
    #[default]
    Panel,
    /// That of the panel at the same x.
    X,
}

/// One name, or a list of them.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum Names {
    /// `x = "density"`
    One(String),
    /// `x = ["precision", "level"]`
    Many(Vec<String>),
}

impl Default for Names {
    fn default() -> Self {
        Names::Many(Vec::new())
    }
}

impl Names {
    /// The names in their order.
    pub fn list(&self) -> &[String] {
        match self {
            Names::One(name) => std::slice::from_ref(name),
            Names::Many(names) => names,
        }
    }
}

/// Published figures to draw hollow beside ours.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Beside {
    /// Table in the file of published figures, for instance `table_4_1`.
    pub table: String,
    /// Said of them in the footer, for instance the machine they were measured on.
    #[serde(default)]
    pub note: String,
    /// The only panel that they belong in; all of them if it is not given.
    pub panel: Option<String>,
    /// The published name of a series to ours, where they differ: `{ moller = "moller1" }`.
    #[serde(default)]
    pub names: BTreeMap<String, String>,
}

/// One figure. Unknown keys are an error, so that a misspelt one is not silently without effect.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figure {
    /// File name without its ending: `b-4.1`.
    pub file: String,
    /// `lines`, `bars`, `shares`, `counts` or `heat`.
    pub kind: Kind,
    /// The title: the question that the figure answers.
    pub question: String,
    /// What is drawn, its unit, the conditions.
    #[serde(default)]
    pub subtitle: String,
    /// Column(s) of the horizontal axis (`lines`, one numeric column) or of the categories (`bars`,
    /// `shares`). Not used by `counts`.
    #[serde(default)]
    pub x: Names,
    /// Column of the figure drawn, numeric. Not used by `counts`.
    #[serde(default)]
    pub y: String,
    /// Further figures beside `y`, in its unit. `bars`: a bar is named by its column, and `series`
    /// must not be given. `lines`: a panel each, named by its column.
    #[serde(default)]
    pub also: Vec<String>,
    /// `shares` only: column of the lower chart; without it there is no lower chart.
    pub y_below: Option<String>,
    /// Title of the x axis, if the column's own will not do.
    pub x_title: Option<String>,
    /// Title of the y axis with its unit, if the column's own will not do.
    pub y_title: Option<String>,
    /// `shares` only: title of the lower chart's axis.
    pub y_below_title: Option<String>,
    /// Column(s) whose joined values name the line or the bar; default `kernel`.
    #[serde(default = "kernel")]
    pub series: Names,
    /// Column whose values make small multiples side by side. For `lines` and `bars`.
    pub panels: Option<String>,
    /// Column to value or list of values: only rows that match all are drawn.
    #[serde(default)]
    pub filter: BTreeMap<String, Wanted>,
    /// Published figures, drawn hollow.
    pub published: Option<Beside>,
    /// `linear` (default) or `log`: the axis of `y`.
    #[serde(default)]
    pub scale: Scale,
    /// `linear` (default) or `log`: the axis of `x`, for `lines`.
    #[serde(default)]
    pub x_scale: Scale,
    /// `lines`, `bars`: divide each panel's values, and the published ones, by that of the series
    /// named here at its first x, so that times of different machines share an axis. `shares`: the
    /// category whose lower figure is 1.
    pub normalise_to: Option<String>,
    /// `bars` with `normalise_to` only: `panel` (default), or `x` to divide by the value at the same
    /// x, so that each category has a unit of its own.
    #[serde(default)]
    pub normalise: Within,
    /// A value of y at which a line is drawn across, for instance 1 for ratios.
    pub reference: Option<f64>,
    /// `lines` only: column(s) of values of x at which an upright line is drawn, named by its label.
    #[serde(default)]
    pub x_marks: Names,
    /// Column over whose values rows are put together, for instance `seed`, for `lines` and `bars`:
    /// one point for all of them, at the median, with the smallest and the largest as its interval.
    pub over: Option<String>,
    /// `precision` only: column of a lower quantile of the error than `x`, for its whisker.
    pub x_low: Option<String>,
    /// `precision` only: column of a higher quantile of it.
    pub x_high: Option<String>,
    /// `precision` only: errors are taken from the rows that this filter lets through, joined to
    /// those of the times by their id. Without it, both are of the same row.
    #[serde(default)]
    pub errors_from: BTreeMap<String, Wanted>,
    /// `lines` only: what may be expected of every series.
    pub envelope: Option<Envelope>,
    /// `bars` on a log axis only: column of the bound that stands, hollow, where `y` is 0.
    pub bound: Option<String>,
    /// `heat` only: column of the number in each field; a dash where it is empty.
    pub shown: Option<String>,
    /// `heat` only: the series that stands first, apart from the others.
    pub apart: Option<String>,
    /// Value as stored to the words shown for it, for series, panels and categories.
    #[serde(default)]
    pub labels: BTreeMap<String, String>,
    /// Whether question and subtitle stand in the page around the picture, and not in it. For
    /// programs: no configuration sets it.
    #[serde(skip)]
    pub bare: bool,
}

fn kernel() -> Names {
    Names::One("kernel".to_owned())
}

impl Figure {
    /// Refuses what cannot be drawn whatever the rows are; names the key and what is allowed.
    pub fn validate(&self, published: &Published) -> Result<(), ChartError> {
        let safe = |c: char| c.is_ascii_alphanumeric() || "-._".contains(c);
        if self.file.is_empty() || self.file.starts_with('.') || !self.file.chars().all(safe) {
            return Err(self.wrong("file", &self.file, "letters, digits, '-', '_' and '.'"));
        }
        if self.question.trim().is_empty() {
            return Err(self.wrong("question", "", "a question that the figure answers"));
        }
        for column in self.series.list() {
            self.column("series", column)?;
        }
        for column in self.filter.keys() {
            self.column("filter", column)?;
        }
        if let Some(column) = &self.panels {
            self.column("panels", column)?;
        }
        if let Some(column) = &self.over {
            self.column("over", column)?;
        }
        if let Some(beside) = &self.published {
            let tables = published.tables();
            if !tables.contains(&beside.table.as_str()) {
                return Err(self.wrong("published.table", &beside.table, &tables.join(", ")));
            }
        }
        self.validate_use()?;
        if self.kind == Kind::Counts { Ok(()) } else { self.validate_axes() }
    }

    fn validate_axes(&self) -> Result<(), ChartError> {
        self.numeric_column("y", &self.y)?;
        self.also.iter().try_for_each(|column| self.numeric_column("also", column))?;
        for column in self.bound.iter().chain(&self.shown) {
            self.numeric_column("bound, shown", column)?;
        }
        if let Some(envelope) = &self.envelope {
            envelope
                .columns
                .iter()
                .try_for_each(|column| self.numeric_column("envelope", column))?;
        }
        for column in self.x_marks.list() {
            self.numeric_column("x_marks", column)?;
        }
        if let Some(column) = &self.y_below {
            self.numeric_column("y_below", column)?;
        }
        for column in self.x_low.iter().chain(&self.x_high) {
            self.numeric_column("x_low, x_high", column)?;
        }
        self.errors_from.keys().try_for_each(|column| self.column("errors_from", column))?;
        if matches!(self.kind, Kind::Lines | Kind::Precision) {
            let [column] = self.x.list() else {
                let allowed = "one numeric column for lines and precision";
                return Err(self.wrong("x", &self.x.list().join(", "), allowed));
            };
            return self.numeric_column("x", column);
        }
        if self.x.list().is_empty() {
            return Err(self.wrong("x", "", "at least one column"));
        }
        self.x.list().iter().try_for_each(|column| self.column("x", column))
    }

    fn column(&self, key: &'static str, column: &str) -> Result<(), ChartError> {
        if COLUMNS.contains(&column) {
            Ok(())
        } else {
            Err(self.wrong(key, column, &COLUMNS.join(", ")))
        }
    }

    fn numeric_column(&self, key: &'static str, column: &str) -> Result<(), ChartError> {
        // A column that takes a word is not numeric.
        let numeric = |column: &str| Row::default().set(column, "word").is_err();
        if numeric(column) {
            return Ok(());
        }
        let allowed: Vec<_> = COLUMNS.iter().copied().filter(|column| numeric(column)).collect();
        Err(self.wrong(key, column, &allowed.join(", ")))
    }

    pub(super) fn wrong(&self, key: &'static str, value: &str, allowed: &str) -> ChartError {
        let (figure, value, allowed) = (self.file.clone(), value.to_owned(), allowed.to_owned());
        ChartError::Wrong { figure, key, value, allowed }
    }

    /// Whether the filter lets a row through.
    pub fn admits(&self, row: &Row) -> bool {
        admits(&self.filter, row)
    }

    /// Whether errors may be taken from a row.
    pub fn admits_errors(&self, row: &Row) -> bool {
        admits(&self.errors_from, row)
    }

    /// What the footer says of marks that show intervals.
    pub fn intervals(&self, marks: &str) -> String {
        match &self.over {
            None => format!("{marks}: intervals"),
            Some(over) => format!("{marks}: smallest to largest over {}s", over.replace('_', " ")),
        }
    }
}

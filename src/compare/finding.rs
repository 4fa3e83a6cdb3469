//! What a comparison finds.

use serde::Serialize;
use serde_json::Value;

use crate::table::{Cell, Row};

/// The verdict of a whole comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Nothing changed beyond the threshold.
    Same,
    /// Something got better, and nothing worse.
    Improved,
    /// Something got worse, and the two halves of the rounds agree on it.
    Regressed,
    /// Nothing is known to be worse, and not everything is known not to be.
    Unresolved,
    /// The two cannot be compared.
    Refused,
}

impl Verdict {
    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Same => "same",
            Verdict::Improved => "improved",
            Verdict::Regressed => "regressed",
            Verdict::Unresolved => "unresolved",
            Verdict::Refused => "refused",
        }
    }
}

/// Where something was found. An empty string and `None` are missing values.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// The variant, or the kernel where a row is about no variant.
    pub id: String,
    /// The experiment.
    pub experiment: String,
    /// The workload.
    pub workload: String,
    /// Order of the tests.
    pub order: String,
    /// Share of the pairs that hit.
    pub density: Option<f64>,
    /// Return code that the row is about.
    pub code: Option<u64>,
}

impl Place {
    /// Of a row.
    pub(super) fn of(row: &Row) -> Self {
        Place {
            id: if row.id.is_empty() { &row.kernel } else { &row.id }.clone(),
            experiment: row.experiment.clone(),
            workload: row.workload.clone(),
            order: row.order.clone(),
            density: row.density,
            code: row.code,
        }
    }
}

/// A figure that changed, and where.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// Where.
    #[serde(flatten)]
    pub place: Place,
    /// What changed and by how much.
    #[serde(flatten)]
    pub change: Change,
}

impl Finding {
    /// How far the ratio is from 1 as |ln|; infinite where there is none: a decision that changed
    /// is worse than any time.
    pub(super) fn size(&self) -> f64 {
        self.change.ratio.map_or(f64::INFINITY, |ratio| ratio.ln().abs())
    }
}

/// A figure that changed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    /// The column.
    pub figure: &'static str,
    /// New over base, > 0; `None` where there is no such quotient.
    pub ratio: Option<f64>,
    /// Lower end of the ratio's interval; a figure without a clock has none.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
    /// Value in the base.
    pub base: Value,
    /// Value in the new one.
    pub new: Value,
}

impl Change {
    /// Of a column, without a ratio.
    pub(super) fn of(figure: &'static str, base: &Row, new: &Row) -> Self {
        let value = |row: &Row| row.cell(figure).map_or(Value::Null, value_of);
        let (base, new) = (value(base), value(new));
        Change { figure, ratio: None, low: None, high: None, base, new }
    }

    /// The change at a place.
    pub(super) fn at(self, place: &Place) -> Finding {
        Finding { place: place.clone(), change: self }
    }
}

fn value_of(cell: Cell<'_>) -> Value {
    match cell {
        Cell::Missing => Value::Null,
        Cell::Text(text) => text.into(),
        Cell::Count(count) => count.into(),
        Cell::Number(number) => number.into(),
    }
}

/// What is said of one figure of a cell, or of its time.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Judged {
    /// Worse, for certain.
    Worse(Change),
    /// Better, for certain.
    Better(Change),
    /// It cannot be told.
    Unresolved(Change),
    /// No change.
    Same,
}

/// Something in which the two differ, so that their figures are about different things.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Refusal {
    /// What differs: a column, or a field of the environment.
    pub key: &'static str,
    /// Its value in the base; `None` where it has none.
    pub base: Option<String>,
    /// Its value in the new one.
    pub new: Option<String>,
    /// The first place where it differs.
    #[serde(rename = "where")]
    pub place: String,
}

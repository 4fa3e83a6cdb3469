//! A claim as a ledger holds it.

use super::bound::Bound;
use super::expression::Expression;
use crate::chart::{Names, Wanted};
use serde::Deserialize;
use std::collections::BTreeMap;

/// A published statement, and what would show it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// Id, for instance `B-4.1a`.
    pub id: String,
    /// Where it is made.
    pub source: String,
    /// The statement, in our words.
    pub statement: String,
    /// The published figures as text, for parts that have none of their own.
    #[serde(default)]
    pub published: String,
    /// Columns whose values are separate conditions; those of the file if they are not given. None where
    /// no clock is involved.
    pub conditions: Option<Vec<String>>,
    /// The conditions that the claim itself is about; those of the file if they are not given.
    pub decides: Option<Vec<String>>,
    /// A sentence by condition, to show where its verdict is the opposite of the deciding one.
    #[serde(default)]
    pub explains: BTreeMap<String, String>,
    /// What would decide it, shown where it is undecided.
    #[serde(default)]
    pub wants: String,
    /// What of the statement has no part, so that the claim is undecided even where all parts hold.
    #[serde(default)]
    pub untested: String,
    /// Why no experiment can decide it; such a claim has no parts.
    #[serde(default)]
    pub not_testable: String,
    /// Fewest machines; from 2 on the claim compares them.
    #[serde(default = "one")]
    pub machines: usize,
    /// Figures from rows, or printed ones, by name.
    #[serde(default)]
    pub series: BTreeMap<String, SeriesOf>,
    /// Formulas that others may name.
    #[serde(default, rename = "let")]
    pub formulas: BTreeMap<String, String>,
    /// What must hold, all of it.
    #[serde(default)]
    pub part: Vec<Part>,
    /// `let`, read.
    #[serde(skip)]
    pub(super) read: BTreeMap<String, Expression>,
}

fn one() -> usize {
    1
}

/// Where figures come from.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SeriesOf {
    /// The experiment, or several.
    #[serde(default)]
    pub experiment: Names,
    /// Column to value or list of values: only rows that match all count. A condition's column may be
    /// among them: then the series is the same under every condition.
    #[serde(default)]
    pub filter: BTreeMap<String, Wanted>,
    /// The column of the figure.
    #[serde(default)]
    pub value: String,
    /// Columns whose values are the key.
    #[serde(default)]
    pub along: Names,
    /// Column over whose values rows are put together: their median, with the smallest and the
    /// largest as its interval. Of six that is the interval of the sign test.
    pub over: Option<String>,
    /// Keys that have the figure `otherwise` where there is no row of theirs, but rows of others.
    #[serde(default)]
    pub keys: Vec<String>,
    /// The figure of `keys` without a row.
    pub otherwise: Option<f64>,
    /// Whether rows with a wrong answer count, too: for counts of wrong answers.
    #[serde(default)]
    pub wrong_too: bool,
    /// Printed figures by key, instead of an experiment.
    #[serde(default)]
    pub values: BTreeMap<String, f64>,
}

/// A figure and its bound.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// What is measured, in words.
    pub what: String,
    /// The formula.
    pub measure: String,
    /// It holds below this.
    pub below: Option<f64>,
    /// It holds above this.
    pub above: Option<f64>,
    /// It holds from this on.
    pub at_least: Option<f64>,
    /// It holds up to this.
    pub at_most: Option<f64>,
    /// It holds at exactly this.
    pub equals: Option<f64>,
    /// It holds from the first to the second, ends included.
    pub between: Option<[f64; 2]>,
    /// The figure as it was printed.
    pub published: Option<f64>,
    /// Whether different codes are compared by time: then the interval is widened by the largest
    /// `noise_floor` of the rows, which is what copies of the same code differ by where they lie
    /// elsewhere in memory.
    #[serde(default)]
    pub noise: bool,
    /// Whether it can only speak for the claim: where it does not hold, that shows nothing.
    #[serde(default)]
    pub one_sided: bool,
    /// Whether it is left out where it has no rows.
    #[serde(default)]
    pub optional: bool,
    /// `measure`, read.
    #[serde(skip)]
    pub(super) formula: Option<Expression>,
    /// The one bound that is given.
    #[serde(skip)]
    pub(super) bound: Bound,
}

impl Claim {
    /// Whether no experiment can decide it.
    pub fn is_testable(&self) -> bool {
        self.not_testable.is_empty()
    }

    /// Columns whose values are separate conditions.
    pub(super) fn columns(&self) -> &[String] {
        self.conditions.as_deref().unwrap_or_default()
    }

    /// Experiments whose rows it is judged by, each once.
    pub fn experiments(&self) -> Vec<&str> {
        let mut all: Vec<&str> = Vec::new();
        for experiment in self.series.values().flat_map(|series| series.experiment.list()) {
            if !all.contains(&experiment.as_str()) {
                all.push(experiment);
            }
        }
        all
    }
}

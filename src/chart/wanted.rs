//! Which rows a filter lets through.

use crate::table::{Cell, Row};
use serde::Deserialize;
use std::collections::BTreeMap;

/// A value that a filter lets through.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum Wanted {
    /// Any of these.
    Any(Vec<Wanted>),
    /// This number.
    Number(f64),
    /// This word; `""` is an empty cell.
    Word(String),
}

impl Wanted {
    fn admits(&self, cell: Cell<'_>) -> bool {
        match self {
            Wanted::Any(values) => values.iter().any(|value| value.admits(cell)),
            Wanted::Number(number) => cell.number() == Some(*number),
            Wanted::Word(word) => cell.to_string() == *word,
        }
    }
}

/// Whether a row has a wanted value in every column of a filter.
pub fn admits(filter: &BTreeMap<String, Wanted>, row: &Row) -> bool {
    filter.iter().all(|(column, wanted)| row.cell(column).is_some_and(|cell| wanted.admits(cell)))
}

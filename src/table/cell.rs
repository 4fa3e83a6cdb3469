//! One value of a row, whatever its type.

use serde::ser::{Serialize, Serializer};
use std::fmt;

/// One value of a row. A number that is not finite is a missing one: no NaN or inf is ever written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell<'a> {
    /// No value: an empty cell in CSV, `null` in JSON.
    Missing,
    /// A word.
    Text(&'a str),
    /// A count.
    Count(u64),
    /// A finite figure.
    Number(f64),
}

impl Cell<'_> {
    /// The value as a number, where it is one.
    pub fn number(self) -> Option<f64> {
        match self {
            Cell::Count(count) => Some(count as f64),
            Cell::Number(number) => Some(number),
            Cell::Missing | Cell::Text(_) => None,
        }
    }
}

/// Shortest text that reads back to the same value; empty if missing.
impl fmt::Display for Cell<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Cell::Missing => Ok(()),
            Cell::Text(text) => f.write_str(text),
            Cell::Count(count) => write!(f, "{count}"),
            // Plain digits get long for the errors of f64, so those are written with an exponent.
            Cell::Number(n) if *n != 0.0 && !(1e-5..1e16).contains(&n.abs()) => write!(f, "{n:e}"),
            Cell::Number(n) => write!(f, "{n}"),
        }
    }
}

impl Serialize for Cell<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Cell::Missing => serializer.serialize_none(),
            Cell::Text(text) => serializer.serialize_str(text),
            Cell::Count(count) => serializer.serialize_u64(*count),
            Cell::Number(number) => serializer.serialize_f64(*number),
        }
    }
}

/// What numbers a column has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bound {
    /// Any.
    None,
    /// None below 0: times, rates, shares, ratios of such, and how large an error is.
    NotNegative,
}

/// What a field of a row can be.
pub(super) trait Field: Sized {
    /// The value of the field.
    fn cell(&self) -> Cell<'_>;
    /// The field from its text; the error says what is allowed. The bound is for numbers with a sign.
    fn parse(text: &str, bound: Bound) -> Result<Self, &'static str>;
}

impl Field for String {
    fn cell(&self) -> Cell<'_> {
        if self.is_empty() { Cell::Missing } else { Cell::Text(self) }
    }

    fn parse(text: &str, _: Bound) -> Result<Self, &'static str> {
        Ok(text.to_owned())
    }
}

impl Field for Option<u64> {
    fn cell(&self) -> Cell<'_> {
        self.map_or(Cell::Missing, Cell::Count)
    }

    fn parse(text: &str, _: Bound) -> Result<Self, &'static str> {
        if text.is_empty() {
            return Ok(None);
        }
        text.parse().map(Some).map_err(|_| "a whole number that is not negative, or nothing")
    }
}

impl Field for Option<f64> {
    fn cell(&self) -> Cell<'_> {
        self.filter(|number| number.is_finite()).map_or(Cell::Missing, Cell::Number)
    }

    fn parse(text: &str, bound: Bound) -> Result<Self, &'static str> {
        if text.is_empty() {
            return Ok(None);
        }
        // Rust reads "NaN" and "inf" as numbers; the format has neither.
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        match bound {
            Bound::None => number.map(Some).ok_or("a finite number, or nothing"),
            Bound::NotNegative => {
                let number = number.filter(|number| *number >= 0.0);
                number.map(Some).ok_or("a finite number that is not negative, or nothing")
            }
        }
    }
}

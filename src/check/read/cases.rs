//! Cases from a file.

use super::error::ReadError;
use super::records::{Records, Schema};
use crate::check::{Case, NUMBERS, Number};
use std::io::BufRead;

const NAMES: [&str; 18] = {
    let mut names = ["id"; 18];
    let mut index = 0;
    while index < NUMBERS.len() {
        names[index] = NUMBERS[index];
        index += 1;
    }
    names
};
/// Origin, direction and vertices must be there; the range of t and the id may.
const SCHEMA: Schema = Schema { names: &NAMES, required: 15 };
const ID: usize = 17;
/// The range of t where none is given.
const RANGE: [f64; 2] = [0.0, f64::INFINITY];

/// Reads case after case.
pub struct Cases<R> {
    records: Records<R>,
    count: u64,
}

impl<R: BufRead> Cases<R> {
    /// `file` is what messages call the input.
    pub fn new(input: R, file: &str) -> Self {
        Cases { records: Records::new(input, file, SCHEMA), count: 0 }
    }

    /// The next case; `None` behind the last. Without an id it is named by its number, from 1.
    ///
    /// # Errors
    /// When there is no case at all, or the next is not one: where, and what is allowed.
    pub fn advance(&mut self) -> Result<Option<Case>, ReadError> {
        if !self.records.advance()? {
            if self.count == 0 {
                let message = "no case; allowed: CSV with a header and at least one row, or JSON \
                               lines";
                return Err(self.records.whole(message.into()));
            }
            return Ok(None);
        }
        self.count += 1;
        let mut numbers = [Number::from(0.0); 17];
        for (index, number) in numbers.iter_mut().enumerate() {
            *number = match (self.records.text(index), index.checked_sub(SCHEMA.required)) {
                (None, Some(bound)) => Number::from(RANGE[bound]),
                (text, _) => text
                    .and_then(Number::read)
                    .ok_or_else(|| self.records.bad(index, "a number, nan or inf"))?,
            };
        }
        let id = self.records.text(ID).map_or_else(|| self.count.to_string(), str::to_owned);
        Ok(Some(Case { id, numbers }))
    }
}

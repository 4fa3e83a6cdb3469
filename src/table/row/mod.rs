//! One row: one variant on one workload cell, every axis a column, then figures.

mod contract;
mod exactness;
mod searches;
mod sweeps;
mod timing;

use super::cell::{Bound, Cell, Field};
use super::columns::columns;
use contract::contract_columns;
use exactness::exactness_columns;
use searches::searches_columns;
use sweeps::sweeps_columns;
use timing::timing_columns;

use serde::ser::{Serialize, SerializeMap, Serializer};

/// How many of [`COLUMNS`] the contract asks for; a file without one of them is refused.
pub const REQUIRED: usize = 48;

// One list in five files, each of which adds to it what is before it.
contract_columns! {
    [timing_columns exactness_columns sweeps_columns searches_columns columns] {}
}

impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (place, column) in COLUMNS.iter().enumerate() {
            let cell = self.cell(column).unwrap_or(Cell::Missing);
            // The contract's columns are always there, but for the many rows of a sweep without a
            // clock, most of which are about a clock. Of ours, an empty one would only take room.
            let is_timed = self.record.is_empty() || self.ns_per_test.is_some();
            let always = place < REQUIRED && is_timed;
            if always || cell != Cell::Missing {
                map.serialize_entry(column, &cell)?;
            }
        }
        map.end()
    }
}

//! A figure's numbers: as a table to read, best first, and as CSV, unrounded.

mod dump;
mod table;

pub use dump::figure_csv;
pub(super) use table::table;

use crate::chart::{Dot, Standing};

/// Cells under a header.
#[derive(Default)]
pub(super) struct Table {
    pub head: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

fn standing(dot: &Dot) -> &'static str {
    match dot.standing {
        Standing::Front => "front",
        Standing::Dominated => "dominated",
        Standing::Apart(_) => "set apart",
    }
}

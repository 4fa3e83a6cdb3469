//! Which columns say what a row is about.

use super::Row;

/// Columns that say what was measured, besides the id.
pub const SUBJECT_COLUMNS: [&str; 26] = [
    "experiment",
    "kernel",
    "precision",
    "drive",
    "exit",
    "division",
    "rounding",
    "output",
    "layout",
    "stored",
    "cull",
    "tests_form",
    "reciprocal",
    "edges",
    "projection",
    "dot",
    "cross",
    "leading",
    "code",
    "priced",
    "err_against",
    "record",
    "family",
    "ray_class",
    "structure",
    "variation",
];

/// Columns that say on what it was measured. One subject under other settings than before is not
/// the same measurement.
pub const SETTING_COLUMNS: [&str; 15] = [
    "level",
    "workload",
    "order",
    "density",
    "spread",
    "triangles",
    "rays",
    "generator",
    "winding",
    "query",
    "repeats",
    "seed",
    "knob",
    "rays_per_triangle",
    "scene",
];

impl Row {
    /// The values of some columns as text; empty where there is none.
    pub fn texts(&self, columns: &[&str]) -> Vec<String> {
        let text =
            |column: &&str| self.cell(column).map(|cell| cell.to_string()).unwrap_or_default();
        columns.iter().map(text).collect()
    }
}

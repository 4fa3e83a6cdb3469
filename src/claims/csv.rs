//! Findings as CSV.

use super::Finding;
use crate::table::Cell;

/// The columns of `claims.csv`.
pub const COLUMNS: [&str; 10] = [
    "id",
    "source",
    "statement",
    "published",
    "measured",
    "low",
    "high",
    "condition",
    "verdict",
    "details",
];

/// `claims.csv`: a header, then a row per claim and condition. Missing values are empty cells.
pub fn to_csv(findings: &[Finding]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut writer = csv::Writer::from_writer(&mut bytes);
    // Writing into memory cannot fail, and every record has the same number of cells.
    let _ = writer.write_record(COLUMNS);
    for finding in findings {
        let number = |value: Option<f64>| value.map_or(Cell::Missing, Cell::Number).to_string();
        let _ = writer.write_record([
            finding.id.clone(),
            finding.source.clone(),
            finding.statement.clone(),
            finding.published.clone(),
            number(finding.measured),
            number(finding.low),
            number(finding.high),
            finding.condition.clone(),
            finding.verdict.word().to_owned(),
            finding.details.clone(),
        ]);
    }
    let _ = writer.flush();
    drop(writer);
    bytes
}

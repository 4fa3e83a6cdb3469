//! Rows, charts and verdicts -> HTML, Markdown, terminal: answers first, then what they rest on.
//!
//! ```text
//! results, findings ─> page (what is said) ─> templates (how it looks)
//!                       ├ answers, trust, ledger: the top
//!                       └ chapter ─> figure ─> picture, sentence, table
//! ```
//! The same results give the same bytes.

mod answers;
mod chapter;
mod cited;
mod figure;
mod ledger;
mod machine;
mod numbers;
mod page;
mod robust;
mod sense;
mod sentence;
mod terminal;
#[cfg(test)]
mod tests;
mod trust;
mod words;

pub use numbers::figure_csv;
pub use terminal::terminal;

use crate::chart::ChartError;
use crate::claims::Finding;
use crate::results::Results;
use askama::Template;
use page::Page;

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The published figures cannot be read, or a placeholder could not be drawn.
    #[error("report: {0}")]
    Chart(#[from] ChartError),
    /// A template could not be filled.
    #[error("report: {0}")]
    Template(#[from] askama::Error),
    /// Figures could not be written as CSV.
    #[error("report: {0}")]
    Csv(#[from] csv::Error),
}

#[derive(Template)]
#[template(path = "report.html")]
struct Html<'a> {
    page: &'a Page,
}

#[derive(Template)]
#[template(path = "report.md", escape = "none")]
struct Markdown<'a> {
    page: &'a Page,
}

/// The report as one HTML file: pictures inside, no script, nothing fetched. Links lead to files
/// beside it (`<experiment>/rows.csv`, `<experiment>/<figure>.csv`).
///
/// # Errors
/// The published figures cannot be read, or a template cannot be filled.
pub fn html(results: &Results, findings: &[Finding]) -> Result<String, ReportError> {
    let page = Page::new(results, findings, true)?;
    Ok(Html { page: &page }.render()?)
}

/// The report in GitHub's Markdown; pictures are the files beside it.
///
/// # Errors
/// As [`html`].
pub fn markdown(results: &Results, findings: &[Finding]) -> Result<String, ReportError> {
    let page = Page::new(results, findings, false)?;
    Ok(Markdown { page: &page }.render()?)
}

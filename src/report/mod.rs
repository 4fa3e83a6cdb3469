//! Rows, charts and verdicts -> HTML, Markdown, terminal: answers first, then what they rest on.
//!
//! ```text
//! results, findings ─> page (what is said) ─> templates, terminal (how it looks)
//!                       ├ answers (chosen by `recommend`), trust, ledger: the top
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
mod sense;
mod sentence;
mod stiff;
mod terminal;
#[cfg(test)]
mod tests;
mod trust;
mod words;

pub use numbers::figure_csv;
pub(crate) use words::count;

use crate::chart::ChartError;
use crate::claims::Finding;
use crate::recommend::KnownVariant;
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

/// Everything that is said of results, ready to be shown in three ways.
pub struct Report(Page);

impl Report {
    /// Puts it together, pictures and all. `known` is what the program knows of its variants, as
    /// [`recommend`](crate::recommend::recommend) takes it.
    ///
    /// # Errors
    /// The published figures cannot be read, or rows not be written.
    pub fn new(
        results: &Results,
        findings: &[Finding],
        known: &[KnownVariant],
    ) -> Result<Self, ReportError> {
        Ok(Report(Page::new(results, findings, known)?))
    }

    /// The report as one HTML file: pictures inside, no script, nothing fetched. Links lead to files
    /// beside it (`<experiment>/rows.csv`, `<experiment>/<figure>.csv`).
    ///
    /// # Errors
    /// The template cannot be filled.
    pub fn html(&self) -> Result<String, ReportError> {
        Ok(Html { page: &self.0 }.render()?)
    }

    /// The report in GitHub's Markdown; pictures are the files beside it.
    ///
    /// # Errors
    /// As [`Report::html`].
    pub fn markdown(&self) -> Result<String, ReportError> {
        Ok(Markdown { page: &self.0 }.render()?)
    }

    /// The answers in at most 100 columns, without colours: which kernel to take, how many claims
    /// hold and which do not, how trustworthy the run was.
    pub fn terminal(&self) -> String {
        terminal::text(&self.0)
    }
}

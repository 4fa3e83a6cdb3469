//! Chapters that no experiment measures: computed from the rows of others.

pub use super::mixture::mixture;

use super::{About, Chapter};
use crate::chart::Figure;
use crate::table::Row;
use serde::Deserialize;
use std::collections::BTreeMap;

/// The words and figures of such a chapter, as a file in `configs/derived` has them.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Words {
    id: String,
    title: String,
    #[serde(default)]
    mirrors: String,
    question: String,
    why: String,
    #[serde(default)]
    claims: Vec<String>,
    #[serde(default)]
    figure: Vec<Figure>,
    /// Words shown for values, in every figure that has no others for them.
    #[serde(default)]
    labels: BTreeMap<String, String>,
}

/// The description in a file's text.
///
/// # Errors
/// What the text has and may not have, and where.
pub(super) fn about(text: &str) -> Result<About, toml::de::Error> {
    let words: Words = toml::from_str(text)?;
    let mut figures = words.figure;
    for figure in &mut figures {
        for (value, label) in &words.labels {
            figure.labels.entry(value.clone()).or_insert_with(|| label.clone());
        }
    }
    Ok(About {
        config: format!("configs/derived/{}.toml", words.id),
        // No run makes it: it comes with every report of what it is computed from.
        command: String::new(),
        id: words.id,
        title: words.title,
        mirrors: words.mirrors,
        question: words.question,
        why: words.why,
        claims: words.claims,
        figures,
    })
}

/// A chapter of those rows, computed from these other chapters; none without rows.
pub(super) fn chapter(about: About, rows: Vec<Row>, of: &[&Chapter]) -> Option<Chapter> {
    let hashes = of.iter().map(|chapter| chapter.workload_hash.as_str());
    let workload_hash = hashes.collect::<Vec<_>>().join("+");
    let complete = of.iter().all(|chapter| chapter.complete);
    (!rows.is_empty()).then_some(Chapter { about, rows, complete, workload_hash })
}

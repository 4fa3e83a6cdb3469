//! The recommendation.

use super::RecommendError;
use super::because::{measured_on, sentences};
use super::candidates::Candidate;
use super::found::{Cost, Found, find};
use super::question::{KnownVariant, Question};
use crate::results::Results;
use serde::Serialize;

/// What to take, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Recommendation {
    /// Id of the variant.
    pub variant: String,
    /// Sentences with the figures and the rows that they are from.
    pub because: Vec<String>,
    /// Id of the next best; none if nothing else fits.
    pub runner_up: Option<String>,
    /// What it takes longer, percent of the variant's time.
    pub runner_up_costs_percent: Option<f64>,
    /// Lower end of the interval of it.
    pub runner_up_costs_low_percent: Option<f64>,
    /// Upper end of it.
    pub runner_up_costs_high_percent: Option<f64>,
    /// Whether rows can tell the two apart.
    pub runner_up_is_slower: Option<bool>,
    /// Lines of Rust that call the variant.
    pub code: String,
}

/// The variant to take by these rows.
///
/// # Errors
/// Where there are no times, or nothing that was timed fits.
pub fn recommend(
    results: &Results,
    question: &Question,
    known: &[KnownVariant],
) -> Result<Recommendation, RecommendError> {
    Ok(put(&find(results, None, question, known)?))
}

fn put(found: &Found<'_>) -> Recommendation {
    let best = found.best();
    let next = found.arena().ranked.get(1);
    let cost = next.map(|next| Cost::of(next, best));
    let percent = |share: fn(&Cost) -> f64| cost.as_ref().map(|cost| share(cost) * 100.0);
    let id = |candidate: &Candidate<'_>| candidate.known.id.clone();
    Recommendation {
        variant: id(&best.candidate),
        because: sentences(found).into_iter().chain([measured_on(found)]).collect(),
        runner_up: next.map(|next| id(&next.candidate)),
        runner_up_costs_percent: percent(|cost| cost.share),
        runner_up_costs_low_percent: percent(|cost| cost.low),
        runner_up_costs_high_percent: percent(|cost| cost.high),
        runner_up_is_slower: cost.map(|cost| cost.is_measurable),
        code: best.candidate.known.call.clone(),
    }
}

//! Claims and rows -> findings.

use super::bound::{Bound, Side};
use super::claim::{Claim, Part};
use super::conditions::{Condition, conditions, machines};
use super::estimate::Estimate;
use super::evaluate::Scope;
use super::holm::{self, Member};
use super::lack::Lack;
use super::ledger::Ledger;
use super::words::{shown, shown_with_interval};
use super::{Finding, Verdict};
use crate::table::Row;

/// Every claim under every condition: in the order of the ledger, then of the conditions (literal, fixed,
/// reshuffled, then machines).
pub fn judge(ledger: &Ledger, rows: &[&Row]) -> Vec<Finding> {
    ledger.claims().iter().flat_map(|claim| of_claim(claim, rows)).collect()
}

/// The findings of one claim.
pub fn of_claim(claim: &Claim, rows: &[&Row]) -> Vec<Finding> {
    if !claim.is_testable() {
        return vec![blank(claim, Verdict::NotTestable, claim.not_testable.clone())];
    }
    let experiments = claim.experiments();
    let rows: Vec<&Row> =
        rows.iter().copied().filter(|row| experiments.contains(&row.experiment.as_str())).collect();
    let judged: Vec<(Condition, Finding)> = conditions(claim, &rows)
        .into_iter()
        .map(|condition| {
            let finding = of_condition(claim, &condition, &rows);
            (condition, finding)
        })
        .collect();
    let decided = judged.iter().find(|(_, finding)| finding.decides).map(|(_, f)| f.verdict);
    let explained = |(condition, mut finding): (Condition, Finding)| {
        let opposite = match finding.verdict {
            Verdict::Reproduced => Some(Verdict::NotReproduced),
            Verdict::NotReproduced => Some(Verdict::Reproduced),
            _ => None,
        };
        if opposite.is_some() && decided == opposite {
            for sentence in condition.values().filter_map(|value| claim.explains.get(value)) {
                finding.details += ". ";
                finding.details += sentence;
            }
        }
        finding
    };
    judged.into_iter().map(explained).collect()
}

/// A finding without a figure.
fn blank(claim: &Claim, verdict: Verdict, details: String) -> Finding {
    Finding {
        id: claim.id.clone(),
        source: claim.source.clone(),
        statement: claim.statement.clone(),
        published: claim.published.clone(),
        measured: None,
        low: None,
        high: None,
        condition: String::new(),
        verdict,
        details,
        decides: true,
    }
}

/// A part with what became of it.
struct Outcome<'a> {
    part: &'a Part,
    found: Result<holm::Judged, Lack>,
}

fn of_condition(claim: &Claim, condition: &Condition, rows: &[&Row]) -> Finding {
    let scope = Scope::new(claim, |series| condition.rows_of(claim, series, rows));
    let named = |finding: Finding| Finding {
        condition: condition.name(),
        decides: condition.decides(claim),
        ..finding
    };
    let count = if rows.is_empty() { 0 } else { machines(rows).len() };
    if claim.machines > count && count > 0 {
        let details = format!(
            "there are results of {count} machine; it needs results of {} or more machines: \
             `ray_test report DIR1 DIR2`",
            claim.machines
        );
        return named(blank(claim, Verdict::Undecided, details));
    }
    let outcomes = outcomes(claim, &scope);
    let mut verdict = verdict(&outcomes);
    let mut details: Vec<String> = outcomes.iter().map(words).collect();
    if verdict == Verdict::Reproduced && !claim.untested.is_empty() {
        verdict = Verdict::Undecided;
        details.push(claim.untested.clone());
    }
    if verdict == Verdict::Undecided
        && let Some(wanted) = wanted(claim, &outcomes)
    {
        details.push(format!("what would decide it: {wanted}"));
    }
    let finding = blank(claim, verdict, details.join("; "));
    named(with_nearest(finding, &outcomes))
}

/// Every part, judged together with the others.
fn outcomes<'a>(claim: &'a Claim, scope: &Scope<'_>) -> Vec<Outcome<'a>> {
    let figure = |part: &Part, comparisons: usize| -> Result<Estimate, Lack> {
        let lack = || Lack::new("there is no formula");
        let formula = part.formula.as_ref().ok_or_else(lack)?;
        let found = scope.figure(formula, comparisons)?;
        let noise = if part.noise { scope.noise_floor(formula) } else { 0.0 };
        Ok(found.loosened(noise))
    };
    let mut outcomes: Vec<Outcome<'a>> = Vec::new();
    let mut family = Vec::new();
    let mut places = Vec::new();
    for part in &claim.part {
        let found = figure(part, 1);
        match found {
            Err(_) if part.optional => continue,
            Err(lack) => outcomes.push(Outcome { part, found: Err(lack) }),
            Ok(alone) => {
                // A wider interval can be too wide to compute with; then it says nothing.
                let corrected = move |comparisons| {
                    figure(part, comparisons).unwrap_or(Estimate {
                        value: alone.value,
                        low: f64::NEG_INFINITY,
                        high: f64::INFINITY,
                    })
                };
                let exact = part.formula.as_ref().is_some_and(|formula| scope.is_exact(formula));
                places.push(outcomes.len());
                family.push(Member { bound: part.bound, exact, figure: corrected });
                outcomes.push(Outcome { part, found: Ok((alone, Side::Both)) });
            }
        }
    }
    for (place, judged) in places.into_iter().zip(holm::judge(&family)) {
        outcomes[place].found = Ok(judged);
    }
    outcomes
}

fn verdict(outcomes: &[Outcome<'_>]) -> Verdict {
    let side = |outcome: &Outcome<'_>| match &outcome.found {
        Ok((_, Side::Wrong)) if outcome.part.one_sided => Side::Both,
        Ok((_, side)) => *side,
        Err(_) => Side::Both,
    };
    if outcomes.iter().any(|outcome| side(outcome) == Side::Wrong) {
        Verdict::NotReproduced
    } else if outcomes.is_empty() || outcomes.iter().any(|outcome| side(outcome) == Side::Both) {
        Verdict::Undecided
    } else {
        Verdict::Reproduced
    }
}

/// What would decide an undecided claim: in its own words, or, where intervals are too wide, less noise. What
/// rows are missing the parts say themselves.
fn wanted<'a>(claim: &'a Claim, outcomes: &[Outcome<'_>]) -> Option<&'a str> {
    let is_open = |outcome: &Outcome<'_>| matches!(outcome.found, Ok((_, Side::Both)));
    match claim.wants.as_str() {
        "" if outcomes.iter().any(is_open) => {
            Some("more rounds (`--profile thorough`), or a quieter machine")
        }
        "" => None,
        own => Some(own),
    }
}

/// What a part says, in words.
fn words(outcome: &Outcome<'_>) -> String {
    let part = outcome.part;
    let (found, side) = match &outcome.found {
        Ok(judged) => judged,
        Err(lack) => return format!("{}: {lack}", part.what),
    };
    let is = match side {
        Side::Right => "is",
        Side::Wrong => "is not",
        Side::Both => "may or may not be",
    };
    let published = part.published.map(|p| format!(" (published {})", shown(p)));
    format!(
        "{}: {} {is} {}{}",
        part.what,
        shown_with_interval(found),
        part.bound.words(),
        published.unwrap_or_default()
    )
}

/// Puts in the figure of the part that fails by the most or, where none fails, is closest to failing. What has
/// no interval comes last among those that hold: it is not close to anything.
fn with_nearest(finding: Finding, outcomes: &[Outcome<'_>]) -> Finding {
    let distance = |part: &Part, found: &Estimate| {
        let distance = Bound::distance(part.bound, found.value);
        if found.is_exact() && distance >= 0.0 { f64::INFINITY } else { distance }
    };
    let with_figures = outcomes.iter().filter_map(|outcome| {
        let (found, _) = outcome.found.as_ref().ok()?;
        Some((outcome.part, found, distance(outcome.part, found)))
    });
    // The first of equals.
    let Some((part, found, _)) = with_figures.reduce(|a, b| if b.2 < a.2 { b } else { a }) else {
        return finding;
    };
    let end = |end: f64| end.is_finite().then_some(end);
    Finding {
        published: part.published.map_or(finding.published, |published| published.to_string()),
        measured: Some(found.value),
        low: end(found.low),
        high: end(found.high),
        ..finding
    }
}

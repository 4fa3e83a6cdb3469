//! The claims: how many hold, and each with its verdicts, by paper.

use super::words::{between, count, listed};
use crate::chart::short_figure;
use crate::claims::{Finding, Verdict};
use crate::results::Results;

/// All claims.
#[derive(Default)]
pub(super) struct Ledger {
    pub counts: Vec<Tally>,
    pub sentence: String,
    pub papers: Vec<Paper>,
}

/// How many claims have a verdict.
pub(super) struct Tally {
    pub verdict: Words,
    pub count: usize,
}

/// The claims of a paper.
pub(super) struct Paper {
    pub title: String,
    pub claims: Vec<Claim>,
}

/// A claim under all of its conditions.
pub(super) struct Claim {
    pub id: String,
    pub statement: String,
    pub source: String,
    /// `reproduced (literal, fixed); not reproduced (reshuffled)`
    pub headline: String,
    pub conditions: Vec<Condition>,
    /// Experiments that decide it.
    pub experiments: Vec<String>,
}

/// A verdict under a condition.
pub(super) struct Condition {
    pub condition: String,
    pub verdict: Words,
    pub published: String,
    pub measured: String,
    pub interval: String,
    pub details: String,
    pub decides: bool,
}

/// A verdict as a sign, in words, and as the name of a style. The sign and the words say it without
/// colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Words {
    pub sign: &'static str,
    pub words: &'static str,
    pub style: &'static str,
}

/// Of each verdict, and of claims whose deciding conditions disagree.
fn words(verdict: Option<Verdict>) -> Words {
    let (sign, words, style) = match verdict {
        Some(Verdict::Reproduced) => ("✓", "reproduced", "yes"),
        Some(Verdict::NotReproduced) => ("✗", "not reproduced", "no"),
        Some(Verdict::Undecided) => ("?", "undecided", "open"),
        Some(Verdict::NotTestable) => ("–", "not testable here", "none"),
        None => ("±", "depends on the machine", "open"),
    };
    Words { sign, words, style }
}

const ORDER: [Option<Verdict>; 5] = [
    Some(Verdict::Reproduced),
    Some(Verdict::NotReproduced),
    Some(Verdict::Undecided),
    None,
    Some(Verdict::NotTestable),
];

impl Ledger {
    /// Of findings, in their order; those of a claim stand together.
    pub fn new(results: &Results, findings: &[Finding]) -> Self {
        let mut groups: Vec<Vec<&Finding>> = Vec::new();
        for finding in findings {
            match groups.iter_mut().find(|group| group[0].id == finding.id) {
                Some(group) => group.push(finding),
                None => groups.push(vec![finding]),
            }
        }
        let decided: Vec<Option<Verdict>> = groups.iter().map(|group| deciding(group)).collect();
        let tally = |verdict: &Option<Verdict>| {
            let count = decided.iter().filter(|decided| *decided == verdict).count();
            (count > 0).then(|| Tally { verdict: words(*verdict), count })
        };
        let counts: Vec<Tally> = ORDER.iter().filter_map(tally).collect();
        let turned = groups.iter().filter(|group| turns(group)).count();
        Ledger {
            sentence: sentence(groups.len(), &counts, turned),
            counts,
            papers: papers(results, &groups),
        }
    }
}

/// The verdict that counts: under the condition that the claim is about; `None` where there are
/// several such conditions, and they disagree.
fn deciding(group: &[&Finding]) -> Option<Verdict> {
    let decides = group.iter().any(|finding| finding.decides);
    let mut verdicts =
        group.iter().filter(|finding| finding.decides || !decides).map(|finding| finding.verdict);
    let first = verdicts.next()?;
    verdicts.all(|other| other == first).then_some(first)
}

/// Whether another condition says the opposite.
fn turns(group: &[&Finding]) -> bool {
    let has = |verdict| group.iter().any(|finding| finding.verdict == verdict);
    has(Verdict::Reproduced) && has(Verdict::NotReproduced)
}

fn sentence(claims: usize, counts: &[Tally], turned: usize) -> String {
    if claims == 0 {
        return "No claim was judged.".to_owned();
    }
    let parts: Vec<String> =
        counts.iter().map(|tally| format!("{} {}", tally.count, tally.verdict.words)).collect();
    let turned = match turned {
        0 => String::new(),
        1 => " One of them is turned round by another condition.".to_owned(),
        several => format!(" {several} of them are turned round by another condition."),
    };
    format!("Of {}: {}.{turned}", count(claims, "claim", "claims"), listed(&parts))
}

/// What stands before the hyphen of an id names the paper.
fn papers(results: &Results, groups: &[Vec<&Finding>]) -> Vec<Paper> {
    let mut papers: Vec<(String, Paper)> = Vec::new();
    for group in groups {
        let key = group[0].id.split('-').next().unwrap_or_default().to_owned();
        let claim = claim(results, group);
        match papers.iter_mut().find(|(other, _)| *other == key) {
            Some((_, paper)) => paper.claims.push(claim),
            None => {
                let title = group[0].source.split(',').next().unwrap_or_default();
                let title = super::words::capital(title);
                papers.push((key, Paper { title, claims: vec![claim] }));
            }
        }
    }
    papers.into_iter().map(|(_, paper)| paper).collect()
}

fn claim(results: &Results, group: &[&Finding]) -> Claim {
    let first = group[0];
    let decides = |about: &crate::results::About| about.claims.contains(&first.id);
    let chapters = results.chapters.iter().filter(|chapter| decides(&chapter.about));
    Claim {
        id: first.id.clone(),
        statement: first.statement.clone(),
        source: first.source.clone(),
        headline: headline(group),
        conditions: group.iter().map(|finding| condition(finding)).collect(),
        experiments: chapters.map(|chapter| chapter.about.id.clone()).collect(),
    }
}

/// The verdicts, each with its conditions.
fn headline(group: &[&Finding]) -> String {
    let of = |verdict: &Option<Verdict>| {
        let mine = group.iter().filter(|finding| Some(finding.verdict) == *verdict);
        let conditions: Vec<String> =
            mine.clone().map(|finding| finding.condition.clone()).collect();
        let words = words(*verdict);
        let named = conditions.iter().any(|condition| !condition.is_empty());
        match (mine.count(), named) {
            (0, _) => None,
            (_, false) => Some(words.words.to_owned()),
            (_, true) => Some(format!("{} ({})", words.words, conditions.join(", "))),
        }
    };
    ORDER.iter().filter_map(of).collect::<Vec<_>>().join("; ")
}

fn condition(finding: &Finding) -> Condition {
    let ends = finding.low.zip(finding.high);
    Condition {
        condition: finding.condition.clone(),
        verdict: words(Some(finding.verdict)),
        published: finding.published.clone(),
        measured: finding.measured.map_or(String::new(), short_figure),
        interval: ends.map_or(String::new(), |(low, high)| between(low, high)),
        details: finding.details.clone(),
        decides: finding.decides,
    }
}

//! Everything that the report says, in its order, without how it looks.

use super::ReportError;
use super::answers::{Answer, answers};
use super::chapter::{Part, parts};
use super::ledger::Ledger;
use super::machine::Machine;
use super::trust::{self, Check};
use super::{cited, words};
use crate::chart::{TIMELINE_QUESTION, timeline, timeline_words};
use crate::claims::Finding;
use crate::recommend::KnownVariant;
use crate::results::Results;

/// The report.
pub(super) struct Page {
    pub cite: String,
    pub machines: Vec<Machine>,
    pub several: bool,
    /// Said first where there is nothing to report on.
    pub nothing: String,
    /// Said first where answers are wrong.
    pub wrong: String,
    pub answers: Vec<Answers>,
    pub ledger: Ledger,
    pub trust: Vec<Check>,
    pub trust_sentence: String,
    /// Picture of the rounds; empty where there are none.
    pub timeline: String,
    /// What it answers.
    pub timeline_question: &'static str,
    /// What it shows.
    pub timeline_words: String,
    /// Whether there are rounds to be shown.
    pub has_timeline: bool,
    pub parts: Vec<Part>,
}

/// Which kernel to take, on one machine.
pub(super) struct Answers {
    /// Empty where there is only one machine.
    pub machine: String,
    pub list: Vec<Answer>,
}

impl Page {
    /// Puts it together.
    ///
    /// # Errors
    /// The published figures cannot be read, or rows not be written.
    pub fn new(
        results: &Results,
        findings: &[Finding],
        known: &[KnownVariant],
    ) -> Result<Self, ReportError> {
        let machines: Vec<Machine> = results.sources.iter().map(Machine::of).collect();
        let several = machines.len() > 1;
        let has_timeline = !results.rounds.is_empty();
        Ok(Page {
            cite: cited::line(results, &machines)?,
            several,
            nothing: nothing(results),
            wrong: trust::wrong(results),
            answers: all_answers(results, known),
            ledger: Ledger::new(results, findings),
            trust: trust::checks(results),
            trust_sentence: trust::sentence(results),
            timeline: if has_timeline { timeline(&results.rounds, true)? } else { String::new() },
            timeline_question: TIMELINE_QUESTION,
            timeline_words: timeline_words(&results.rounds),
            has_timeline,
            parts: parts(results)?,
            machines,
        })
    }

    /// The program's name and version.
    pub fn generator(&self) -> &'static str {
        concat!("ray_test ", env!("CARGO_PKG_VERSION"))
    }

    /// For templates: whether a claim stands in the page, so that a link to it leads somewhere.
    pub fn judged(&self, claim: &str) -> bool {
        self.ledger.papers.iter().flat_map(|paper| &paper.claims).any(|other| other.id == claim)
    }

    /// For templates: a cell of a Markdown table.
    pub fn cell(&self, text: &str) -> String {
        words::cell(text)
    }

    /// For templates: the words that stand for a picture in Markdown.
    pub fn alternative(&self, text: &str) -> String {
        text.replace('[', "(").replace(']', ")")
    }
}

fn nothing(results: &Results) -> String {
    match (results.chapters.len(), results.rows().count()) {
        (0, _) => "There are no experiments in these results.".to_owned(),
        (_, 0) => "There are no rows in these results.".to_owned(),
        _ => String::new(),
    }
}

/// The answers, machine by machine.
fn all_answers(results: &Results, known: &[KnownVariant]) -> Vec<Answers> {
    let of_all = || vec![Answers { machine: String::new(), list: answers(results, None, known) }];
    let mut all = match results.sources.as_slice() {
        [] | [_] => of_all(),
        several => {
            let of = |label: &String| Answers {
                machine: label.clone(),
                list: answers(results, Some(label), known),
            };
            several.iter().map(|source| of(&source.label)).collect()
        }
    };
    all.retain(|answers| !answers.list.is_empty());
    all
}

//! The claims of all papers, read and checked.

use super::bound::Bound;
use super::claim::{Claim, SeriesOf};
use super::embedded::PAPERS;
use super::expression::Expression;
use crate::table::{COLUMNS, Row};
use serde::Deserialize;

/// Claims in the order of their papers.
#[derive(Clone, Debug, Default)]
pub struct Ledger {
    claims: Vec<Claim>,
}

/// What is wrong with a file of claims.
#[derive(Debug, thiserror::Error)]
pub enum LedgerError {
    /// It is no TOML of the right form.
    #[error("{file}: {message}")]
    Form {
        /// The file.
        file: String,
        /// What the parser says, with line and field.
        message: String,
    },
    /// A field of a claim holds something that is not allowed.
    #[error("{file}, claim '{claim}', {field}: {message}")]
    Claim {
        /// The file.
        file: String,
        /// The claim's id.
        claim: String,
        /// The field.
        field: String,
        /// What stands there, and what is allowed.
        message: String,
    },
}

/// A paper's file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Paper {
    /// Its place among the papers.
    place: u32,
    /// What its claims have as `conditions` if they have none.
    #[serde(default)]
    conditions: Vec<String>,
    /// What they have as `decides`.
    #[serde(default)]
    decides: Vec<String>,
    claim: Vec<Claim>,
}

impl Ledger {
    /// The claims that are part of the program, of `configs/published/*.toml`.
    ///
    /// # Errors
    /// The first field that is not allowed.
    pub fn embedded() -> Result<Self, LedgerError> {
        Ledger::from_files(PAPERS)
    }

    /// The claims of files, given as name and text.
    ///
    /// # Errors
    /// The first field that is not allowed; an id that is there twice.
    pub fn from_files(files: &[(&str, &str)]) -> Result<Self, LedgerError> {
        let mut papers = Vec::new();
        for (file, text) in files {
            let form = |error: toml::de::Error| LedgerError::Form {
                file: (*file).to_owned(),
                message: error.to_string(),
            };
            let paper: Paper = toml::from_str(text).map_err(form)?;
            papers.push((paper.place, *file, paper));
        }
        papers.sort_by(|(a, one, _), (b, other, _)| a.cmp(b).then(one.cmp(other)));
        let mut ledger = Ledger::default();
        for (_, file, paper) in papers {
            for mut claim in paper.claim {
                claim.conditions.get_or_insert_with(|| paper.conditions.clone());
                claim.decides.get_or_insert_with(|| paper.decides.clone());
                let wrong = |(field, message): (String, String)| {
                    let (file, claim) = (file.to_owned(), claim.id.clone());
                    LedgerError::Claim { file, claim, field, message }
                };
                if ledger.find(&claim.id).is_some() {
                    let message = "is there twice; allowed: an id of its own".to_owned();
                    return Err(wrong(("id".to_owned(), message)));
                }
                let checked = checked(claim.clone()).map_err(wrong)?;
                ledger.claims.push(checked);
            }
        }
        Ok(ledger)
    }

    /// All claims.
    pub fn claims(&self) -> &[Claim] {
        &self.claims
    }

    /// The claim of an id.
    pub fn find(&self, id: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.id == id)
    }
}

/// The field, and what is wrong with it.
type Wrong = (String, String);

fn wrong<T>(field: impl Into<String>, message: impl Into<String>) -> Result<T, Wrong> {
    Err((field.into(), message.into()))
}

/// A claim with its formulas read, if everything in it is allowed.
fn checked(mut claim: Claim) -> Result<Claim, Wrong> {
    for (field, text) in
        [("id", &claim.id), ("source", &claim.source), ("statement", &claim.statement)]
    {
        if text.trim().is_empty() {
            return wrong(field, "nothing is not allowed; allowed: words");
        }
    }
    if claim.is_testable() == claim.part.is_empty() {
        return wrong("part", "allowed: parts, or not_testable with the reason, and not both");
    }
    for column in claim.columns() {
        known(column).map_err(|message| ("conditions".to_owned(), message))?;
    }
    for (name, series) in &claim.series {
        let field = |(field, message): Wrong| (format!("series.{name}.{field}"), message);
        check_series(series).map_err(field)?;
    }
    for (name, text) in &claim.formulas {
        let read = Expression::parse(text).map_err(|message| (format!("let.{name}"), message))?;
        claim.read.insert(name.clone(), read);
    }
    check_names(&claim)?;
    for index in 0..claim.part.len() {
        let field = format!("part {}", index + 1);
        let part = &claim.part[index];
        let Some(bound) = Bound::of(part) else {
            let allowed = "allowed: one of below, above, at_least, at_most, equals, between";
            return wrong(field, allowed);
        };
        let formula = Expression::parse(&part.measure).map_err(|message| (field, message))?;
        names_are_known(&claim, &formula, &format!("part {}", index + 1))?;
        claim.part[index].bound = bound;
        claim.part[index].formula = Some(formula);
    }
    Ok(claim)
}

fn known(column: &str) -> Result<(), String> {
    if COLUMNS.contains(&column) {
        return Ok(());
    }
    Err(format!("'{column}' is not allowed; allowed: {}", COLUMNS.join(", ")))
}

fn check_series(series: &SeriesOf) -> Result<(), Wrong> {
    let at = |field: &str| {
        let field = field.to_owned();
        move |message| (field, message)
    };
    for column in series.along.list() {
        known(column).map_err(at("along"))?;
    }
    series.filter.keys().try_for_each(|column| known(column).map_err(at("filter")))?;
    series.over.iter().try_for_each(|column| known(column).map_err(at("over")))?;
    if !series.values.is_empty() {
        let printed = series.experiment.list().is_empty() && series.value.is_empty();
        if !printed || series.along.list().len() != 1 {
            return wrong(
                "values",
                "allowed: printed figures along one column, without experiment",
            );
        }
        return Ok(());
    }
    if series.experiment.list().is_empty() {
        return wrong("experiment", "nothing is not allowed; allowed: the id of an experiment");
    }
    if series.keys.is_empty() != series.otherwise.is_none() {
        return wrong("otherwise", "allowed: together with keys, or neither");
    }
    if !series.keys.is_empty() && series.along.list().len() != 1 {
        return wrong("keys", "allowed: along one column");
    }
    known(&series.value).map_err(at("value"))?;
    // A column that takes a word is not numeric.
    if Row::default().set(&series.value, "word").is_ok() {
        let message = format!("'{}' is not allowed; allowed: a column of numbers", series.value);
        return wrong("value", message);
    }
    Ok(())
}

/// Formulas may name series and each other, and never themselves.
fn check_names(claim: &Claim) -> Result<(), Wrong> {
    for (name, formula) in &claim.read {
        let field = format!("let.{name}");
        if claim.series.contains_key(name) {
            return wrong(field, "there is a series of that name; allowed: a name of its own");
        }
        names_are_known(claim, formula, &field)?;
        // Each step inwards names other formulas, so after so many steps a name comes again.
        let mut names: Vec<&str> = formula.names();
        for _ in 0..claim.read.len() {
            names = names
                .iter()
                .filter_map(|n| claim.read.get(*n))
                .flat_map(Expression::names)
                .collect();
        }
        if names.iter().any(|name| claim.read.contains_key(*name)) {
            return wrong(field, "it needs itself; allowed: formulas that end in series");
        }
    }
    Ok(())
}

fn names_are_known(claim: &Claim, formula: &Expression, field: &str) -> Result<(), Wrong> {
    let is_known = |name: &&str| claim.series.contains_key(*name) || claim.read.contains_key(*name);
    let Some(unknown) = formula.names().into_iter().find(|name| !is_known(name)) else {
        return Ok(());
    };
    let all: Vec<&str> = claim.series.keys().chain(claim.read.keys()).map(String::as_str).collect();
    wrong(field, format!("'{unknown}' is not allowed; allowed: {}", all.join(", ")))
}

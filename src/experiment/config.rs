//! An experiment as a TOML file: its question, why, workload, variants, figures, claims.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::workload::Workload;
use crate::chart::{Figure, Published};

/// One experiment. Unknown keys are an error.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Experiment {
    /// Id, the name of its folder in a run.
    pub id: String,
    /// One line.
    pub title: String,
    /// What it mirrors, for instance `thesis B, table 4.1`; empty for our own.
    #[serde(default)]
    pub mirrors: String,
    /// The question that it answers.
    pub question: String,
    /// Why it is asked, and why it is measured this way.
    pub why: String,
    /// The Cargo feature that its variants come with; empty if every build has them. A build
    /// without it skips the experiment.
    #[serde(default)]
    pub feature: String,
    /// Whether it is part of `ray_test reproduce`; what takes long for what it says is run by itself.
    #[serde(default = "part")]
    pub reproduce: bool,
    /// Ids of the claims that its rows decide.
    #[serde(default)]
    pub claims: Vec<String>,
    /// Seed of workload and measuring.
    #[serde(default = "seed")]
    pub seed: u64,
    /// What the variants are run on.
    pub workload: Workload,
    /// Regular expressions over variant ids; each must match something. None for workloads that
    /// bring their own.
    #[serde(default)]
    pub variants: Vec<String>,
    /// Id of the variant that ratios refer to.
    #[serde(default = "reference")]
    pub reference: String,
    /// Whether rows say how many cycles their operations need at least; nearest hits only.
    #[serde(default)]
    pub bounds: bool,
    /// What is drawn.
    #[serde(default)]
    pub figure: Vec<Figure>,
    /// Words shown for values, in every figure that has no others for them.
    #[serde(default)]
    pub labels: BTreeMap<String, String>,
    /// The text that it was read from.
    #[serde(skip)]
    pub text: String,
}

/// Features that an experiment may need, and whether this build has them.
const FEATURES: [(&str, bool); 1] = [("peers", cfg!(feature = "peers"))];

fn part() -> bool {
    true
}

fn seed() -> u64 {
    1
}

fn reference() -> String {
    crate::registry::REFERENCE.to_owned()
}

impl Experiment {
    /// Reads an experiment. `origin` names the file in messages.
    ///
    /// # Errors
    /// One message that says where, what and what is allowed.
    pub fn parse(origin: &str, text: &str) -> Result<Self, ConfigError> {
        let wrong = |message: String| ConfigError { origin: origin.to_owned(), message };
        let mut experiment: Experiment =
            toml::from_str(text).map_err(|error| wrong(error.to_string()))?;
        experiment.text = text.to_owned();
        for figure in &mut experiment.figure {
            for (value, words) in &experiment.labels {
                figure.labels.entry(value.clone()).or_insert_with(|| words.clone());
            }
        }
        experiment.validate().map_err(wrong)?;
        Ok(experiment)
    }

    /// Whether its variants are not in this build.
    pub fn is_of_another_build(&self) -> bool {
        FEATURES.contains(&(self.feature.as_str(), false))
    }

    /// Refuses what can be seen to be wrong before anything runs.
    fn validate(&self) -> Result<(), String> {
        let safe = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || "-.".contains(c);
        if self.id.is_empty() || self.id.starts_with('.') || !self.id.chars().all(safe) {
            return Err(format!(
                "id: '{}' is not allowed; allowed: lower-case letters, digits, '-' and '.'",
                self.id
            ));
        }
        if !self.feature.is_empty() && FEATURES.iter().all(|(name, _)| *name != self.feature) {
            return Err(format!(
                "feature: '{}' is not allowed; allowed: {}, or none",
                self.feature,
                FEATURES.map(|(name, _)| name).join(", ")
            ));
        }
        if self.variants.is_empty() && self.workload.has_variants() {
            return Err("variants: at least one regular expression is needed".to_owned());
        }
        if self.bounds && !matches!(self.workload, Workload::Nearest(_)) {
            return Err(
                "bounds: true is not allowed; allowed: true where workload.kind is nearest, \
                        false elsewhere"
                    .to_owned(),
            );
        }
        self.workload.validate(self.seed)?;
        let published = Published::embedded().map_err(|error| error.to_string())?;
        self.figure
            .iter()
            .try_for_each(|figure| figure.validate(&published))
            .map_err(|error| error.to_string())
    }
}

/// What is wrong with a file.
#[derive(Debug, thiserror::Error)]
#[error("{origin}: {message}")]
pub struct ConfigError {
    /// The file.
    pub origin: String,
    /// Where in it, what, and what is allowed.
    pub message: String,
}

//! Folders of results, read back: what claims, reports and recommendations start from.

mod fingerprint;

use crate::chart::Figure;
use crate::table::Row;
use serde_json::Value;

/// What one or several folders of results hold, put together.
#[derive(Clone, Debug, Default)]
pub struct Results {
    /// Machines and builds, in the order of their folders. Shards of one run are one source.
    pub sources: Vec<Source>,
    /// Experiments, the theses' first.
    pub chapters: Vec<Chapter>,
}

/// A machine and build that rows come from.
#[derive(Clone, Debug)]
pub struct Source {
    /// Short name, different for each: processor, and build where builds differ. It is the column
    /// `machine` of its rows where there are several sources.
    pub label: String,
    /// The folders, as they were given.
    pub folders: Vec<String>,
    /// What `environment.json` says.
    pub environment: Value,
}

/// An experiment's rows, from all sources.
#[derive(Clone, Debug, Default)]
pub struct Chapter {
    /// What it asks, and what is drawn.
    pub about: About,
    /// Its rows. With several sources, `machine` says which one a row is of.
    pub rows: Vec<Row>,
    /// Whether every source ran it to its end.
    pub complete: bool,
    /// Hash of the workloads, as stored.
    pub workload_hash: String,
}

/// What an experiment asks, without what runs it.
#[derive(Clone, Debug, Default)]
pub struct About {
    /// Id, the name of its folder.
    pub id: String,
    /// One line.
    pub title: String,
    /// What it mirrors, for instance `thesis B, table 4.1`; empty for our own.
    pub mirrors: String,
    /// The question that it answers.
    pub question: String,
    /// Why it is asked, and why it is measured this way.
    pub why: String,
    /// The file that describes it, for instance `configs/b-4.1.toml`.
    pub config: String,
    /// The command that makes it again.
    pub command: String,
    /// Ids of the claims that its rows decide.
    pub claims: Vec<String>,
    /// What is drawn of it.
    pub figures: Vec<Figure>,
}

impl Results {
    /// Every row.
    pub fn rows(&self) -> impl Iterator<Item = &Row> {
        self.chapters.iter().flat_map(|chapter| &chapter.rows)
    }

    /// The chapter of an experiment.
    pub fn chapter(&self, id: &str) -> Option<&Chapter> {
        self.chapters.iter().find(|chapter| chapter.about.id == id)
    }
}

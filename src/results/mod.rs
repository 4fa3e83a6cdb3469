//! Folders of results, read back: what claims, reports and recommendations start from.
//!
//! How several are put together:
//! - **What was measured on one machine with one build** (`testbed_id` and `build` of its environment
//!   are the same) becomes one source, if no two of its folders have different figures for the same
//!   thing, or an experiment of another text: those are shards of a run, or runs of different
//!   experiments. A row that is in two folders, equal in all columns, counts once. Folders that
//!   differ in a figure are different measurements, and so different sources.
//! - **Shards** need no clock, so that for folders of nothing but shards the same build is enough: a job
//!   array may run on processors of several kinds. The source is then named after the first.
//! - **The order of the rows** is that of the unsplit run: shards say where each of their rows stands
//!   in it. Rows that are of no shard stand before those, folder by folder.
//! - With several sources, the column `machine` of each row names its own, and the rows of an
//!   experiment stand source by source.

mod drawings;
mod files;
mod load;
mod machine;
mod merge;
mod order;
mod part;
#[cfg(test)]
mod tests;

pub use drawings::{Drawing, drawings};
pub use files::{COMPLETE, DESCRIPTION, ENVIRONMENT, JOURNAL, ROWS, SHARD, SOURCES, TABLE};
pub use load::{Describe, load};
pub mod derived;
mod mixture;

mod fingerprint;

use crate::chart::Figure;
use crate::table::{Round, Row, TableError};
use serde_json::Value;
use std::io;
use std::path::PathBuf;

/// What one or several folders of results hold, put together.
#[derive(Clone, Debug, Default)]
pub struct Results {
    /// Machines and builds, in the order of their folders. Shards of one run are one source.
    pub sources: Vec<Source>,
    /// Experiments, the theses' first.
    pub chapters: Vec<Chapter>,
    /// Rounds of the one run that they are of, in the order of time; none of several.
    pub rounds: Vec<Round>,
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

impl About {
    /// Of an experiment that nobody describes: its id.
    pub fn unknown(id: &str) -> Self {
        About { id: id.to_owned(), title: id.to_owned(), ..About::default() }
    }
}

/// Why folders cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// A folder or a file cannot be read.
    #[error("{}: {source}; allowed: the folder of a run, or of one experiment of it", file.display())]
    Io {
        /// The folder or file.
        file: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// Rows are broken.
    #[error("{0}; allowed: what `ray_test run` wrote")]
    Table(#[from] TableError),
    /// An `environment.json` is broken.
    #[error("{}: {message}; allowed: what `ray_test run` wrote", file.display())]
    Environment {
        /// The file.
        file: PathBuf,
        /// What the parser says, with the place.
        message: String,
    },
    /// Rows name an experiment by what is no name, so that its folder could be anywhere.
    #[error(
        "{}: column 'experiment': '{}' is not allowed; allowed: a name that a folder can have, \
         without '/', '\\' and control characters",
        file.display(), id.escape_debug()
    )]
    Id {
        /// The folder of the rows.
        file: PathBuf,
        /// What they say.
        id: String,
    },
    /// A folder holds no results.
    #[error(
        "{}: no rows.json or rows.ndjson in it or in a folder of it; \
         allowed: the folder of a run, or of one experiment of it",
        .0.display()
    )]
    Nothing(PathBuf),
}

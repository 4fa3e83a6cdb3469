//! Where results go.

mod kept;

pub use kept::Before;

use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::publish::REPORTS;
use super::rounds::{self, ROUNDS, RoundsLog};
use super::stored::workload_hash;
use super::unfinished::Keeper;
use crate::experiment::{Experiment, Outcome, Plan};
use crate::measure::{Environment, now_rfc3339};
use crate::results::{DESCRIPTION, JOURNAL, ROWS, TABLE};
use crate::shard::Shard;
use crate::table::{
    Header, Journaled, RunFile, SCHEMA_VERSION, make_folder, remove_file, remove_partial_files,
    try_folder, write_atomically, write_csv, write_json,
};

/// The folder of one run.
pub struct Folder {
    path: PathBuf,
    environment: Environment,
    /// What rows depend on besides experiment, program and machine: profile and filter, as text.
    settings: String,
    /// Which share of the work it is for; `None` for all of it.
    shard: Option<Shard>,
    /// When the program began, in seconds of the run: above 0 where it goes on.
    began_s: f64,
}

impl Folder {
    /// The folder; nothing is written yet. The hash tells runs of other files, profiles and
    /// filters apart where `out` does not.
    pub fn new(
        out: Option<&Path>,
        config_hash: u64,
        environment: Environment,
        settings: String,
    ) -> Self {
        let default = || {
            let time = now_rfc3339().replace([':', '-'], "");
            PathBuf::from("results").join(format!("{time}-{:08x}", config_hash as u32))
        };
        let path = out.map_or_else(default, Path::to_path_buf);
        Folder { path, environment, settings, shard: None, began_s: 0.0 }
    }

    /// The same for a share of the work.
    pub fn of_shard(self, shard: Shard) -> Self {
        Folder { shard: Some(shard), ..self }
    }

    /// Whether it is for a share of the work.
    pub fn is_of_shard(&self) -> bool {
        self.shard.is_some()
    }

    /// The folder of a run that goes on: time is counted from where its rounds end.
    pub fn going_on(self) -> Self {
        let began_s = rounds::last_s(&self.path);
        Folder { began_s, ..self }
    }

    /// Makes it ready for plans, and says what there is of each: with `resume` what was kept, without
    /// it nothing.
    ///
    /// # Errors
    /// As [`Folder::before`] and [`Folder::create`].
    pub fn open(&self, plans: &[Plan], resume: bool) -> Result<Vec<Before>, Failure> {
        let before = |plan| if resume { self.before(plan) } else { Ok(Before::Nothing) };
        let before = plans.iter().map(before).collect::<Result<Vec<_>, _>>()?;
        self.create()?;
        if resume {
            self.tidy(plans);
        } else {
            self.begin_anew(plans)?;
        }
        Ok(before)
    }

    /// Creates it and finds out whether it can be written, before anything runs.
    ///
    /// # Errors
    /// Usage, if it cannot be created or written to.
    pub fn create(&self) -> Result<(), Failure> {
        let folder = self;
        let refused = |error: &dyn std::fmt::Display| {
            Failure::Usage(format!(
                "--out: {} cannot be written: {error}; allowed: a folder that can be created or \
                 written",
                folder.path.display()
            ))
        };
        try_folder(&folder.path).map_err(|error| refused(&error))?;
        let json = serde_json::to_vec_pretty(&folder.environment)
            .map_err(|error| Failure::Runtime(error.into()))?;
        write_atomically(&folder.path.join("environment.json"), &json)
            .map_err(|error| refused(&error))
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    fn file(&self, id: &str, name: &str) -> PathBuf {
        self.path.join(id).join(name)
    }

    /// Before a run goes on: removes what a killed one was writing.
    fn tidy(&self, plans: &[Plan]) {
        remove_partial_files(&self.path);
        plans.iter().for_each(|plan| remove_partial_files(&self.path.join(&plan.experiment.id)));
    }

    /// Before a run begins where another one was: nothing of that one counts as finished any more.
    ///
    /// # Errors
    /// When it cannot be written.
    fn begin_anew(&self, plans: &[Plan]) -> Result<(), Failure> {
        for plan in plans {
            let id = &plan.experiment.id;
            if [JOURNAL, ROWS].into_iter().any(|name| self.file(id, name).exists()) {
                self.begin(plan, Before::Nothing)?;
            }
            // The journal stands: what was there before is of another run, and so is its report.
            for name in [ROWS, TABLE, ROUNDS] {
                std::fs::remove_file(self.file(id, name)).ok();
            }
        }
        for name in REPORTS {
            std::fs::remove_file(self.path.join(name)).ok();
        }
        Ok(())
    }

    /// Begins the journal of an experiment, with what there is of it.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn begin(&self, plan: &Plan, before: Before) -> Result<Keeper, Failure> {
        let (id, seed) = (&plan.experiment.id, plan.experiment.seed);
        make_folder(&self.path.join(id))?;
        write_atomically(&self.file(id, DESCRIPTION), plan.experiment.text.as_bytes())?;
        let goes_on = matches!(before, Before::Begun(_));
        let contents = match before {
            Before::Begun(journaled) => journaled,
            Before::Nothing | Before::Finished(_) => Journaled {
                header: Header::new(self.key(&plan.experiment.text), id, seed),
                pieces: Vec::new(),
            },
        };
        let rounds = RoundsLog::begin(&self.path.join(id), self.began_s, goes_on)?;
        Ok(Keeper::begin(&self.file(id, JOURNAL), contents, rounds)?)
    }

    /// The table of an experiment.
    pub fn table(&self, plan: &Plan) -> PathBuf {
        self.file(&plan.experiment.id, TABLE)
    }

    /// Writes the rows of an experiment; its journal is removed once it is finished. Figures are
    /// drawn when nothing is measured any more.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn save(&self, plan: &Plan, outcome: &Outcome) -> Result<(), Failure> {
        let id = &plan.experiment.id;
        write_csv(&self.table(plan), &outcome.rows)?;
        // Last: it says that the experiment is complete.
        write_json(&self.file(id, ROWS), &self.run_file(plan, outcome)?)?;
        if !outcome.interrupted {
            remove_file(&self.file(id, JOURNAL))?;
        }
        Ok(())
    }

    fn run_file(&self, plan: &Plan, outcome: &Outcome) -> Result<RunFile, Failure> {
        let Experiment { id, text, seed, .. } = &plan.experiment;
        let (complete, places) = (!outcome.interrupted, &outcome.places);
        Ok(RunFile {
            schema_version: SCHEMA_VERSION.to_owned(),
            environment: self.circumstances(text, complete, places)?,
            seed: *seed,
            workload_hash: workload_hash(id, &outcome.rows),
            rows: outcome.rows.clone(),
        })
    }
}

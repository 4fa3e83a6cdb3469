//! What a folder keeps of an experiment, and by what it is known to be of the same run.

use std::io::ErrorKind;
use std::path::Path;

use serde_json::{Value, json};

use super::Folder;
use crate::cli::failure::Failure;
use crate::cli::stored::put_shard;
use crate::experiment::Plan;
use crate::measure::BuildInfo;
use crate::results::{COMPLETE, JOURNAL, ROWS};
use crate::table::{Journaled, RunFile, RunKey, TableError, read_journal, read_json};
use crate::workload::hash::Fnv;

/// What there is of an experiment before it runs.
pub enum Before {
    /// Nothing.
    Nothing,
    /// All of it; the variants that were wrong.
    Finished(Vec<String>),
    /// What was measured until it was interrupted.
    Begun(Journaled),
}

impl Folder {
    /// What there is of an experiment in this folder.
    ///
    /// # Errors
    /// Usage, if it was measured with another configuration, program or machine, or if its journal
    /// is broken.
    pub(super) fn before(&self, plan: &Plan) -> Result<Before, Failure> {
        let id = &plan.experiment.id;
        let file = self.file(id, JOURNAL);
        // A journal is there until everything else is; it outlasts even a finished file of before.
        let journal = read_journal(&file);
        let journal = journal.map_err(|error| Failure::Usage(format!("--resume: {error}")))?;
        if let Some(journal) = journal {
            self.refuse_others(&file, &journal.header.run_key, &plan.experiment.text)?;
            return Ok(Before::Begun(journal));
        }
        let Some(run) = self.finished(id, &plan.experiment.text)? else {
            return Ok(Before::Nothing);
        };
        let mut wrong: Vec<String> = Vec::new();
        for row in run.rows.iter().filter(|row| row.status == "wrong-result") {
            if !wrong.contains(&row.id) {
                wrong.push(row.id.clone());
            }
        }
        Ok(Before::Finished(wrong))
    }

    /// The rows of an experiment that was finished here, by its id and text.
    ///
    /// # Errors
    /// Usage, if it was run with another configuration, program or machine, or if its rows cannot
    /// be read.
    pub fn finished(&self, id: &str, text: &str) -> Result<Option<RunFile>, Failure> {
        let file = self.file(id, ROWS);
        let run = match read_json(&file) {
            Ok(run) => run,
            Err(TableError::Io { source, .. }) if source.kind() == ErrorKind::NotFound => {
                return Ok(None);
            }
            // Of a newer program, say: nobody wants it overwritten unasked.
            Err(error) => {
                return Err(Failure::Usage(format!(
                    "--resume: {error}; allowed: what this program wrote (without this file the \
                     experiment is measured anew), or another --out"
                )));
            }
        };
        let key = run.environment.get(RUN_KEY).cloned();
        let key = key.and_then(|key| serde_json::from_value(key).ok()).unwrap_or_default();
        self.refuse_others(&file, &key, text)?;
        let is_complete = run.environment.get(COMPLETE).and_then(Value::as_bool) == Some(true);
        Ok(is_complete.then_some(run))
    }

    fn refuse_others(&self, file: &Path, key: &RunKey, text: &str) -> Result<(), Failure> {
        let now = self.key(text);
        let Some((part, before, now)) = key.difference(&now) else { return Ok(()) };
        Err(Failure::Usage(format!(
            "--resume: {} was made with another {part} ('{before}', now '{now}'); allowed: the \
             same experiment, --profile, --filter, program and machine, or another --out",
            file.display()
        )))
    }

    /// What must be the same for an experiment to be gone on with.
    pub(super) fn key(&self, text: &str) -> RunKey {
        let mut hash = Fnv::default();
        hash.bytes(text.as_bytes());
        RunKey {
            config: format!("text {:016x} {}", hash.finish(), self.settings),
            binary: binary(&self.environment.build),
            machine: self.environment.testbed_id.clone(),
        }
    }

    /// What is said around the rows of an experiment of that text: the environment, by what the run
    /// can be gone on with, whether all of it is there, and of a share where its rows stand.
    ///
    /// # Errors
    /// None that a value of ours could have.
    pub fn circumstances(
        &self,
        text: &str,
        complete: bool,
        places: &[u64],
    ) -> Result<Value, Failure> {
        let mut environment = serde_json::to_value(&self.environment)
            .map_err(|error| Failure::Runtime(error.into()))?;
        environment[RUN_KEY] = json!(self.key(text));
        environment[COMPLETE] = json!(complete);
        put_shard(&mut environment, self.shard, places);
        Ok(environment)
    }
}

/// The program in one line: what tells builds apart.
fn binary(build: &BuildInfo) -> String {
    let known = |text: &Option<String>| text.clone().unwrap_or_else(|| "unknown".to_owned());
    format!(
        "{} commit {}, {}, {} {} opt-level {}{}, flags '{}'",
        build.version,
        known(&build.commit),
        known(&build.compiler),
        known(&build.target),
        known(&build.profile),
        known(&build.opt_level),
        if build.debug_assertions { " with assertions" } else { "" },
        build.flags.as_deref().unwrap_or("")
    )
}

/// Field of a file's environment: what must be the same for the run to be gone on with.
const RUN_KEY: &str = "run_key";

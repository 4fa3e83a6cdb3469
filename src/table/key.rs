//! What must be the same for a run to be gone on with.

use serde::{Deserialize, Serialize};

/// The key of a run, in parts that can be named where they differ. The workloads are the fourth
/// part: their hash stands in every row.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RunKey {
    /// The experiment, `--profile` and `--filter`.
    pub config: String,
    /// The program: version, commit, compiler, target and flags.
    pub binary: String,
    /// Name of the test bed.
    pub machine: String,
}

impl RunKey {
    /// The first part that differs: its name, its value here and its value there.
    pub fn difference<'a>(&'a self, other: &'a RunKey) -> Option<(&'static str, &'a str, &'a str)> {
        let parts = [
            ("config", &self.config, &other.config),
            ("binary", &self.binary, &other.binary),
            ("machine", &self.machine, &other.machine),
        ];
        let differs = parts.into_iter().find(|(_, here, there)| here != there);
        differs.map(|(name, here, there)| (name, here.as_str(), there.as_str()))
    }
}

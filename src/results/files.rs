//! What is where in a folder of results: the names, written once for who writes and who reads.

/// What a run was made on and with, in its folder.
pub const ENVIRONMENT: &str = "environment.json";
/// The rows of an experiment, in the experiment's folder as all that follow.
pub const TABLE: &str = "rows.csv";
/// The same with the environment; it is there when the experiment has ended.
pub const ROWS: &str = "rows.json";
/// Rows as they were measured; it is there until the experiment has ended.
pub const JOURNAL: &str = "rows.ndjson";
/// The experiment itself, as it was run.
pub const DESCRIPTION: &str = "experiment.toml";

/// Field of a file's environment: whether the experiment was run to its end.
pub const COMPLETE: &str = "complete";
/// Field of it: `part`, which share of the work the file holds, such as `2/3`, and `places`, where
/// each row stands in the whole. The places are stored because no columns say in which order an
/// experiment names its variants.
pub const SHARD: &str = "shard";
/// Field of an environment that was put together: the sources, as label, folders and environment.
pub const SOURCES: &str = "sources";

/// Fields that are about a file, and not about the machine and the build.
pub(super) const OF_A_FILE: [&str; 4] = [COMPLETE, SHARD, "run_key", "label"];

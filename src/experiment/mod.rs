//! TOML -> plan -> rows: the only part that knows workloads, variants, clock and oracle at once.

mod config;
mod workload;

pub use config::{ConfigError, Experiment};
pub use workload::{CodesWorkload, NearestWorkload, PairsWorkload, PointsWorkload, Workload};

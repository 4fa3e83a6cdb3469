//! TOML -> plan -> rows: the only part that knows workloads, variants, clock and oracle at once.
//!
//! ```text
//! Experiment (TOML) --select--> Plan --draw--> Scene --judge--> right variants --measure--> rows
//! ```

mod arithmetic;
mod bench;
mod bounds;
mod calls;
pub mod cells;
mod clock_free;
mod codes;
mod config;
mod counts;
mod crossing;
mod distraction;
mod errors;
mod keep;
mod limits;
mod memory;
mod memory_workload;
mod nearest_workload;
mod patience;
mod pictures;
mod plan;
mod points;
mod precompute;
mod prices;
mod rows;
mod run;
mod scene;
mod search;
mod select;
mod stiff;
mod together;
mod useful;
mod workload;

pub use bench::Bench;
pub use cells::{BEYOND, beyond_prediction, control};
pub use clock_free::{is_clock_free, run_shard};
pub use config::{ConfigError, Experiment};
pub use crossing::{Cost, Costs, crossing};
pub use distraction::Distraction;
pub use keep::{Keep, KeepError, KeepNothing, Pieces};
pub use memory_workload::MemoryWorkload;
pub use nearest_workload::NearestWorkload;
pub use patience::Patience;
pub use pictures::{PictureSet, PicturesWorkload, Sampling};
pub use plan::{Plan, Profile};
pub use precompute::PrecomputeWorkload;
pub use rows::{put_group, put_percent_slower};
pub use run::{Outcome, RunError, Trouble, run};
pub use scene::{Facts, Scene, reported};
pub use search::{CountedWorkload, RayKind, StructuresWorkload, VolumesWorkload};
pub use select::{pattern_of, select};
pub use stiff::StiffWorkload;
pub use workload::{CodesWorkload, ErrorsWorkload, PairsWorkload, PointsWorkload, Workload};

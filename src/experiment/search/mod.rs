//! The workload `structures`: what a ray costs among many triangles, by what they are searched with.
//!
//! ```text
//! scene ─> triangles ─┬─> structures, built and timed ─┐
//!                     └─> rays of each kind ───────────┴─> searches ─ checked ─> groups ─> rows
//! lines through soups ─> volumes and lists ─> B + p I, foretold and measured
//! ```
//!
//! **What is checked before anything is timed.** A structure must give the list's answers, bit for bit, but
//! for those that [`crate::structure`] excuses, which are counted; where the list takes too long for all
//! rays, it answers for some of them, and a hierarchy of boxes, which had to agree with it on those, for
//! the others. Answers of every kind are held against the exact ones too, other crates' counted only.

mod build;
mod counted;
mod derived;
mod estimate;
mod foretold;
mod run;
mod set;
mod subject;
mod volumes;
mod workload;

pub use estimate::{blocks, seconds_around};
pub use run::run;
pub use workload::{CountedWorkload, RayKind, StructuresWorkload, VolumesWorkload};

pub(super) use counted::rows as counted_rows;
pub(super) use run::{protocol, time};
pub(super) use set::{opened, scene_name};
pub(super) use subject::leaves_of;
pub(super) use workload::scenes_exist;

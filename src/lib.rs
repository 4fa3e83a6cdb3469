//! ray_test
#![forbid(unsafe_code)]
#[cfg(feature = "cli")]
pub mod chart;
pub mod job;
pub mod batch;
pub mod kernels;
pub mod level;
pub mod number;
pub mod policy;
pub mod registry;
pub mod measure;
pub mod stats;
pub mod oracle;
pub mod workload;
#[cfg(feature = "cli")]
pub mod table;

//! ray_test
#![forbid(unsafe_code)]

pub mod accuracy;
pub mod batch;
#[cfg(feature = "cli")]
pub mod chart;
#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "cli")]
pub mod experiment;
pub mod job;
pub mod kernels;
pub mod level;
pub mod measure;
pub mod number;
pub mod oracle;
pub mod policy;
pub mod registry;
pub mod stats;
#[cfg(feature = "cli")]
pub mod table;
pub mod workload;

//! ray_test
#![forbid(unsafe_code)]
#[cfg(feature = "cli")]
pub mod chart;
pub mod job;
pub mod workload;
#[cfg(feature = "cli")]
pub mod table;

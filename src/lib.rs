//! ray_test
#![forbid(unsafe_code)]
pub mod job;
pub mod workload;
#[cfg(feature = "cli")]
pub mod table;

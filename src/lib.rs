//! ray_test
#![forbid(unsafe_code)]
pub mod job;
pub mod workload;

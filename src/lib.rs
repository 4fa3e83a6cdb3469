//! ray_test
#![forbid(unsafe_code)]
pub mod job;
pub mod measure;
pub mod stats;
pub mod workload;

//! ray_test
#![forbid(unsafe_code)]
pub mod job;
pub mod oracle;
pub mod workload;

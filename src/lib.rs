//! ray_test
#![forbid(unsafe_code)]
pub mod batch;
pub mod counting;
pub mod job;
pub mod kernels;
pub mod level;
pub mod measure;
pub mod number;
pub mod oracle;
pub mod policy;
pub mod registry;
pub mod stats;
pub mod workload;

//! What holds whatever is asked for: of drawn workloads, of statistics, of charts. Everything is drawn from seeds that
//! are the same in every run; a library that draws for us would add its own reports, and its own way to shrink, to
//! what a seed and a message say as well.

#[cfg(feature = "cli")]
mod charts;
#[cfg(feature = "cli")]
#[path = "../support/picture.rs"]
mod picture;
mod statistics;
mod workloads;

use ray_test::workload::Pcg;

/// From 0 to 1, without 1.
fn unit(pcg: &mut Pcg) -> f64 {
    (pcg.bits() >> 11) as f64 / (1u64 << 53) as f64
}

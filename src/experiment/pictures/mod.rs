//! The workload `pictures`: what a kernel makes of a ray tracer's time.
//!
//! A *test* of these rows is a whole picture. Ratios refer to the same picture made from recorded answers,
//! that is without any search, measured in the same rounds: 1 - 1 / ratio is the share of the time that
//! goes into searching. Every picture is held against the exact one, ray by ray, before it is timed.

mod run;
mod workload;

pub use run::{blocks, run, seconds_around};
pub use workload::{PictureSet, PicturesWorkload, Sampling};

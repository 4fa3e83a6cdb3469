//! Why a workload cannot be drawn.

use thiserror::Error;

/// A specification that is refused, or that could not be met.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum WorkloadError {
    /// A built-in scene that cannot be made.
    #[error("{0}")]
    Scene(String),
    /// A number of things outside what is allowed.
    #[error("{what} is {value}; allowed is {low} to {high}")]
    Count {
        /// What is counted.
        what: &'static str,
        /// The number given.
        value: u64,
        /// Smallest allowed.
        low: u64,
        /// Largest allowed.
        high: u64,
    },
    /// A density that is no share.
    #[error("density is {value}; allowed is a number from 0 to 1")]
    Density {
        /// The number given.
        value: f64,
    },
    /// A spread of rays that are not in bunches, or of bunches that have none.
    #[error(
        "spread is {value}; allowed is above 0 and at most {most} for bunches, and 0 for others"
    )]
    Spread {
        /// What was asked for.
        value: f32,
        /// The largest that is allowed.
        most: f32,
    },
    /// Rays that do not fill the widest packet.
    #[error("number of rays is {value}; allowed is a multiple of {multiple}")]
    Packets {
        /// The number given.
        value: usize,
        /// What it must be a multiple of.
        multiple: usize,
    },
    /// A seed that the generator cannot hold.
    #[error("seed is {value}; allowed for the generator msvc is 0 to {high}")]
    Seed {
        /// The number given.
        value: u64,
        /// Largest allowed.
        high: u64,
    },
    /// The quota was not filled within the bound on attempts.
    #[error(
        "after {attempts} attempts only {hits} of {hits_wanted} hits and {misses} of \
         {misses_wanted} misses were found"
    )]
    Quota {
        /// Pairs drawn.
        attempts: u64,
        /// Hits found.
        hits: usize,
        /// Hits that were to be found.
        hits_wanted: usize,
        /// Misses found.
        misses: usize,
        /// Misses that were to be found.
        misses_wanted: usize,
    },
    /// It was told to end while it was drawn.
    #[error("drawing it was interrupted")]
    Cancelled,
    /// Rays whose answers are beyond rounding were too rare.
    #[error("after {attempts} attempts only {rays} of {wanted} rays have answers beyond rounding")]
    Rays {
        /// Rays drawn.
        attempts: u64,
        /// Rays kept.
        rays: usize,
        /// Rays that were to be kept.
        wanted: usize,
    },
}

/// Refuses a count outside `low..=high`.
pub(super) fn counted(
    what: &'static str,
    value: usize,
    low: u64,
    high: u64,
) -> Result<(), WorkloadError> {
    let value = value as u64;
    if (low..=high).contains(&value) {
        Ok(())
    } else {
        Err(WorkloadError::Count { what, value, low, high })
    }
}

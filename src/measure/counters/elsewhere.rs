//! Stands in where no counters can be read.

use super::{Counters, Counts};
use std::convert::Infallible;

/// Counters that cannot be opened here.
pub struct HardwareCounters {
    never: Infallible,
}

impl HardwareCounters {
    /// Opens nothing.
    ///
    /// # Errors
    /// Always.
    pub fn open() -> Result<Self, String> {
        Err("counters are read on Linux only, on x86-64, Arm and RISC-V of 64 bits".to_owned())
    }
}

impl Counters for HardwareCounters {
    fn start(&mut self) {
        match self.never {}
    }

    fn stop(&mut self) -> Option<Counts> {
        match self.never {}
    }

    fn names(&self) -> Vec<&'static str> {
        match self.never {}
    }
}

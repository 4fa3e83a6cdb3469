//! What the processor does next to a block: how long its cycles are, and whether it is shared.

use super::clock::Clock;

/// What was read at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Length of a cycle, ns.
    pub ns_per_cycle: f64,
    /// Whether somebody else uses the core, or the reading itself was disturbed.
    pub crowded: bool,
}

/// Reads the processor's state.
pub trait Ruler {
    /// The state now; `None` where nobody can tell.
    fn read(&mut self, clock: &mut dyn Clock) -> Option<Reading>;
    /// Looks for a processor without a neighbour, for some ms at most, and stays there; before a
    /// group, never within one.
    fn settle(&mut self, _clock: &mut dyn Clock) {}
}

/// Never tells.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoRuler;

impl Ruler for NoRuler {
    fn read(&mut self, _clock: &mut dyn Clock) -> Option<Reading> {
        None
    }
}

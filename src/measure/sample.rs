//! What a block took.

use super::counters::Counts;

/// One block of one contestant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    /// Time of the whole block.
    pub ns: u64,
    /// Tests in it.
    pub tests: u64,
    /// What the clock said at its end, ns.
    pub at_ns: u64,
    /// Which window of the items it was.
    pub window: usize,
    /// What the processor counted over the block, where it does.
    pub counts: Option<Counts>,
    /// Length of a cycle before and after it, on average, where a ruler tells.
    pub ns_per_cycle: Option<f64>,
    /// Whether a neighbour was seen right before or after it, or another block of its round.
    pub crowded: bool,
    /// How many times longer a pass over all windows takes than one of this window, per test; 1
    /// until [`super::windows`] has found out.
    pub share_of_pass: f64,
}

impl Sample {
    pub fn ns_per_test(&self) -> f64 {
        self.ns as f64 / self.tests as f64 * self.share_of_pass
    }
}

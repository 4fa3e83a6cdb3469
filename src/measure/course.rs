//! What goes on from block to block.

use super::clock::Clock;
use super::ruler::{Reading, Ruler};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

/// The state of a group that its blocks share.
pub(super) struct Course {
    /// For new orders.
    pub rng: Pcg64Mcg,
    /// Blocks that may still be run again because of a neighbour.
    pub spare_blocks: usize,
    /// Blocks that were.
    pub repeated_blocks: usize,
    /// The core after the last block.
    latest: Option<Reading>,
}

impl Course {
    /// At its start; nothing may be run again yet.
    pub fn new(seed: u64) -> Self {
        let rng = Pcg64Mcg::seed_from_u64(seed);
        Course { rng, spare_blocks: 0, repeated_blocks: 0, latest: None }
    }

    /// Forgets the last look: others have run since.
    pub fn look_again(&mut self) {
        self.latest = None;
    }

    /// Takes one of the spare blocks, if there is one left.
    pub fn take_spare(&mut self) -> bool {
        let granted = self.spare_blocks > 0;
        self.spare_blocks -= usize::from(granted);
        self.repeated_blocks += usize::from(granted);
        granted
    }

    /// The core before a block, which is as it was after the one before, unless a neighbour was
    /// there: he may have gone. A look takes 15 us, as much as some blocks.
    pub fn before(&mut self, ruler: &mut dyn Ruler, clock: &mut dyn Clock) -> Option<Reading> {
        match self.latest {
            Some(reading) if !reading.crowded => Some(reading),
            _ => self.look(ruler, clock),
        }
    }

    /// The core now.
    pub fn look(&mut self, ruler: &mut dyn Ruler, clock: &mut dyn Clock) -> Option<Reading> {
        self.latest = ruler.read(clock);
        self.latest
    }
}

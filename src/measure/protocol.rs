//! How a group is measured: block length, rounds, order.

use serde::{Deserialize, Serialize};
use std::fmt;

/// In which order the items of a block are done, and so what the branch predictor knows of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Order {
    /// Each item many times in a row (thesis B's loop): prediction costs next to nothing.
    Literal,
    /// The set replayed from start to end: the predictor has memorised the outcomes.
    Fixed,
    /// A new permutation before every timed block: outcomes cannot be foreseen.
    Reshuffled,
}

impl Order {
    /// The word in the `order` column.
    pub fn word(self) -> &'static str {
        match self {
            Order::Literal => "literal",
            Order::Fixed => "fixed",
            Order::Reshuffled => "reshuffled",
        }
    }
}

impl fmt::Display for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// How the items of a block are run, and so what their time says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pace {
    /// As fast as they come; the next item may begin before the last has ended.
    Throughput,
    /// The same of a set that may not fit the caches: a walk over all items that goes on from block to
    /// block. What a block finds near is what the walk left there ([`crate::job::Job::approach`]).
    Walk,
    /// The jobs make each item wait for the answer to the one before ([`super::Dependent`]). The
    /// calls themselves may be most of the time, so nothing is said of too short ones.
    Latency,
    /// A block is one item, run once, after everything that could remember its code was made to
    /// forget; the same item for all contestants of a round. Block length and order mean nothing.
    Cold,
}

/// How a group of contestants is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Protocol {
    /// Length of a timed block, ns. Long against the timer's 20-30 ns, short against the time
    /// between two pre-emptions: 16-136 us measured well, 0.5 ms and more badly.
    pub block_ns: u64,
    /// Least number of rounds, at least [`Protocol::LEAST_ROUNDS`].
    pub rounds: usize,
    /// `true`: exactly `rounds`, even if not everybody stands equally often in each position.
    /// `false`: rounded up to a multiple of the number of contestants.
    pub exact_rounds: bool,
    /// Order of the items.
    pub order: Order,
    /// Seed of the positions and permutations.
    pub seed: u64,
    /// How the items of a block are run.
    pub pace: Pace,
    /// Whether what takes less time than its work can is refused; not on a clock that is moved by
    /// something else than the work.
    pub guards: bool,
    /// Relative difference that is none, > 0, whatever the noise allows to see.
    pub margin: f64,
    /// At most so many blocks are run again because a neighbour was seen, however many
    /// [`Protocol::spare_blocks`] would allow.
    pub most_spare_blocks: usize,
}

/// Why a group cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ProtocolError {
    /// Fewer rounds than an interval needs.
    #[error("rounds: {0} are too few, {least} or more are needed", least = Protocol::LEAST_ROUNDS)]
    FewRounds(usize),
    /// A block outside of what was found to measure well, generously.
    #[error("block_ns: {0} is not within 1000 to 100000000")]
    BlockLength(u64),
    /// A margin that is none.
    #[error("margin: {0} is not allowed; allowed: above 0, at most 1")]
    Margin(f64),
    /// An empty group.
    #[error("there is no contestant to measure")]
    Nobody,
    /// Two contestants of one id.
    #[error("two contestants have the id {0}")]
    SameId(String),
    /// Two contestants of a role that there is one of.
    #[error("more than one contestant is the {0}")]
    SameRole(&'static str),
    /// A job without items or tests, or with more items than a permutation of u32 can name.
    #[error("{id}: {items} items of {tests_per_item} tests cannot be measured")]
    Items {
        /// The contestant.
        id: String,
        /// Its number of items.
        items: usize,
        /// Its tests per item.
        tests_per_item: u64,
    },
}

impl Protocol {
    /// With fewer rounds the interval is that of the extremes, or none (below 6).
    pub const LEAST_ROUNDS: usize = 8;

    /// How many times more rounds a reshuffled order takes, of blocks a third as long: its noise is
    /// one of blocks (how far a predictor gets with this order), 1.5 % of 1000 tests as of 4000.
    pub const RESHUFFLED_TIMES: usize = 4;

    /// Blocks of 60 us (20 us reshuffled), 64 rounds, for throughput; a difference below 1 % is none.
    pub fn new(order: Order, seed: u64) -> Self {
        Protocol {
            block_ns: if order == Order::Reshuffled { 20_000 } else { 60_000 },
            rounds: 64,
            exact_rounds: false,
            order,
            seed,
            pace: Pace::Throughput,
            guards: true,
            margin: 0.01,
            most_spare_blocks: usize::MAX,
        }
    }

    /// Refuses what cannot be measured.
    pub fn validate(&self) -> Result<(), ProtocolError> {
        if self.rounds < Self::LEAST_ROUNDS {
            return Err(ProtocolError::FewRounds(self.rounds));
        }
        if !(1_000..=100_000_000).contains(&self.block_ns) {
            return Err(ProtocolError::BlockLength(self.block_ns));
        }
        if !(self.margin > 0.0 && self.margin <= 1.0) {
            return Err(ProtocolError::Margin(self.margin));
        }
        Ok(())
    }

    /// Rounds of a group of `contestants`.
    pub fn planned_rounds(&self, contestants: usize) -> usize {
        if self.exact_rounds || contestants == 0 {
            return self.rounds;
        }
        let more = self.order == Order::Reshuffled && self.pace == Pace::Throughput;
        let rounds = self.rounds * if more { Self::RESHUFFLED_TIMES } else { 1 };
        rounds.div_ceil(contestants).saturating_mul(contestants)
    }

    /// Time inside the timed blocks of a group of `contestants`, ns: rounds x contestants x block.
    /// Calibration, permutations, warm-up passes and repeated rounds come on top of it.
    pub fn planned_ns(&self, contestants: usize) -> u64 {
        let blocks = (self.planned_rounds(contestants) as u64).saturating_mul(contestants as u64);
        blocks.saturating_mul(self.block_ns)
    }

    /// How many rounds may be dirty before a machine is taken to be too busy for even
    /// [`Protocol::LEAST_ROUNDS`] clean ones: four times what was planned.
    pub fn most_dirty_rounds(&self, contestants: usize) -> usize {
        self.planned_rounds(contestants).saturating_mul(4)
    }

    /// How many blocks may be run again because a neighbour was seen: five quarters of them, so that
    /// a core that is shared for half of the time is measured while it is not, and one that is
    /// always shared takes little more than twice the time.
    pub fn spare_blocks(&self, contestants: usize) -> usize {
        let planned = self.planned_rounds(contestants).saturating_mul(contestants);
        (planned.saturating_mul(5) / 4).min(self.most_spare_blocks)
    }

    /// What an attempt at a block takes, about, ns: itself, the warming and the laying out of a new
    /// order, and a look at the core.
    pub fn attempt_ns(&self) -> u64 {
        const LOOK_NS: u64 = 15_000;
        let lay_out_ns = match self.order {
            Order::Literal => 0,
            Order::Fixed => self.block_ns / 2,
            Order::Reshuffled => self.block_ns + self.block_ns / 4,
        };
        lay_out_ns + self.block_ns + LOOK_NS
    }

    /// How many rounds may be run again because something disturbed them: a quarter.
    pub fn spare_rounds(&self, contestants: usize) -> usize {
        self.planned_rounds(contestants).div_ceil(4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_become_a_multiple_of_the_contestants() {
        let mut protocol = Protocol::new(Order::Fixed, 1);
        assert_eq!(protocol.planned_rounds(16), 64);
        assert_eq!(protocol.planned_rounds(9), 72);
        assert_eq!(protocol.planned_ns(9), 72 * 9 * 60_000);
        assert_eq!(protocol.spare_rounds(9), 18);
        assert_eq!(protocol.spare_blocks(9), 810);
        assert_eq!(Protocol { most_spare_blocks: 5, ..protocol.clone() }.spare_blocks(9), 5);
        assert_eq!(protocol.attempt_ns(), 105_000);
        protocol.exact_rounds = true;
        assert_eq!(protocol.planned_rounds(9), 64);
        // Four times as many, a third as long; calls one by one stay as they are.
        let reshuffled = Protocol::new(Order::Reshuffled, 1);
        assert_eq!((reshuffled.planned_rounds(16), reshuffled.block_ns), (256, 20_000));
        assert_eq!(reshuffled.attempt_ns(), 60_000);
        assert_eq!(Protocol { pace: Pace::Cold, ..reshuffled }.planned_rounds(16), 64);
    }

    #[test]
    fn refuses_what_is_out_of_range() {
        let good = Protocol::new(Order::Literal, 1);
        assert_eq!(good.validate(), Ok(()));
        let few = Protocol { rounds: 7, ..good.clone() };
        assert_eq!(few.validate(), Err(ProtocolError::FewRounds(7)));
        let short = Protocol { block_ns: 999, ..good.clone() };
        assert_eq!(short.validate(), Err(ProtocolError::BlockLength(999)));
        let none = Protocol { margin: 0.0, ..good };
        assert_eq!(none.validate(), Err(ProtocolError::Margin(0.0)));
    }
}

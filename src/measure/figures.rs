//! What a group of contestants took.

use super::contestant::Role;
use super::trace::RoundTrace;
use crate::stats::{Decision, Interval, Ratio};

/// Why a contestant has no figures.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Invalid {
    /// Its items, one by one, do not find what the checked answers say.
    #[error("its items found {found} hits, the checked answers have {expected}")]
    Hits {
        /// Hits in the answers that were checked.
        expected: u64,
        /// Hits of the items run one by one.
        found: u64,
    },
    /// A timed block found something else than its items one by one.
    #[error("the timed block of round {round} found something else than its items one by one")]
    Tally {
        /// The round, counted from 0 over clean ones.
        round: usize,
    },
    /// A block took no time: it was optimised away, or the clock is too coarse.
    #[error("a block took no time")]
    NoTime,
    /// Twice the work did not take twice the time: the repeats were folded into one.
    #[error("twice the work took {times:.2} times the time, not twice: work was left out")]
    NoMoreForMore {
        /// How many times longer the whole took than its half.
        times: f64,
    },
    /// It takes no longer than a loop without a test in it.
    #[error("it takes no longer than an empty loop: the test was optimised away")]
    LikeNothing,
    /// It takes less than its own operations need on any core.
    #[error("{cycles:.2} cycles are less than its operations take on any core, {least:.2}")]
    TooFast {
        /// Cycles of a test, as measured.
        cycles: f64,
        /// Cycles that its operations need at least.
        least: f64,
    },
    /// It was not measured: every round was disturbed.
    #[error("no undisturbed round was measured")]
    NoRound,
    /// Cancelled before there were enough rounds for figures that stand.
    #[error("interrupted after {rounds} undisturbed rounds")]
    Interrupted {
        /// Clean rounds until then.
        rounds: usize,
    },
}

/// Whether the figures stand.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// They do.
    Ok,
    /// There are none.
    Invalid(Invalid),
}

/// Where cycles come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CyclesSource {
    /// The processor's own counter.
    Counter,
    /// The time over that of the chain in the same round.
    Chain,
}

impl CyclesSource {
    /// The word in the column `cycles_source`.
    pub fn word(self) -> &'static str {
        match self {
            CyclesSource::Counter => "counter",
            CyclesSource::Chain => "chain",
        }
    }
}

/// What one contestant took. Figures that are withheld or need what the group does not have
/// (a reference, a chain, enough rounds) are `None`.
#[derive(Clone, Debug, PartialEq)]
pub struct Figures {
    /// The contestant.
    pub id: String,
    /// What it was there for.
    pub role: Role,
    /// Whether the figures stand.
    pub status: Status,
    /// Clean rounds, the same for the whole group.
    pub rounds: usize,
    /// Rounds that were dropped because something else ran in between.
    pub dirty_rounds: usize,
    /// Median over the rounds, ns.
    pub ns_per_test: Option<f64>,
    /// Lower end of the median's exact 95 % interval, ns; from 6 rounds on.
    pub ns_low: Option<f64>,
    /// Upper end.
    pub ns_high: Option<f64>,
    /// Smallest of the rounds, ns.
    pub min_ns: Option<f64>,
    /// Processor cycles of a test: median over the rounds.
    pub cycles_per_test: Option<f64>,
    /// The median's exact 95 % interval.
    pub cycles_interval: Option<Interval>,
    /// The median over the first half of the rounds alone.
    pub cycles_first_half: Option<f64>,
    /// And over the second half.
    pub cycles_second_half: Option<f64>,
    /// Where cycles come from.
    pub cycles_source: CyclesSource,
    /// Instructions of a test, where they are counted.
    pub instructions_per_test: Option<f64>,
    /// Mispredicted branches of a test, where they are counted.
    pub mispredicts_per_test: Option<f64>,
    /// Time over that of the reference in the same round (> 1 is slower).
    pub ratio_to_reference: Option<Ratio>,
    /// The same over the first half of the rounds alone; from 12 rounds on.
    pub ratio_first_half: Option<Ratio>,
    /// And over the second half.
    pub ratio_second_half: Option<Ratio>,
    /// What may be said of the ratio; the reference, the chain and the empty loop have none.
    pub decision: Option<Decision>,
    /// Order `fixed`: median block among the others over the median alone, both in terms of the
    /// chain. Above 1 where the set is more than the branch predictor remembers.
    pub solo_ratio: Option<f64>,
    /// Share of its time that an empty loop takes: median over the rounds.
    pub empty_loop_ratio: Option<f64>,
    /// Tests of its first block.
    pub tests_per_block: u64,
    /// Repeats of each of its blocks.
    pub repeats: usize,
    /// Windows that its items were cut into.
    pub windows: usize,
    /// ns per test, one a clean round, in the order measured; levelled, where rounds were cut into
    /// windows.
    pub samples: Vec<f64>,
}

/// What a group took.
#[derive(Clone, Debug, PartialEq)]
pub struct GroupReport {
    /// In the order of the contestants.
    pub figures: Vec<Figures>,
    /// Largest |ln ratio| of a placebo to the reference: what identical code differs by.
    pub placebo_floor: Option<f64>,
    /// Smallest relative difference that can be told from chance and code placement.
    pub noise_floor: f64,
    /// Rounds that were planned.
    pub planned_rounds: usize,
    /// Clean rounds.
    pub rounds: usize,
    /// Dropped rounds.
    pub dirty_rounds: usize,
    /// Share of the clean rounds in which somebody else used the core: 0, unless there would have
    /// been too few without them.
    pub crowded_share: f64,
    /// Blocks that were run again because somebody else used the core.
    pub repeated_blocks: usize,
    /// Planned length of all timed blocks, ns.
    pub planned_ns: u64,
    /// Whether it was ended before its time.
    pub cancelled: bool,
    /// Every round that was run to its end, dropped ones too, in their order.
    pub trace: Vec<RoundTrace>,
}

//! The thesis's loop in slices: short enough for kernels to take turns and for Ctrl-C to be heard.

use crate::job::Block;
use crate::measure::Order;

/// Tests in one timed slice, about: long against the clock, short against a pre-emption.
const SLICE_TESTS: u64 = 20_000;

/// Repeats of one pair in a slice at most, so that an interrupt is heard within a moment.
const MOST_REPEATS: u64 = 1 << 20;

/// All tests, cut into slices: pairs, each many times in a row, in `literal` order; passes over the
/// set in the others.
#[derive(Clone, Copy)]
pub struct Slices {
    /// Order of the tests.
    pub order: Order,
    pairs: usize,
    /// How often each pair is computed.
    pub repeats: u64,
    /// Pairs of a literal slice.
    window: usize,
    /// Repeats, or passes, of a slice.
    most: u64,
    first: usize,
    done: u64,
}

impl Slices {
    /// From the first test on.
    pub fn new(order: Order, pairs: usize, repeats: u64) -> Self {
        let all = pairs.max(1) as u64;
        let (window, most) = match order {
            Order::Literal => ((SLICE_TESTS / repeats).clamp(1, all) as usize, MOST_REPEATS),
            Order::Fixed => (pairs, (SLICE_TESTS / all).max(1)),
            Order::Reshuffled => (pairs, 1),
        };
        Slices { order, pairs, repeats, window, most, first: 0, done: 0 }
    }

    /// How many slices there are.
    pub fn number(&self) -> usize {
        let turns = self.repeats.div_ceil(self.most);
        let windows = self.pairs.div_ceil(self.window.max(1)) as u64;
        usize::try_from(turns.saturating_mul(windows)).unwrap_or(usize::MAX)
    }
}

impl Iterator for Slices {
    type Item = Block;

    fn next(&mut self) -> Option<Block> {
        if self.first >= self.pairs {
            return None;
        }
        let repeats = (self.repeats - self.done).min(self.most);
        let block = Block {
            first: self.first,
            items: self.window.min(self.pairs - self.first),
            repeats: usize::try_from(repeats).unwrap_or(usize::MAX),
            literal: self.order == Order::Literal,
        };
        self.done += repeats;
        if self.done == self.repeats {
            self.done = 0;
            self.first += self.window;
        }
        Some(block)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_is_done_as_often_as_asked() {
        for (order, pairs, repeats) in [
            (Order::Literal, 7, 3),
            (Order::Literal, 3, 50_000),
            (Order::Literal, 2, (1 << 21) + 5),
            (Order::Fixed, 30, 10_000),
            (Order::Reshuffled, 5, 4),
        ] {
            let slices = Slices::new(order, pairs, repeats);
            let mut done = vec![0u64; pairs];
            for block in slices {
                assert_eq!(block.literal, order == Order::Literal);
                for count in &mut done[block.first..block.first + block.items] {
                    *count += block.repeats as u64;
                }
            }
            assert!(done.iter().all(|count| *count == repeats), "{order} {pairs} {repeats}");
            assert_eq!(slices.count(), slices.number(), "{order} {pairs} {repeats}");
        }
    }
}

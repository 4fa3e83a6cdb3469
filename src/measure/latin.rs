//! Who runs when: positions that favour nobody.

use super::shuffle::shuffle;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

/// The order of the contestants in round after round: a cyclic Latin square whose rows and names
/// are drawn anew every `contestants` rounds. So within each such bundle everybody stands once in
/// each position, and who stands behind whom changes from bundle to bundle.
#[derive(Clone, Debug)]
pub struct LatinOrder {
    rng: Pcg64Mcg,
    names: Vec<usize>,
    shifts: Vec<usize>,
    round: usize,
}

impl LatinOrder {
    /// Orders for `contestants` contestants; the same seed gives the same orders.
    pub fn new(contestants: usize, seed: u64) -> Self {
        LatinOrder {
            rng: Pcg64Mcg::seed_from_u64(seed),
            names: (0..contestants).collect(),
            shifts: (0..contestants).collect(),
            round: 0,
        }
    }

    /// The contestants (0..contestants) of the next round in the order in which they run.
    pub fn next_round(&mut self) -> Vec<usize> {
        let contestants = self.names.len();
        if contestants == 0 {
            return Vec::new();
        }
        if self.round.is_multiple_of(contestants) {
            shuffle(&mut self.rng, &mut self.names);
            shuffle(&mut self.rng, &mut self.shifts);
        }
        let shift = self.shifts[self.round % contestants];
        self.round += 1;
        (0..contestants).map(|p| self.names[(p + shift) % contestants]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everybody_stands_once_in_each_position() {
        for contestants in 1..=9 {
            let mut order = LatinOrder::new(contestants, 42);
            for _bundle in 0..4 {
                let mut seen = vec![vec![0; contestants]; contestants];
                for _ in 0..contestants {
                    for (position, name) in order.next_round().into_iter().enumerate() {
                        seen[name][position] += 1;
                    }
                }
                assert!(seen.iter().flatten().all(|&n| n == 1), "{contestants}: {seen:?}");
            }
        }
    }

    #[test]
    fn bundles_differ_and_seeds_repeat() {
        let mut order = LatinOrder::new(6, 1);
        let mut again = LatinOrder::new(6, 1);
        let bundle = |o: &mut LatinOrder| (0..6).map(|_| o.next_round()).collect::<Vec<_>>();
        let (first, second) = (bundle(&mut order), bundle(&mut order));
        assert_ne!(first, second);
        assert_eq!((first, second), (bundle(&mut again), bundle(&mut again)));
    }

    #[test]
    fn nobody_is_no_error() {
        assert!(LatinOrder::new(0, 1).next_round().is_empty());
    }
}

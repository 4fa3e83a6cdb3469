//! Whether the clock and the cycles of a round keep step: a second sign, beside switches, that
//! something else ran in our place. A hypervisor that takes the processor away counts no switch.

use super::chain::CYCLES_PER_STEP;
use super::contestant::Role;
use super::runner::Runner;
use crate::stats::median;
use std::collections::VecDeque;

/// Rounds that a round is compared with. Few, so that a machine that changes its clock speed for
/// good is soon believed.
const REMEMBERED: usize = 9;

/// A round is disturbed when it gets less than this share of the usual cycles in its time.
const LEAST_SHARE: f64 = 0.9;

/// The pace of recent rounds, in cycles per ns.
#[derive(Clone, Debug, Default)]
pub(super) struct Steadiness {
    recent: VecDeque<f64>,
}

impl Steadiness {
    /// Whether the round just run kept the pace of those before it; the first few always do.
    pub fn keeps_step(&mut self, runners: &[Runner<'_>]) -> bool {
        pace(runners).is_none_or(|pace| self.is_usual(pace))
    }

    fn is_usual(&mut self, pace: f64) -> bool {
        let usual = median(self.recent.make_contiguous());
        let enough = self.recent.len() > REMEMBERED / 2;
        if self.recent.len() == REMEMBERED {
            self.recent.pop_front();
        }
        self.recent.push_back(pace);
        !enough || usual.is_none_or(|usual| pace >= LEAST_SHARE * usual)
    }
}

/// Cycles per ns of the round that is pending: counted over all blocks, else by the chain, whose
/// cycles are known.
fn pace(runners: &[Runner<'_>]) -> Option<f64> {
    let pending = || runners.iter().filter_map(|runner| runner.pending);
    let counted: Option<Vec<(f64, f64)>> =
        pending().map(|s| Some((s.counts?.cycles as f64, s.ns as f64))).collect();
    if let Some(blocks) = counted
        && !blocks.is_empty()
    {
        let sum = |of: fn(&(f64, f64)) -> f64| blocks.iter().map(of).sum::<f64>();
        return Some(sum(|b| b.0) / sum(|b| b.1));
    }
    if pending().any(|sample| sample.counts.is_some()) {
        // Some were not counted: nothing that could be held against the other rounds.
        return None;
    }
    let chain = runners.iter().find(|r| r.contestant.role == Role::Chain)?.pending?;
    // In cycles by the ruler, where there is one: then the clock speed may change as it likes.
    Some(CYCLES_PER_STEP * chain.ns_per_cycle.unwrap_or(1.0) / chain.ns_per_test())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answers(paces: &[f64]) -> Vec<bool> {
        let mut steadiness = Steadiness::default();
        paces.iter().map(|pace| steadiness.is_usual(*pace)).collect()
    }

    #[test]
    fn one_slow_round_is_seen() {
        let mut paces = [3.0; 12];
        paces[8] = 2.6;
        let mut wanted = [true; 12];
        wanted[8] = false;
        assert_eq!(answers(&paces), wanted);
    }

    #[test]
    fn small_and_upward_steps_are_no_disturbance() {
        assert!(answers(&[3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 2.8, 3.4, 3.0]).iter().all(|&a| a));
    }

    #[test]
    fn a_machine_that_slows_down_for_good_is_soon_believed() {
        let mut paces = vec![3.0; 20];
        paces.extend(vec![2.0; 20]);
        let refused = answers(&paces).iter().filter(|&&a| !a).count();
        assert_eq!(refused, REMEMBERED / 2 + 1);
    }

    #[test]
    fn the_first_rounds_are_believed() {
        assert_eq!(answers(&[3.0, 1.0, 3.0, 3.0]), [true; 4]);
    }
}

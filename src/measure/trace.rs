//! What became of each round, so that it can be seen when a machine was quiet.

use super::contestant::Role;
use super::runner::Runner;

/// What became of a round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoundState {
    /// Nothing was seen beside it.
    Clean,
    /// A neighbour used the core as well.
    Crowded,
    /// Something else ran in between, or the processor changed its speed: it was dropped.
    Dirty,
}

impl RoundState {
    /// The word of the column `state`.
    pub fn word(self) -> &'static str {
        match self {
            RoundState::Clean => "clean",
            RoundState::Crowded => "crowded",
            RoundState::Dirty => "dirty",
        }
    }
}

/// A round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundTrace {
    /// What the clock said at the end of its last block, ns.
    pub at_ns: u64,
    /// Time of the reference, ns per test; levelled, where rounds are cut into windows. `None` in
    /// groups without a reference, or whose reference has failed.
    pub reference_ns_per_test: Option<f64>,
    /// What became of it.
    pub state: RoundState,
    /// Which window of the items the reference's block was.
    window: usize,
}

impl RoundTrace {
    /// A round of a group that is not cut into windows.
    pub fn new(at_ns: u64, reference_ns_per_test: Option<f64>, state: RoundState) -> Self {
        RoundTrace { at_ns, reference_ns_per_test, state, window: 0 }
    }

    /// Of the blocks of the present round; `None` if there are none.
    pub(super) fn of(runners: &[Runner<'_>], state: RoundState) -> Option<Self> {
        let at_ns = runners.iter().filter_map(|r| r.pending).map(|sample| sample.at_ns).max()?;
        let reference = reference(runners).and_then(|runner| runner.pending);
        Some(RoundTrace {
            at_ns,
            reference_ns_per_test: reference.map(|sample| sample.ns_per_test()),
            state,
            window: reference.map_or(0, |sample| sample.window),
        })
    }
}

/// Scales the reference's times as its own samples were: from those of a window to those of a pass.
pub(super) fn level(trace: &mut [RoundTrace], runners: &[Runner<'_>]) {
    let Some(reference) = reference(runners) else { return };
    for round in trace {
        let alike = reference.samples.iter().find(|sample| sample.window == round.window);
        let share = alike.map_or(1.0, |sample| sample.share_of_pass);
        round.reference_ns_per_test = round.reference_ns_per_test.map(|ns| ns * share);
    }
}

fn reference<'a, 'b>(runners: &'a [Runner<'b>]) -> Option<&'a Runner<'b>> {
    runners.iter().find(|runner| runner.contestant.role == Role::Reference)
}

//! Who takes part in a round, and as what.

use super::chain::Chain;
use super::empty::EmptyLoop;
use super::protocol::ProtocolError;
use crate::job::Job;

/// A contestant may be in one group with so many others: with the controls they stay within what a
/// branch predictor holds of a replayed set.
pub const MOST_SUBJECTS: usize = 12;

/// Copies of the reference in a group; several, since copies differ by where they lie.
pub const PLACEBOS: usize = 2;

/// What a contestant is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// To be measured.
    Subject,
    /// What the others are compared with; at most one.
    Reference,
    /// The reference's code at another address: what it differs by is noise. Any number.
    Placebo,
    /// The loop without a test in it ([`super::EmptyLoop`]); at most one.
    Empty,
    /// The chain of known cycles ([`super::Chain`]); at most one.
    Chain,
}

impl Role {
    /// Whether the order of its items means nothing to it, so that it is replayed in every order.
    pub(super) fn is_orderless(self) -> bool {
        matches!(self, Role::Empty | Role::Chain)
    }
}

/// What the items of a job must find, beyond agreeing with themselves in every timed block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// Whatever they find one by one before anything is timed.
    Items,
    /// That, and this number of hits over all items: the number in the answers that were checked.
    Hits(u64),
}

/// One participant. Its answers were found right before it comes here.
pub struct Contestant {
    /// Its id, unique within the group.
    pub id: String,
    /// What it is there for.
    pub role: Role,
    /// What is run, in its original order.
    pub job: Box<dyn Job>,
    /// What it must find.
    pub expected: Expected,
    /// Tests that one walk through its inner loop does at once: the lanes of a packet, else 1.
    pub lanes: usize,
    /// Cycles that a test cannot take less than, by its count of operations; 0 if nobody counted.
    pub least_cycles: f64,
}

impl Contestant {
    /// A contestant that must find what its items find one by one.
    pub fn new(id: impl Into<String>, role: Role, job: Box<dyn Job>) -> Self {
        let (id, expected) = (id.into(), Expected::Items);
        Contestant { id, role, job, expected, lanes: 1, least_cycles: 0.0 }
    }

    /// The same, with what a time of it is held against: see the fields.
    pub fn with_limits(self, lanes: usize, least_cycles: f64) -> Self {
        Contestant { lanes, least_cycles, ..self }
    }

    /// The same, and `hits` hits over all of its items.
    pub fn with_hits(self, hits: u64) -> Self {
        Contestant { expected: Expected::Hits(hits), ..self }
    }
}

/// What every group has besides kernels: the loop of `like` without a test in it, and the chain of
/// known cycles.
pub fn yardsticks(like: &dyn Job) -> [Contestant; 2] {
    [
        Contestant::new("empty loop", Role::Empty, Box::new(EmptyLoop::like(like))),
        Contestant::new("chain", Role::Chain, Box::new(Chain::default())),
    ]
}

/// Refuses groups that cannot be measured.
pub(super) fn validate(contestants: &[Contestant]) -> Result<(), ProtocolError> {
    if contestants.is_empty() {
        return Err(ProtocolError::Nobody);
    }
    let mut ids = std::collections::BTreeSet::new();
    for contestant in contestants {
        let (items, tests_per_item) = (contestant.job.items(), contestant.job.tests_per_item());
        if items == 0 || tests_per_item == 0 || u32::try_from(items).is_err() {
            let id = contestant.id.clone();
            return Err(ProtocolError::Items { id, items, tests_per_item });
        }
        if !ids.insert(&contestant.id) {
            return Err(ProtocolError::SameId(contestant.id.clone()));
        }
    }
    let singles =
        [(Role::Reference, "reference"), (Role::Empty, "empty loop"), (Role::Chain, "chain")];
    for (role, name) in singles {
        if contestants.iter().filter(|c| c.role == role).count() > 1 {
            return Err(ProtocolError::SameRole(name));
        }
    }
    Ok(())
}

//! What is examined: the reference kernel and its copies, which should be equal.

use crate::experiment::{Bench, Facts, Scene, control};
use crate::measure::{Contestant, GroupReport, Order, Protocol, ProtocolError, Role, yardsticks};
use crate::registry::{self, REFERENCE, Variant};
use crate::workload::{PairSpec, Pairs, WorkloadError};

/// Why nothing can be told.
#[derive(Debug, thiserror::Error)]
pub enum DoctorError {
    /// Pairs cannot be drawn.
    #[error(transparent)]
    Workload(#[from] WorkloadError),
    /// A group cannot be measured.
    #[error(transparent)]
    Protocol(#[from] ProtocolError),
    /// The reference is not there, or wrong about the pairs.
    #[error("the reference kernel {REFERENCE} cannot be measured")]
    NoReference,
}

/// Pairs of which half hit, with the kernels that all examinations use.
pub struct Ward {
    scene: Scene,
    reference: &'static Variant,
    copies: Vec<&'static Variant>,
}

impl Ward {
    /// As many pairs as `order` takes in an experiment.
    ///
    /// # Errors
    /// When the pairs cannot be drawn.
    pub fn new(order: Order) -> Result<Self, DoctorError> {
        Self::with_pairs(if order == Order::Reshuffled { 1000 } else { 500 })
    }

    /// So many pairs.
    ///
    /// # Errors
    /// When they cannot be drawn.
    pub fn with_pairs(pairs: usize) -> Result<Self, DoctorError> {
        let spec = PairSpec::new(pairs, 0.5, 1);
        let reference = registry::find(REFERENCE).ok_or(DoctorError::NoReference)?;
        let copies = registry::placebos().iter().filter(|copy| copy.is_copy_of(reference));
        let scene = Scene::of_pairs(Pairs::draw(spec)?);
        Ok(Ward { scene, reference, copies: copies.collect() })
    }

    /// Number of copies of the reference.
    pub fn copies(&self) -> usize {
        self.copies.len()
    }

    /// What is known of the pairs.
    pub fn facts(&self) -> &Facts {
        &self.scene.facts
    }

    /// The reference in a role.
    pub(super) fn reference(&self, role: Role) -> Result<Contestant, DoctorError> {
        control(self.reference, role, &self.scene).ok_or(DoctorError::NoReference)
    }

    /// Reference, empty loop, chain, and the copies; the one of number `subject` is judged, the
    /// others tell the noise.
    pub(super) fn group(&self, subject: Option<usize>) -> Result<Vec<Contestant>, DoctorError> {
        let reference = self.reference(Role::Reference)?;
        let yardsticks = yardsticks(reference.job.as_ref());
        let mut group: Vec<Contestant> = std::iter::once(reference).chain(yardsticks).collect();
        for (number, copy) in self.copies.iter().enumerate() {
            let role = if subject == Some(number) { Role::Subject } else { Role::Placebo };
            group.extend(control(copy, role, &self.scene));
        }
        Ok(group)
    }
}

/// Measures a group; `seed` makes its positions and permutations its own.
pub(super) fn measure(
    group: &mut [Contestant],
    order: Order,
    seed: u64,
    bench: &mut Bench<'_>,
) -> Result<GroupReport, DoctorError> {
    let protocol = Protocol { rounds: bench.rounds, ..Protocol::new(order, seed) };
    Ok(bench.measure_as(group, &protocol)?)
}

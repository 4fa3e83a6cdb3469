//! What an experiment will do, and how long it will take, before it does it.

use super::calls::{CALL_CONTROLS, call_rounds};
use super::cells::{CONTROLS, MOST_SUBJECTS};
use super::codes::USUAL_EXITS;
use super::config::{ConfigError, Experiment};
use super::precompute::PrecomputeWorkload;
use super::select::select;
use super::workload::Workload;
use super::{bounds, pictures, search};
use crate::measure::{Order, Protocol};
use crate::registry::{self, Variant, units};

/// How much is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// 64 rounds: all experiments in some two minutes, where nobody else uses the machine.
    #[default]
    Quick,
    /// 256 rounds.
    Standard,
    /// 1024 rounds.
    Thorough,
}

impl Profile {
    /// Rounds of every group.
    pub fn rounds(self) -> usize {
        match self {
            Profile::Quick => 64,
            Profile::Standard => 256,
            Profile::Thorough => 1024,
        }
    }
}

/// An experiment with its variants chosen.
pub struct Plan {
    /// The experiment.
    pub experiment: Experiment,
    /// What runs, in the order of the experiment's patterns; those the filter lets through.
    pub variants: Vec<&'static Variant>,
    /// What ratios refer to.
    pub reference: &'static Variant,
}

impl Plan {
    /// Chooses the variants. `filter` is a regular expression over ids that was compiled before.
    ///
    /// # Errors
    /// For patterns that are none or match nothing, and a reference that does not exist.
    pub fn new(
        origin: &str,
        experiment: Experiment,
        filter: Option<&regex::Regex>,
    ) -> Result<Self, ConfigError> {
        let wrong = |message: String| ConfigError { origin: origin.to_owned(), message };
        let mut variants = select(&experiment.variants).map_err(wrong)?;
        variants.retain(|variant| filter.is_none_or(|filter| filter.is_match(&variant.id())));
        let reference = registry::find(&experiment.reference).ok_or_else(|| {
            wrong(format!(
                "reference: there is no variant '{}'; `ray_test list variants` shows them all",
                experiment.reference
            ))
        })?;
        for variant in variants.iter().chain([&reference]) {
            experiment.workload.suits(variant).map_err(wrong)?;
        }
        Ok(Plan { experiment, variants, reference })
    }

    /// Whether there is anything to do.
    pub fn is_empty(&self) -> bool {
        self.variants.is_empty() && self.experiment.workload.has_variants()
    }

    /// Cells: density, or spread of nearest-hit scenes (`None` without), and order of each scene.
    pub fn cells(&self) -> Vec<(Option<f64>, Order)> {
        let product = |densities: &[f64], orders: &[Order]| {
            let of = |order: &Order| {
                let order = *order;
                densities.iter().map(move |density| (Some(*density), order)).collect::<Vec<_>>()
            };
            orders.iter().flat_map(of).collect::<Vec<_>>()
        };
        match &self.experiment.workload {
            Workload::Pairs(pairs) => product(&pairs.density, &pairs.orders),
            Workload::Points(points) => product(&points.density, &points.orders),
            Workload::Nearest(nearest) => {
                let orders = nearest.orders.iter();
                orders
                    .flat_map(|order| nearest.spreads().into_iter().map(|spread| (spread, *order)))
                    .collect()
            }
            Workload::Codes(_)
            | Workload::Counts
            | Workload::Arithmetic
            | Workload::Errors(_)
            | Workload::Memory(_)
            | Workload::Structures(_)
            | Workload::Pictures(_) => Vec::new(),
            Workload::Precompute(_) => vec![(None, Order::Fixed)],
        }
    }

    /// Blocks that will be timed on this machine, redrawn rounds excluded.
    pub fn blocks(&self, profile: Profile) -> usize {
        self.blocks_as(profile, |order| order)
    }

    /// Seconds that they take: 60 us inside each timed window, as much again for permutations,
    /// warm-up passes and calibration. Reshuffled blocks are
    /// about as much shorter as they are more.
    pub fn seconds(&self, profile: Profile) -> f64 {
        let around = match &self.experiment.workload {
            Workload::Memory(sets) => sets.seconds_around(&self.ready(), profile.rounds()),
            Workload::Structures(sets) => search::seconds_around(sets),
            Workload::Pictures(sets) => pictures::seconds_around(sets, profile.rounds()),
            _ => 0.0,
        };
        self.blocks_as(profile, |_| Order::Fixed) as f64 * 120e-6 + around
    }

    /// The variants that run on this processor.
    pub(super) fn ready(&self) -> Vec<&'static Variant> {
        self.variants.iter().copied().filter(|variant| (variant.available)()).collect()
    }

    /// [`Plan::blocks`], of other orders.
    fn blocks_as(&self, profile: Profile, order_of: fn(Order) -> Order) -> usize {
        let blocks_of = |rounds: usize, contestants: usize, order: Order| {
            let protocol = Protocol { rounds, ..Protocol::new(order, 0) };
            protocol.planned_rounds(contestants) * contestants
        };
        let usual = profile.rounds();
        let rounds = |contestants: usize, order| blocks_of(usual, contestants, order);
        let ready = self.ready();
        let more = match &self.experiment.workload {
            Workload::Memory(sets) => return sets.blocks(&ready, profile.rounds()),
            Workload::Structures(sets) => return search::blocks(sets, profile.rounds()),
            Workload::Pictures(sets) => return pictures::blocks(sets, profile.rounds()),
            Workload::Codes(codes) => {
                let of_listing = rounds(USUAL_EXITS + CONTROLS, Order::Fixed);
                return ready.len() * codes.orders.len() * of_listing;
            }
            Workload::Arithmetic => return rounds(units().len() + CONTROLS, Order::Fixed),
            Workload::Precompute(_) => {
                rounds(PrecomputeWorkload::contestants(&ready), Order::Fixed)
            }
            _ => 0,
        };
        let singles = ready.iter().filter(|variant| variant.axes.drive == "single").count();
        let in_groups = |rounds: usize, subjects: usize, controls: usize, order: Order| {
            let rest = match subjects % MOST_SUBJECTS {
                0 => 0,
                rest => blocks_of(rounds, rest + controls, order),
            };
            subjects / MOST_SUBJECTS * blocks_of(rounds, MOST_SUBJECTS + controls, order) + rest
        };
        // Single rays are measured three times: in a loop, cold, and each after the other.
        let calls = 2 * in_groups(call_rounds(usual), singles, CALL_CONTROLS, Order::Fixed);
        let of_cell = |order| in_groups(usual, ready.len(), CONTROLS, order_of(order)) + calls;
        let of_streams = |streams: usize| rounds(streams + CONTROLS, Order::Fixed);
        let bounds = if self.experiment.bounds { bounds::group_sizes() } else { Vec::new() };
        let cells: usize = self.cells().into_iter().map(|(_, order)| of_cell(order)).sum();
        cells + bounds.into_iter().map(of_streams).sum::<usize>() + more
    }
}

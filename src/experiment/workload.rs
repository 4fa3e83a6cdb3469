//! The `[workload]` table of an experiment.

use serde::Deserialize;
use std::fmt::Debug;

use super::memory_workload::MemoryWorkload;
use super::nearest_workload::NearestWorkload;
use super::pictures::PicturesWorkload;
use super::precompute::PrecomputeWorkload;
use super::search::StructuresWorkload;
use super::stiff::StiffWorkload;
use crate::measure::Order;
use crate::registry::Variant;
use crate::workload::{Generator, QueryKind, Winding};

/// What variants are run on.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "lowercase", tag = "kind")]
pub enum Workload {
    /// Ray i against triangle i.
    Pairs(PairsWorkload),
    /// Every ray against every triangle.
    Nearest(NearestWorkload),
    /// Point i of triangle i's plane.
    Points(PointsWorkload),
    /// A million random pairs told apart by return code, and the time of each code (listings).
    Codes(CodesWorkload),
    /// Operations counted on the longest path; no clock.
    Counts,
    /// Multiplications and additions alone, at every level.
    Arithmetic,
    /// Sets of growing size, from caches to memory.
    Memory(MemoryWorkload),
    /// Stored forms against rays per triangle.
    Precompute(PrecomputeWorkload),
    /// Errors of random hits over several seeds; no clock.
    Errors(ErrorsWorkload),
    /// Rays through structures around triangles.
    Structures(StructuresWorkload),
    /// Pictures by ray tracing.
    Pictures(PicturesWorkload),
}

/// Pairs at an exact hit density.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairsWorkload {
    /// Pairs in `literal` and `fixed` order.
    #[serde(default = "fixed_pairs")]
    pub count: usize,
    /// Pairs in `reshuffled` order.
    #[serde(default = "reshuffled_pairs")]
    pub reshuffled_count: usize,
    /// Shares of pairs that hit.
    pub density: Vec<f64>,
    /// `line`, `ray` or `segment`.
    #[serde(default)]
    pub query: QueryKind,
    /// `natural` or `facing`.
    #[serde(default)]
    pub winding: Winding,
    /// `pcg` or `msvc`.
    #[serde(default)]
    pub generator: Generator,
    /// Orders in which the pairs are tested.
    pub orders: Vec<Order>,
    /// Tests that the column `seconds` is scaled to (thesis B: 25 000 x 20 000).
    pub seconds_of_tests: Option<f64>,
    /// Errors of the same variants on random hits, in rows of their own: pairs that can be timed in
    /// one go are too few for the rarer errors.
    pub errors: Option<ErrorsWorkload>,
    /// Their errors on stiff families, likewise.
    pub stiff: Option<StiffWorkload>,
}

/// Cut into windows, fifteen kernels in turn stay within what a branch predictor remembers.
fn fixed_pairs() -> usize {
    500
}

/// A block of 20 us.
fn reshuffled_pairs() -> usize {
    1000
}

/// Points of the planes of triangles.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointsWorkload {
    /// Points in `literal` and `fixed` order.
    #[serde(default = "fixed_pairs")]
    pub count: usize,
    /// Points in `reshuffled` order.
    #[serde(default = "reshuffled_pairs")]
    pub reshuffled_count: usize,
    /// Shares of points that are inside.
    pub density: Vec<f64>,
    /// Orders in which the points are tested.
    pub orders: Vec<Order>,
}

/// Random pairs by return code.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CodesWorkload {
    /// Pairs drawn.
    pub pairs: usize,
    /// Pairs timed of each code, at most.
    #[serde(default = "fixed_pairs")]
    pub timed_pairs: usize,
    /// `pcg` or `msvc`.
    #[serde(default)]
    pub generator: Generator,
    /// Orders in which the pairs of a code are tested.
    pub orders: Vec<Order>,
}

/// Random hits whose errors are measured.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ErrorsWorkload {
    /// Hits of each seed.
    pub hits: usize,
    /// Number of seeds, from the experiment's on.
    pub seeds: usize,
}

impl Workload {
    /// Whether it is variants that are run.
    pub fn has_variants(&self) -> bool {
        !matches!(
            self,
            Workload::Counts
                | Workload::Arithmetic
                | Workload::Structures(_)
                | Workload::Pictures(_)
        )
    }

    /// Whether a variant can be run on it.
    ///
    /// # Errors
    /// Where it cannot, and what is allowed.
    pub(super) fn suits(&self, variant: &Variant) -> Result<(), String> {
        match self {
            Workload::Nearest(nearest) => nearest.suits(variant),
            Workload::Precompute(forms) => forms.tests().suits(variant),
            Workload::Memory(_) => MemoryWorkload::suits(variant),
            _ => Ok(()),
        }
    }

    /// Refuses what can be seen to be wrong before anything runs.
    pub(super) fn validate(&self, seed: u64) -> Result<(), String> {
        if let Workload::Pairs(PairsWorkload { generator, .. })
        | Workload::Codes(CodesWorkload { generator, .. }) = self
        {
            generator.start(seed).map_err(|error| format!("seed: {error}"))?;
        }
        match self {
            Workload::Pairs(pairs) => pairs.validate(),
            Workload::Nearest(nearest) => nearest.validate(),
            Workload::Points(points) => points.validate(),
            Workload::Codes(codes) => codes.validate(),
            Workload::Errors(errors) => errors.validate(),
            Workload::Memory(memory) => memory.validate(),
            Workload::Precompute(forms) => forms.validate(),
            Workload::Structures(structures) => structures.validate(),
            Workload::Pictures(pictures) => pictures.validate(),
            Workload::Counts | Workload::Arithmetic => Ok(()),
        }
    }
}

/// Counts that every machine can hold and no run can take an hour for.
const MOST: usize = 1 << 24;

pub(super) fn in_range(key: &str, value: usize, least: usize) -> Result<(), String> {
    if (least..=MOST).contains(&value) {
        return Ok(());
    }
    Err(format!("workload.{key}: {value} is not allowed; allowed: {least} to {MOST}"))
}

/// Whether a list has something in it, and nothing twice: rows are kept under such names.
pub(super) fn some<T: PartialEq + Debug>(key: &str, list: &[T]) -> Result<(), String> {
    if list.is_empty() {
        return Err(format!("workload.{key}: at least one is needed"));
    }
    match list.iter().enumerate().find(|(place, one)| list[..*place].contains(one)) {
        Some((_, one)) => Err(format!("workload.{key}: {one:?} stands twice; allowed: each once")),
        None => Ok(()),
    }
}

fn shares(density: &[f64]) -> Result<(), String> {
    some("density", density)?;
    match density.iter().find(|d| !(0.0..=1.0).contains(*d)) {
        Some(d) => Err(format!("workload.density: {d} is not allowed; allowed: 0 to 1")),
        None => Ok(()),
    }
}

impl PairsWorkload {
    fn validate(&self) -> Result<(), String> {
        shares(&self.density)?;
        some("orders", &self.orders)?;
        if let Some(tests) = self.seconds_of_tests
            && !(tests.is_finite() && tests > 0.0)
        {
            return Err(format!(
                "workload.seconds_of_tests: {tests} is not allowed; allowed: above 0"
            ));
        }
        self.errors.as_ref().map_or(Ok(()), ErrorsWorkload::validate)?;
        self.stiff.as_ref().map_or(Ok(()), StiffWorkload::validate)?;
        in_range("count", self.count, 1)?;
        in_range("reshuffled_count", self.reshuffled_count, 1)
    }
}

impl PointsWorkload {
    fn validate(&self) -> Result<(), String> {
        shares(&self.density)?;
        some("orders", &self.orders)?;
        in_range("count", self.count, 1)?;
        in_range("reshuffled_count", self.reshuffled_count, 1)
    }
}

impl CodesWorkload {
    fn validate(&self) -> Result<(), String> {
        some("orders", &self.orders)?;
        if self.orders.contains(&Order::Reshuffled) {
            return Err("workload.orders: reshuffled is not allowed; allowed for codes: literal, \
                        fixed (one pass over the few pairs of a rare code is too short to time)"
                .to_owned());
        }
        in_range("timed_pairs", self.timed_pairs, 1)?;
        in_range("pairs", self.pairs, 1)
    }
}

impl ErrorsWorkload {
    fn validate(&self) -> Result<(), String> {
        in_range("hits", self.hits, 1)?;
        in_range("seeds", self.seeds, 1)
    }
}

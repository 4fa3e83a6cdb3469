//! The workload `nearest`: every ray against every triangle.

use serde::Deserialize;

use super::workload::some;
use crate::measure::Order;
use crate::registry::Variant;
use crate::workload::{self, NearestSpec};

/// Rays against all triangles.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NearestWorkload {
    /// Number of triangles, the same in both orders.
    #[serde(default = "triangles")]
    pub triangles: usize,
    /// Rays in `fixed` order; a multiple of 16.
    #[serde(default = "fixed_rays")]
    pub rays: usize,
    /// Rays in `reshuffled` order, of which each block takes others.
    #[serde(default = "reshuffled_rays")]
    pub reshuffled_rays: usize,
    /// `random`, `coherent`, `parallel`, `bunches` or `terrain`.
    #[serde(default)]
    pub coherence: workload::Kind,
    /// Of bunches: how far their rays lie apart, a set of rays for each.
    #[serde(default)]
    pub spread: Vec<f64>,
    /// Orders in which the rays are tested.
    pub orders: Vec<Order>,
}

/// Few: the tests of 16 rays are as many as pairs, for a predictor to remember. And a block has many
/// rays, which differ more than anything else: where a near hit comes early in the list, all that
/// follow are rejected by their distance.
fn triangles() -> usize {
    32
}

fn fixed_rays() -> usize {
    16
}

fn reshuffled_rays() -> usize {
    256
}

impl NearestWorkload {
    /// The spread of each set; one set without where none is stated.
    pub(super) fn spreads(&self) -> Vec<Option<f64>> {
        if self.spread.is_empty() {
            vec![None]
        } else {
            self.spread.iter().copied().map(Some).collect()
        }
    }

    /// What is drawn.
    pub(super) fn spec(&self, rays: usize, spread: Option<f64>, seed: u64) -> NearestSpec {
        let (triangles, kind) = (self.triangles, self.coherence);
        NearestSpec { triangles, rays, kind, spread: spread.unwrap_or(0.0) as f32, seed }
    }

    pub(super) fn validate(&self) -> Result<(), String> {
        some("orders", &self.orders)?;
        if self.orders.contains(&Order::Literal) {
            return Err("workload.orders: literal is not allowed; allowed for nearest: fixed, \
                        reshuffled (one ray's walk over all triangles is one item)"
                .to_owned());
        }
        for (key, rays) in [("rays", self.rays), ("reshuffled_rays", self.reshuffled_rays)] {
            for spread in self.spreads() {
                let spec = self.spec(rays, spread, 0);
                spec.validate().map_err(|error| format!("workload.{key}: {error}"))?;
            }
        }
        Ok(())
    }

    /// Whether a variant can be run on it.
    pub(super) fn suits(&self, variant: &Variant) -> Result<(), String> {
        let numbers = [("rays", self.rays), ("reshuffled_rays", self.reshuffled_rays)];
        let together = variant.rays;
        if let Some((key, rays)) =
            numbers.into_iter().find(|(_, rays)| !rays.is_multiple_of(together))
        {
            return Err(format!(
                "workload.{key}: {rays} is not allowed; allowed: multiples of {together}, the rays \
                 that {} takes together",
                variant.id()
            ));
        }
        let needed = match variant.axes.drive.split_once('-') {
            Some((_, "common-origin")) => workload::Kind::Coherent,
            Some((_, "parallel")) => workload::Kind::Parallel,
            _ if variant.axes.projection == "fixed" => workload::Kind::Terrain,
            _ => return Ok(()),
        };
        if self.coherence != needed {
            return Err(format!(
                "workload.coherence: {} is not allowed; allowed: {}, which {} relies on",
                self.coherence.word(),
                needed.word(),
                variant.id()
            ));
        }
        Ok(())
    }
}

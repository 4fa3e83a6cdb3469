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
    /// `random`, `coherent` or `parallel`.
    #[serde(default)]
    pub coherence: workload::Kind,
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
    pub(super) fn validate(&self) -> Result<(), String> {
        some("orders", &self.orders)?;
        if self.orders.contains(&Order::Literal) {
            return Err("workload.orders: literal is not allowed; allowed for nearest: fixed, \
                        reshuffled (one ray's walk over all triangles is one item)"
                .to_owned());
        }
        for (key, rays) in [("rays", self.rays), ("reshuffled_rays", self.reshuffled_rays)] {
            let triangles = self.triangles;
            let spec = NearestSpec { triangles, rays, kind: self.coherence, seed: 0 };
            spec.validate().map_err(|error| format!("workload.{key}: {error}"))?;
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
            _ => return Ok(()),
        };
        if self.coherence != needed {
            return Err(format!(
                "workload.coherence: {} is not allowed; allowed: {}, what the rays of {} have in \
                 common",
                self.coherence.word(),
                needed.word(),
                variant.id()
            ));
        }
        Ok(())
    }
}

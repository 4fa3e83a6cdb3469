//! Scenes of points.

use super::scene::{Facts, Scene};
use super::workload::PointsWorkload;
use crate::measure::Order;
use crate::workload::{PointSet, PointSpec, WorkloadError};

/// Points at a share inside, as many as the order takes.
///
/// # Errors
/// As [`PointSet::draw`].
pub fn scene(
    points: &PointsWorkload,
    density: f64,
    order: Order,
    seed: u64,
) -> Result<Scene, WorkloadError> {
    let reshuffled = order == Order::Reshuffled;
    let count = if reshuffled { points.reshuffled_count } else { points.count };
    let set = PointSet::draw(PointSpec { count, density, seed })?;
    let facts = Facts {
        workload: "pairs-point".into(),
        density: Some(set.density()),
        query: "point",
        winding: "natural",
        generator: "pcg",
        hash: set.hash,
        seed,
        ..Facts::default()
    };
    Ok(Scene::of_points(facts, set.rays, set.triangles))
}

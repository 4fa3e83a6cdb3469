//! Scenes of points.

use super::scene::Scene;
use super::workload::PointsWorkload;
use crate::measure::Order;
use crate::workload::WorkloadError;

/// Points at a share inside, as many as the order takes.
///
/// # Errors
/// As drawing.
pub fn scene(_points: &PointsWorkload, _density: f64, _order: Order, _seed: u64) -> Result<Scene, WorkloadError> {
    unimplemented!()
}

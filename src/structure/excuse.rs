//! Why a structure may answer other than the list does.

use super::best::{Hit, SLACK};
use crate::oracle::{Query, solve};
use crate::workload::{Ray, Triangle};

/// What is wrong with an answer of the list that a structure need not find.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Excuse {
    /// The kernel hits a triangle that the ray exactly misses.
    FalseHit,
    /// The kernel tells a distance that is short by more than [`SLACK`] of the exact one.
    TooNear,
}

/// The excuse for not finding `hit`, by the exact answer; `None` where there is none: every structure
/// finds it. `is_segment` as of the kernel's leaf.
pub fn excuse(ray: &Ray, triangles: &[Triangle], hit: &Hit, is_segment: bool) -> Option<Excuse> {
    let triangle = &triangles[hit.triangle as usize];
    let query = if is_segment {
        Query::of_segment(ray, triangle)
    } else {
        let query = Query::of(ray, triangle);
        Query { t_min: query.t_min.max(0.0), ..query }
    };
    let exact = solve(&query);
    if !exact.class.is_hit() {
        Some(Excuse::FalseHit)
    } else if f64::from(hit.t) * (1.0 + SLACK) < exact.t {
        Some(Excuse::TooNear)
    } else {
        None
    }
}

//! Some rays, followed to the triangle that they meet, and looked at exactly.

use crate::number::Precision;
use crate::oracle::{Class, Query, excusable, solve};
use crate::scene::mesh::Mesh;
use crate::workload::Ray;
use serde::Serialize;

/// So many rays are followed, spread evenly over all.
pub const MOST_SAMPLES: usize = 10_000;

/// Of some rays.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Samples {
    /// Rays that were followed.
    pub rays: u64,
    /// Rays that met a triangle.
    pub hits: u64,
    /// Share of those that meet an edge or vertex of it exactly, 0 to 1.
    pub edge_share: f64,
    /// Share of those for which f32 could deny the hit: some weight, or the end of the range, is
    /// within 16 condition numbers times the unit roundoff of its bound. The exact edges are among
    /// them.
    pub near_edge_share: f64,
    /// Share of hits that see the back of their triangle, 0 to 1.
    pub back_share: f64,
    /// Smallest magnitude of the cosine between ray and normal; `None` without hits.
    pub smallest_cosine: Option<f64>,
    /// Largest distance of a hit, in lengths of the ray's direction.
    pub largest_t: Option<f64>,
}

impl Samples {
    /// `nearest` gives the index of the first triangle that a ray meets.
    pub(super) fn of(
        mesh: &Mesh,
        rays: &[Ray],
        mut nearest: impl FnMut(&Ray) -> Option<u32>,
    ) -> Self {
        let mut samples = Samples::default();
        let (mut edges, mut near, mut backs) = (0u64, 0u64, 0u64);
        let unit_roundoff = Precision::F32.unit_roundoff();
        let count = rays.len().min(MOST_SAMPLES);
        for sample in 0..count {
            let ray = &rays[sample * rays.len() / count];
            samples.rays += 1;
            let Some(index) = nearest(ray) else { continue };
            let triangle = mesh.triangle(index as usize);
            let query = Query::of(ray, &triangle);
            let exact = solve(&query);
            samples.hits += 1;
            edges += u64::from(matches!(exact.class, Class::Edge | Class::Vertex));
            // A hit that the exact answer denies is excused by nothing but rounding.
            let is_near = !exact.class.is_hit() || excusable(&query, &exact, unit_roundoff, false);
            near += u64::from(is_near);
            let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|p| p.as_dvec3());
            let (normal, direction) = ((b - a).cross(c - a), ray.direction.as_dvec3());
            let cosine = normal.dot(direction) / (normal.length() * direction.length());
            backs += u64::from(cosine > 0.0);
            if cosine.is_finite() {
                samples.smallest_cosine =
                    Some(samples.smallest_cosine.map_or(1.0, |x: f64| x).min(cosine.abs()));
            }
            if exact.t.is_finite() {
                samples.largest_t = Some(samples.largest_t.map_or(exact.t, |t| t.max(exact.t)));
            }
        }
        let share = |count: u64| count as f64 / (samples.hits as f64).max(1.0);
        samples.edge_share = share(edges);
        samples.near_edge_share = share(near);
        samples.back_share = share(backs);
        samples
    }
}

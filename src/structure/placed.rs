//! Triangles with the boxes around them.

use super::volume::Bounds;
use crate::workload::Triangle;

/// A triangle as a builder sees it.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// Its index.
    pub triangle: u32,
    /// Around it.
    pub bounds: Bounds,
}

/// All triangles whose corners are finite, in order.
pub fn placed(triangles: &[Triangle]) -> Vec<Placed> {
    let place = |(triangle, one)| Some(Placed { triangle, bounds: Bounds::of(one)? });
    (0u32..).zip(triangles).filter_map(place).collect()
}

/// Around all of them.
pub fn around(placed: &[Placed]) -> Bounds {
    placed.iter().fold(Bounds::NOTHING, |bounds, one| bounds.joined(&one.bounds))
}

/// The corners of those triangles.
pub fn points(triangles: &[Triangle], indices: &[u32]) -> Vec<[f32; 3]> {
    let corners = |index: &u32| {
        let one = &triangles[*index as usize];
        [one.a, one.b, one.c].map(|corner| corner.to_array())
    };
    indices.iter().flat_map(corners).collect()
}

//! One volume around a list: what the lecture's B + p I < I is about.

use super::placed::{placed, points};
use super::volume::Volume;
use super::{Beam, Search, Structure};
use crate::workload::Triangle;

/// A volume and the list of all triangles in it.
#[derive(Clone, Debug)]
pub struct Bounded<V> {
    volume: Option<V>,
    indices: Vec<u32>,
}

impl<V: Volume> Bounded<V> {
    /// Around all triangles.
    pub fn new(triangles: &[Triangle]) -> Self {
        let indices: Vec<u32> = placed(triangles).iter().map(|one| one.triangle).collect();
        let points = points(triangles, &indices);
        let volume = (!points.is_empty()).then(|| V::around(&points));
        Bounded { volume, indices }
    }

    /// The volume; nothing is around nothing.
    pub fn volume(&self) -> Option<&V> {
        self.volume.as_ref()
    }
}

impl<V: Volume> Structure for Bounded<V> {
    fn walk(&self, beam: &Beam, search: &mut Search) {
        if let Some(volume) = &self.volume
            && search.enter(volume, beam, &V::aim(beam)).is_some()
        {
            search.test(&self.indices);
        }
    }

    fn bytes(&self) -> usize {
        size_of::<V>() + size_of_val(self.indices.as_slice())
    }
}

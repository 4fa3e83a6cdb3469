//! The published listings as leaves of structures: as printed, with t, u and v, in f32. They answer for
//! lines; whoever searches along a ray looks at t.

use crate::kernels::Corners;
use crate::kernels::listings::{Listing, Literally};
use crate::number::Vec3;
use crate::policy::Ray;
use crate::structure::{Best, Hit, Leaf};
use crate::workload::{self, Triangle};

use super::asked::listing_axes;
use super::{LeafForm, ListingVisitor, corners, visit_listings};
use crate::batch::widened;

/// All of them, in the order of the registry.
pub fn listing_leaves() -> Vec<LeafForm> {
    let mut all = Vec::new();
    visit_listings(&mut Leaves(&mut all));
    all
}

struct Leaves<'a>(&'a mut Vec<LeafForm>);

impl ListingVisitor for Leaves<'_> {
    fn listing<K: Listing>(&mut self, division: &'static str) {
        fn prepare<K: Listing>(triangles: &[Triangle]) -> Box<dyn Leaf> {
            Box::new(ListingLeaf::<K>::new(triangles))
        }
        let axes = listing_axes::<K>("f32", division);
        let (about, prepare) = (&K::ABOUT, prepare::<K>);
        self.0.push(LeafForm { axes, about, is_segment: false, prepare });
    }
}

struct ListingLeaf<K: Listing> {
    records: Vec<K::Record<f32>>,
    ray: Ray<f32>,
}

impl<K: Listing> ListingLeaf<K> {
    fn new(triangles: &[Triangle]) -> Self {
        let prepare = |one: &Triangle| {
            let corners: Corners<f32> = corners(one);
            K::prepare(&corners)
        };
        let (zero, along) = (Vec3([0.0; 3]), Vec3([0.0, 0.0, 1.0]));
        let ray = Ray { origin: zero, direction: along, end: along, t_min: 0.0, t_max: 0.0 };
        ListingLeaf { records: triangles.iter().map(prepare).collect(), ray }
    }
}

impl<K: Listing> Leaf for ListingLeaf<K> {
    fn is_segment(&self) -> bool {
        false
    }

    fn triangles(&self) -> usize {
        self.records.len()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.records.as_slice())
    }

    fn aim(&mut self, ray: &workload::Ray) {
        self.ray = widened(ray);
        self.ray.t_min = self.ray.t_min.max(0.0);
    }

    fn test(&mut self, indices: &[u32], best: &mut Best) {
        for &triangle in indices {
            let (code, t, u, v) =
                K::run::<f32, Literally, true>(&self.ray, &self.records[triangle as usize]);
            if code == 0 && self.ray.t_min <= t && t <= best.limit() {
                best.offer(Hit { triangle, t, u, v });
            }
        }
    }
}

//! What stands at the leaves of every structure: triangles, prepared for one kernel.

use super::best::{Best, Hit};
use crate::batch::widened;
use crate::kernels::listings::{Listing, Literally};
use crate::kernels::{Corners, Kernel};
use crate::number::Vec3;
use crate::policy::{Policy, Ray};
use crate::workload;

/// Triangles of one kernel behind one pointer, and the ray that they are tested against. One call tests
/// a leaf or more, so a structure is compiled once and not once per kernel.
pub trait Leaf {
    /// It answers about the segment from origin to end, t from 0 to 1, not about the ray.
    fn is_segment(&self) -> bool;
    /// Number of triangles.
    fn triangles(&self) -> usize;
    /// Bytes of what is stored of them.
    fn bytes(&self) -> usize;
    /// Takes a new ray. A `t_min` below 0 counts as 0.
    fn aim(&mut self, ray: &workload::Ray);
    /// Tests the ray against triangles and offers every hit.
    fn test(&mut self, indices: &[u32], best: &mut Best);
}

/// The leaf of kernel `K` in its form `P`, whose span has to be [`crate::policy::Between`], in f32.
pub struct KernelLeaf<K: Kernel, P> {
    records: Vec<K::Record<f32>>,
    ray: Ray<f32>,
    aim: K::Aim<f32>,
    is_segment: bool,
    form: std::marker::PhantomData<P>,
}

/// A triangle, as kernels take it.
pub fn corners(triangle: &workload::Triangle) -> Corners<f32> {
    let vector = |v: glam::Vec3| Vec3(v.to_array());
    Corners { a: vector(triangle.a), b: vector(triangle.b), c: vector(triangle.c) }
}

/// What a leaf aims at before it is told.
const SOME_RAY: Ray<f32> = Ray {
    origin: Vec3([0.0; 3]),
    direction: Vec3([0.0, 0.0, 1.0]),
    end: Vec3([0.0, 0.0, 1.0]),
    t_min: 0.0,
    t_max: 1.0,
};

/// A ray, as kernels take it; from 0 on.
pub fn aimed(drawn: &workload::Ray) -> Ray<f32> {
    let ray: Ray<f32> = widened(drawn);
    Ray { t_min: ray.t_min.max(0.0), ..ray }
}

impl<K: Kernel, P: Policy> KernelLeaf<K, P> {
    /// Prepares every triangle.
    pub fn new(triangles: &[workload::Triangle], is_segment: bool) -> Self {
        KernelLeaf {
            records: triangles.iter().map(|one| K::prepare(&corners(one))).collect(),
            aim: K::aim::<P, f32>(&SOME_RAY),
            ray: SOME_RAY,
            is_segment,
            form: std::marker::PhantomData,
        }
    }
}

impl<K: Kernel, P: Policy> Leaf for KernelLeaf<K, P> {
    fn is_segment(&self) -> bool {
        self.is_segment
    }

    fn triangles(&self) -> usize {
        self.records.len()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.records.as_slice())
    }

    fn aim(&mut self, ray: &workload::Ray) {
        self.ray = aimed(ray);
        if self.is_segment {
            self.ray.direction = self.ray.end - self.ray.origin;
            (self.ray.t_min, self.ray.t_max) = (0.0, 1.0);
        }
        self.aim = K::aim::<P, f32>(&self.ray);
    }

    fn test(&mut self, indices: &[u32], best: &mut Best) {
        for &triangle in indices {
            self.ray.t_max = best.limit();
            let met = K::meet::<P, f32>((), &self.records[triangle as usize]);
            if let Ok(found) = K::test::<P, f32>(&self.ray, &self.aim, &met)
                && found.hit
            {
                best.offer(Hit { triangle, t: found.t, u: found.u, v: found.v });
            }
        }
    }
}

/// The leaf of a published listing, as printed, in f32. Most listings leave the range of t to whoever calls
/// them: a hit is what returns 0 and lies within it.
pub struct ListingLeaf<K: Listing> {
    records: Vec<K::Record<f32>>,
    ray: Ray<f32>,
}

impl<K: Listing> ListingLeaf<K> {
    /// Prepares every triangle.
    pub fn new(triangles: &[workload::Triangle]) -> Self {
        let records = triangles.iter().map(|one| K::prepare(&corners(one))).collect();
        ListingLeaf { records, ray: SOME_RAY }
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
        self.ray = aimed(ray);
    }

    fn test(&mut self, indices: &[u32], best: &mut Best) {
        for &triangle in indices {
            let record = &self.records[triangle as usize];
            let (code, t, u, v) = K::run::<f32, Literally, true>(&self.ray, record);
            if code == 0 && self.ray.t_min <= t && t <= best.limit() {
                best.offer(Hit { triangle, t, u, v });
            }
        }
    }
}

//! What people would otherwise use: the ray-triangle tests of other crates, one file a crate, and the
//! listing that those without a crate copy.
//!
//! A peer is called as its users call it, in the types of its own that it is fastest with. They are
//! filled when pairs are prepared, so nothing is converted in the timed loop, and code of the peer is
//! compiled at the baseline level, as it is for anyone who sets no target processor. All of them are
//! held to `t_max`, as a search needs it and our own kernels do; `t_min` is whatever the peer has.

mod bvh;
mod glam;
mod obvhs;
mod parry;
mod rayx;
pub mod trees;

pub use bvh::Bvh;
pub use glam::Glam;
pub use obvhs::{Obvhs, ObvhsCompressed, ObvhsPrepared};
pub use parry::Parry;
pub use rayx::Rayx;

use crate::kernels::About;
use crate::workload;

/// A ray-triangle test of another crate, in f32.
pub trait Peer: 'static {
    /// What it is, and where its conventions differ from ours; the year is that of its method.
    const ABOUT: About;
    /// The axis `cull`: `on` where it sees front faces only.
    const CULL: &'static str = "off";
    /// The axis `division`: `first` where it divides before its tests.
    const DIVISION: &'static str;
    /// The axis `leading`: the test that comes first, `distance` or `inside`.
    const LEADING: &'static str;
    /// The axis `tests`.
    const TESTS: &'static str = "compare";
    /// Whether `stored` is the first or only form of this peer.
    const STORED_IS_NATIVE: bool = true;
    /// Its ray, with the bounds of t that it takes.
    type Ray: Copy + 'static;
    /// Its triangle.
    type Triangle: Copy + 'static;

    /// Its ray from a drawn one.
    fn ray(ray: &workload::Ray) -> Self::Ray;
    /// Its triangle from a drawn one; any triangle, degenerate ones too.
    fn triangle(triangle: &workload::Triangle) -> Self::Triangle;
    /// t, u and v of a hit, in units and weights of ours; u and v mean nothing unless `UV`.
    fn test<const UV: bool>(ray: &Self::Ray, triangle: &Self::Triangle) -> Option<[f32; 3]>;
}

/// The largest t that counts; a finite number, so that the infinite t of a miss is beyond it.
fn finite_t_max(ray: &workload::Ray) -> f32 {
    ray.t_max.min(f32::MAX)
}

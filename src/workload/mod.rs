//! Seeded workloads: the same numbers on every machine and in every version.
//!
//! Only `+ - * /` and square roots are used, in f32 where the result is kept, on integers from one
//! named generator; so nothing depends on a platform's mathematics, on the order of a hash map, or
//! on how some library draws from a range. A hash over every number drawn goes into each result.

mod camera;
mod error;
pub mod hash;
mod nearest;
mod pairs;
mod points;
mod random;
mod ray;
mod settled;
mod thesis;
mod triangle;

pub use error::WorkloadError;
pub use nearest::{Kind, NearestSet, NearestSpec, random_pair};
pub use pairs::{PairSpec, Pairs, QueryKind, Winding};
pub use points::{PointSet, PointSpec};
pub use random::{Generator, Msvc, Pcg, Source, Unit};
pub use ray::Ray;
pub use thesis::draw_pairs;
pub use triangle::Triangle;

// What meshes and their rays are made with, too.
#[cfg(feature = "cli")]
pub(crate) use {
    nearest::{on_sphere, ray},
    settled::aspect,
    thesis::normalised,
};

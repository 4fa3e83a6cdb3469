//! The loops around a test: pairs, nearest hits, points.
//!
//! A loop is generic over everything and compiled once per form; the data that it reads are
//! generic over kernel and element only.

mod aligned;
mod arithmetic;
mod batches;
mod best;
mod bundle;
mod data;
mod foreign;
mod group;
mod in_registers;
mod kind;
mod layout;
mod listed;
mod nearest;
mod nearest_data;
mod nearest_job;
mod packed;
mod pairs;
mod points;
mod prepare_job;
mod sharing;
mod stream;
mod tiles_job;

pub use aligned::Aligned;
pub use arithmetic::{ArithmeticJob, OPERATIONS};
pub use batches::Batches;
pub use best::Best;
pub use bundle::Bundle;
pub use data::{LoopOver, PairsJob, PairsLoop, widened};
pub use foreign::{Foreign, ForeignPairs};
pub use group::{Group, Packed, everywhere};
pub use in_registers::{InRegisters, PairsInRegisters};
pub use kind::{Kind, PLACES, mix};
pub use layout::{Aos, Aosoa, Layout, Soa};
pub use listed::Listed;
pub use nearest::{Nearest, RAY_NUMBERS, WIDEST, align_frame, load, places, step};
pub use nearest_job::{NearestJob, NearestLoop, Shape, Storing};
pub use packed::ray_numbers;
pub use pairs::{Pairs, Walk};
pub use points::Points;
pub use prepare_job::{PrepareJob, prepare_all};
pub use sharing::{Sharing, step_shared};
pub use stream::Stream;
pub use tiles_job::{Extent, TILE, TilesJob};

use crate::number::{Element, Real, Vec3};
use crate::policy::{Exit, Found, Output, Policy, Ray};

/// Sums of the outputs of hits, in the bit patterns of [`crate::job::Tally`].
#[derive(Clone, Copy, Default)]
struct Sums {
    hits: u64,
    bits: [u64; 9],
}

impl Sums {
    /// Adds a hit (`keep` has all bits set), or nothing (none).
    #[inline(always)]
    fn add<E: Element>(&mut self, keep: u64, outputs: &[E]) {
        self.hits = self.hits.wrapping_sub(keep);
        for (sum, output) in self.bits.iter_mut().zip(outputs) {
            *sum = sum.wrapping_add(output.bits() & keep);
        }
    }
}

/// Adds what the form `P` reports of one scalar test.
#[inline(always)]
fn report<P: Policy, E: Element>(sums: &mut Sums, ray: &Ray<E>, found: &Found<E>, normal: Vec3<E>) {
    let Found { hit, t, u, v } = *found;
    let keep = P::Exit::spread(hit);
    if P::Output::SURFACE {
        let [x, y, z] = surface_point(ray.origin, ray.direction, t).0;
        let [nx, ny, nz] = normal.0;
        sums.add(keep, &[t, u, v, x, y, z, nx, ny, nz]);
    } else if P::Output::UV {
        sums.add(keep, &[t, u, v]);
    } else if P::Output::T {
        sums.add(keep, &[t]);
    } else {
        sums.add::<E>(keep, &[]);
    }
}

/// o + t d
#[inline(always)]
fn surface_point<R: Real>(origin: Vec3<R>, direction: Vec3<R>, t: R) -> Vec3<R> {
    origin + direction.scaled(t)
}

//! The workload `memory`: its sizes, how its sets are grouped, and how long they take.

use serde::Deserialize;

use super::cells::MOST_SUBJECTS;
use crate::batch::TILE;
use crate::measure::{Cache, Machine, Order, Pace, Protocol};
use crate::registry::{Axes, Variant};

/// Sets of growing size.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MemoryWorkload {
    /// Triangles of each set, multiples of 256.
    pub triangles: Vec<usize>,
}

/// Rays of a tile: those of the widest packet.
pub(super) const RAYS: usize = 16;

/// Most triangles of a set: 16 million, 900 MB of the largest record.
const MOST: usize = 1 << 24;

/// Most bytes of sets that are measured together: where every block is preceded by a reading of its set,
/// a round would else be so long that none is undisturbed. As much of groups that take turns, which
/// are all in memory.
pub(super) const MOST_BYTES: usize = 192 << 20;

/// What an estimate takes for granted: so many bytes of a set are read in a second on the way to a
/// block, and written, checked and read for calibration in another.
const BYTES_READ_PER_SECOND: f64 = 8e9;
const BYTES_BUILT_PER_SECOND: f64 = 0.6e9;

/// Empty loop and chain.
pub(super) const CONTROLS: usize = 2;

impl MemoryWorkload {
    pub(super) fn validate(&self) -> Result<(), String> {
        if self.triangles.is_empty() {
            return Err("workload.triangles: at least one number is needed".to_owned());
        }
        let wrong = |count: &&usize| !(TILE..=MOST).contains(*count) || !count.is_multiple_of(TILE);
        match self.triangles.iter().find(wrong) {
            Some(count) => Err(format!(
                "workload.triangles: {count} is not allowed; allowed: multiples of {TILE} from {TILE} to {MOST}"
            )),
            None => Ok(()),
        }
    }

    /// Whether a variant can be run on it.
    pub(super) fn suits(variant: &Variant) -> Result<(), String> {
        if !RAYS.is_multiple_of(variant.rays) || variant.axes.drive.contains('-') {
            return Err(format!(
                "variants: {} is not allowed; allowed for memory: forms that take 1, 2, 4, 8 or 16 \
                 rays with nothing in common",
                variant.id()
            ));
        }
        Ok(())
    }

    /// Blocks that are timed of variants that run here.
    pub(super) fn blocks(&self, variants: &[&'static Variant], rounds: usize) -> usize {
        let of_group = |group: Vec<&'static Variant>| {
            let contestants = group.len() + CONTROLS;
            protocol(rounds, 0).planned_rounds(contestants) * contestants
        };
        let variants = widest(variants);
        let of_set = |triangles| groups(&variants, triangles).into_iter().map(of_group);
        self.triangles.iter().copied().flat_map(of_set).sum()
    }

    /// Seconds for building sets and for reading them on the way to their blocks.
    pub(super) fn seconds_around(&self, variants: &[&'static Variant], rounds: usize) -> f64 {
        let (cache, variants) = (last_cache_bytes(&Machine::this().caches), widest(variants));
        let reads = protocol(rounds, 0).planned_rounds(MOST_SUBJECTS + CONTROLS) as f64;
        let of_set = |bytes: usize| {
            let walks = if bytes > cache { 0.0 } else { reads / BYTES_READ_PER_SECOND };
            bytes as f64 * (walks + 1.0 / BYTES_BUILT_PER_SECOND)
        };
        let sets = self.triangles.iter();
        let bytes = |count: &usize| {
            let count = *count;
            variants.iter().map(move |one| one.bytes_per_triangle * count)
        };
        let sets = sets.flat_map(bytes);
        sets.map(of_set).sum()
    }
}

/// A quarter of the usual rounds, since most of their time is the way to the next block; memory is
/// slow by tens of per cent or not at all. (With all of them, the walk over a small set comes often
/// enough for a branch predictor to learn it by and by.)
pub(super) fn protocol(rounds: usize, seed: u64) -> Protocol {
    Protocol {
        rounds: (rounds / 4).max(Protocol::LEAST_ROUNDS),
        // As many as that: others would be read for nothing.
        exact_rounds: true,
        pace: Pace::Walk,
        ..Protocol::new(Order::Fixed, seed)
    }
}

/// Of forms that differ by the width of their packets alone, the widest.
pub(super) fn widest(variants: &[&'static Variant]) -> Vec<&'static Variant> {
    let is_wider = |other: &Variant, variant: &Variant| {
        let (own, axes) = (&variant.axes, &other.axes);
        let same = Axes { drive: own.drive.clone(), level: own.level, ..axes.clone() } == *own;
        same && variant.rays > 1 && other.rays > variant.rays
    };
    let is_widest =
        |variant: &&&'static Variant| !variants.iter().any(|other| is_wider(other, variant));
    variants.iter().filter(is_widest).copied().collect()
}

/// Bytes of the sets of a group.
pub(super) fn bytes_of(group: &[&'static Variant], triangles: usize) -> usize {
    group.iter().map(|variant| variant.bytes_per_triangle * triangles).sum()
}

/// Groups whose sets may be in memory together.
pub(super) fn groups(
    variants: &[&'static Variant],
    triangles: usize,
) -> Vec<Vec<&'static Variant>> {
    let mut groups: Vec<Vec<&'static Variant>> = Vec::new();
    let mut bytes = 0;
    for variant in variants {
        let own = variant.bytes_per_triangle * triangles;
        match groups.last_mut() {
            Some(group) if group.len() < MOST_SUBJECTS && bytes + own <= MOST_BYTES => {
                group.push(variant);
                bytes += own;
            }
            _ => {
                groups.push(vec![variant]);
                bytes = own;
            }
        }
    }
    groups
}

/// Bytes of the largest cache that holds data; without one, sets of any size may fit it.
pub(super) fn last_cache_bytes(caches: &[Cache]) -> usize {
    let sizes = caches.iter().filter(|cache| cache.kind != "Instruction");
    sizes.map(|cache| cache.size_bytes as usize).max().unwrap_or(usize::MAX)
}

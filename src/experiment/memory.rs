//! Sets from a few hundred triangles to more than any cache holds: what it costs to fetch them.
//!
//! A set is a tile of triangles again and again ([`crate::batch::TilesJob`]). Its answers are checked
//! against the exact ones of the tile, and every tile against the first, before anything is timed. A
//! block is the next stretch of a walk through the set ([`crate::measure::Pace::Walk`]).

use std::sync::atomic::Ordering;

use super::bench::Bench;
use super::cells::Measured;
use super::limits::least_cycles;
use super::memory_workload::{
    CONTROLS, MOST_BYTES, MemoryWorkload, RAYS, bytes_of, groups, last_cache_bytes, protocol,
    widest,
};
use super::nearest_workload::NearestWorkload;
use super::plan::Plan;
use super::rows::{blank, tally_hash};
use super::run::Trouble;
use super::scene::Scene;
use super::together::{Waiting, measure_waiting};
use crate::batch::{Extent, TILE};
use crate::job::{Block, Job, Tally};
use crate::measure::{Cache, Contestant, Machine, Order, Role, yardsticks};
use crate::registry::Variant;
use crate::rows::put_accuracy;
use crate::table::Row;
use crate::workload::{self, WorkloadError, hash::Fnv};

/// A row per set and variant.
///
/// # Errors
/// As drawing, measuring and keeping.
pub fn run(
    plan: &Plan,
    workload: &MemoryWorkload,
    bench: &mut Bench<'_>,
) -> Result<Measured, Trouble> {
    let mut measured = Measured { rows: Vec::new(), figures: Vec::new(), wrong: Vec::new() };
    let caches = Machine::this().caches;
    let (here, elsewhere): (Vec<_>, Vec<_>) =
        plan.variants.iter().copied().partition(|variant| (variant.available)());
    let here = widest(&here);
    let tile = tile(plan.experiment.seed)?;
    let (mut waiting, mut held_bytes) = (Vec::new(), 0);
    for triangles in &workload.triangles {
        let set = Set { plan, tile: &tile, triangles: *triangles, caches: &caches };
        for variant in &elsewhere {
            let mut row = set.row(variant);
            row.status = "skipped".into();
            row.reason = format!("no {}", variant.axes.level);
            measured.rows.push(row);
        }
        for (number, group) in groups(&here, *triangles).into_iter().enumerate() {
            if bench.cancel.load(Ordering::Relaxed) {
                break;
            }
            let bytes = bytes_of(&group, *triangles);
            if held_bytes + bytes > MOST_BYTES {
                measure_waiting(std::mem::take(&mut waiting), bench, &mut measured.rows)?;
                held_bytes = 0;
            }
            let piece = format!("{triangles} triangles, group {number}");
            if let Some(group) = set.prepare(&group, piece, bench, &mut measured)? {
                waiting.push(group);
                held_bytes += bytes;
            }
        }
    }
    measure_waiting(waiting, bench, &mut measured.rows)?;
    Ok(measured)
}

/// The triangles of a tile and the rays that walk over it, with their exact answers.
fn tile(seed: u64) -> Result<Scene, WorkloadError> {
    let tile = NearestWorkload {
        triangles: TILE,
        rays: RAYS,
        reshuffled_rays: RAYS,
        coherence: workload::Kind::Random,
        spread: Vec::new(),
        orders: vec![Order::Fixed],
    };
    Scene::nearest(&tile, None, Order::Fixed, seed)
}

/// A large set.
struct Set<'a> {
    plan: &'a Plan,
    tile: &'a Scene,
    triangles: usize,
    caches: &'a [Cache],
}

impl Set<'_> {
    fn extent(&self) -> Extent {
        let cache_bytes = last_cache_bytes(self.caches);
        Extent { tiles: self.triangles / TILE, cache_bytes }
    }

    /// The row of a variant before anything is known of its answers.
    fn row(&self, variant: &'static Variant) -> Row {
        let cache = |level| {
            let of = |cache: &&Cache| cache.level == level && cache.kind != "Instruction";
            self.caches.iter().find(of).map(|cache| cache.size_bytes)
        };
        let mut hash = Fnv::default();
        hash.bytes(&self.tile.facts.hash.to_le_bytes());
        hash.count(self.triangles);
        Row {
            workload: "nearest-memory".into(),
            triangles: Some(self.triangles as u64),
            tests: None,
            workload_hash: format!("{:016x}", hash.finish()),
            set_bytes: Some((variant.bytes_per_triangle * self.triangles) as u64),
            l1_bytes: cache(1),
            l2_bytes: cache(2),
            l3_bytes: cache(3),
            ..blank(&self.plan.experiment.id, variant, self.tile, Order::Fixed)
        }
    }

    /// Builds the sets of a group and checks them; nothing, where the rows were kept or none is to be
    /// timed.
    fn prepare(
        &self,
        group: &[&'static Variant],
        piece: String,
        bench: &mut Bench<'_>,
        measured: &mut Measured,
    ) -> Result<Option<Waiting>, Trouble> {
        let first = measured.rows.len();
        let (mut places, mut contestants) = (Vec::new(), Vec::new());
        for variant in group {
            let mut row = self.row(variant);
            if let Some(contestant) = self.checked(variant, &mut row, &mut measured.wrong) {
                places.push(measured.rows.len());
                contestants.push(contestant);
            }
            measured.rows.push(row);
        }
        let all: Vec<usize> = (first..measured.rows.len()).collect();
        let protocol = protocol(bench.rounds, self.plan.experiment.seed);
        if bench.take_back(&piece, &all, &mut measured.rows)? {
            bench.pass_over_as(&protocol, places.len() + CONTROLS);
            return Ok(None);
        }
        let Some(one) = contestants.first() else {
            bench.keep_piece(&piece, &all, &measured.rows)?;
            return Ok(None);
        };
        let yardsticks = yardsticks(one.job.as_ref());
        contestants.extend(yardsticks);
        Ok(Some(Waiting { places, contestants, protocol, piece, all }))
    }

    /// Binds and judges a variant, which is not to be timed where it is wrong or has no such loop.
    fn checked(
        &self,
        variant: &'static Variant,
        row: &mut Row,
        wrong: &mut Vec<String>,
    ) -> Option<Contestant> {
        let Some(bind) = &variant.tiles else {
            row.status = "skipped".into();
            row.reason = format!("it does not run on {}", row.workload);
            return None;
        };
        let mut job = bind(&self.tile.rays, &self.tile.triangles, self.extent());
        let judgement = self.tile.judge(variant, job.as_mut());
        put_accuracy(row, &judgement.accuracy);
        row.tests = Some(job.items() as u64 * job.tests_per_item());
        let inexact = !variant.claims_exactness();
        row.status = if inexact { "inexact" } else { "ok" }.into();
        let all = walked(job.as_mut(), RAYS / variant.rays);
        let reason = judgement.wrong.filter(|_| !inexact).or(all.as_ref().err().cloned());
        let (Ok(all), None) = (&all, &reason) else {
            row.status = "wrong-result".into();
            row.reason = reason.unwrap_or_default();
            wrong.push(variant.id());
            return None;
        };
        row.hits = Some(all.hits);
        row.outputs_hash = tally_hash(all);
        let is_reference = std::ptr::eq(variant, self.plan.reference);
        let role = if is_reference { Role::Reference } else { Role::Subject };
        let contestant = Contestant::new(variant.id(), role, job).with_hits(all.hits);
        Some(contestant.with_limits(variant.lanes, least_cycles(variant)))
    }
}

/// What all items together find, if each finds what the first one with its rays does; there are so many
/// `turns` of rays.
fn walked(job: &mut dyn Job, turns: usize) -> Result<Tally, String> {
    let mut all = Tally::default();
    let mut first: Vec<Tally> = Vec::with_capacity(turns);
    for item in 0..job.items() {
        let found = job.run(Block { first: item, items: 1, repeats: 1, literal: false });
        match first.get(item % turns) {
            Some(wanted) if *wanted != found => {
                return Err(format!(
                    "item {item}: something else than the same rays find elsewhere"
                ));
            }
            Some(_) => {}
            None => first.push(found),
        }
        all = all.plus(found);
    }
    Ok(all)
}

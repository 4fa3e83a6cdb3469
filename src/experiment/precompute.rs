//! What a form prepares of a triangle, what that costs, and from how many rays on it pays.
//!
//! The tests are timed as in any cell of nearest hits; the preparing beside each other in a group of
//! its own ([`crate::batch::PrepareJob`]), once for all forms that store the same.

use serde::Deserialize;

use super::bench::Bench;
use super::cells::{self, Measured};
use super::crossing::{Cost, Costs, crossing};
use super::nearest_workload::NearestWorkload;
use super::plan::Plan;
use super::run::Trouble;
use super::scene::Scene;
use crate::job::Job;
use crate::measure::{Contestant, Figures, Order, Role, Status, yardsticks};
use crate::registry::Variant;
use crate::table::Row;
use crate::workload::{Kind, NearestSet, NearestSpec, Triangle};

/// Stored forms against rays per triangle.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PrecomputeWorkload {
    /// Triangles that rays are tested against.
    #[serde(default = "triangles")]
    pub triangles: usize,
    /// Rays; a multiple of 16.
    #[serde(default = "rays")]
    pub rays: usize,
    /// Triangles that are prepared: corners and records fit the first cache.
    #[serde(default = "prepared")]
    pub prepared: usize,
    /// Rays per triangle at which the sum of preparing and testing is told.
    pub rays_per_triangle: Vec<u64>,
}

fn triangles() -> usize {
    32
}

fn rays() -> usize {
    16
}

fn prepared() -> usize {
    256
}

/// Most rays per triangle.
const MOST_RAYS: u64 = 1 << 30;

/// Empty loop and chain.
const CONTROLS: usize = 2;

/// The one piece that is kept: the rows need all of its samples.
const PIECE: &str = "all";

impl PrecomputeWorkload {
    pub(super) fn validate(&self) -> Result<(), String> {
        super::workload::in_range("prepared", self.prepared, 1)?;
        if self.rays_per_triangle.is_empty() {
            return Err("workload.rays_per_triangle: at least one is needed".to_owned());
        }
        let wrong = |rays: &&u64| !(1..=MOST_RAYS).contains(*rays);
        match self.rays_per_triangle.iter().find(wrong) {
            Some(rays) => Err(format!(
                "workload.rays_per_triangle: {rays} is not allowed; allowed: 1 to {MOST_RAYS}"
            )),
            None => self.tests().validate(),
        }
    }

    /// The tests.
    pub(super) fn tests(&self) -> NearestWorkload {
        NearestWorkload {
            triangles: self.triangles,
            rays: self.rays,
            reshuffled_rays: self.rays,
            coherence: Kind::Random,
            spread: Vec::new(),
            orders: vec![Order::Fixed],
        }
    }

    /// Contestants of the group that prepares.
    pub(super) fn contestants(variants: &[&'static Variant]) -> usize {
        stores(variants).len() + CONTROLS
    }

    /// The triangles that are prepared.
    fn prepared(&self, seed: u64) -> Result<Vec<Triangle>, Trouble> {
        let spec = NearestSpec {
            triangles: self.prepared,
            rays: self.rays,
            kind: Kind::Random,
            spread: 0.0,
            seed,
        };
        Ok(NearestSet::draw(spec)?.triangles)
    }
}

/// One variant for everything that is stored.
fn stores(variants: &[&'static Variant]) -> Vec<&'static Variant> {
    let mut stores: Vec<&'static Variant> = Vec::new();
    for variant in variants.iter().filter(|variant| variant.preparing.is_some()) {
        if !stores.iter().any(|other| store(other) == store(variant)) {
            stores.push(variant);
        }
    }
    stores
}

/// What a variant stores of a triangle, in words.
fn store(variant: &Variant) -> String {
    let axes = &variant.axes;
    format!("{} {} {}", axes.kernel, axes.stored, axes.precision)
}

/// The tests' rows with what preparing costs and where it pays, then a row for every variant and number
/// of rays per triangle.
///
/// # Errors
/// As drawing, measuring and keeping.
pub fn run(
    plan: &Plan,
    workload: &PrecomputeWorkload,
    bench: &mut Bench<'_>,
) -> Result<Measured, Trouble> {
    let (id, seed) = (&plan.experiment.id, plan.experiment.seed);
    let scene = Scene::nearest(&workload.tests(), None, Order::Fixed, seed)?;
    let ready = plan.ready();
    if let Some(rows) = bench.take_cell(PIECE, scene.facts.hash)? {
        bench.pass_over(ready.len());
        return Ok(Measured { wrong: wrong(&rows), rows, figures: Vec::new() });
    }
    let variants = &plan.variants;
    let mut measured = cells::run(id, variants, plan.reference, &scene, Order::Fixed, bench)?;
    let cancelled = |bench: &Bench<'_>| bench.cancel.load(std::sync::atomic::Ordering::Relaxed);
    if cancelled(bench) {
        return Ok(measured);
    }
    prepare(&workload.prepared(seed)?, &ready, seed, bench, &mut measured)?;
    put_crossings(&mut measured.rows);
    let sums = sums(&measured.rows, &workload.rays_per_triangle);
    measured.rows.extend(sums);
    if !cancelled(bench) {
        let all: Vec<usize> = (0..measured.rows.len()).collect();
        bench.keep_piece(PIECE, &all, &measured.rows)?;
    }
    Ok(measured)
}

fn wrong(rows: &[Row]) -> Vec<String> {
    let wrong = rows.iter().filter(|row| row.status == "wrong-result");
    wrong.map(|row| row.id.clone()).collect()
}

/// Times the preparing and writes it into the rows of all that store so.
fn prepare(
    triangles: &[Triangle],
    ready: &[&'static Variant],
    seed: u64,
    bench: &mut Bench<'_>,
    measured: &mut Measured,
) -> Result<(), Trouble> {
    let mut contestants = Vec::new();
    for variant in stores(ready) {
        let Some(bind) = variant.preparing else { continue };
        let mut job = bind(triangles);
        if let Some(item) = first_difference(job.as_mut()) {
            let of = |row: &&mut Row| store_of(row) == store(variant);
            for row in measured.rows.iter_mut().filter(of) {
                row.status = "wrong-result".into();
                row.reason = format!("triangle {item} is prepared otherwise than for its tests");
                measured.wrong.push(row.id.clone());
            }
            continue;
        }
        contestants.push(Contestant::new(store(variant), Role::Subject, job));
    }
    let Some(one) = contestants.first() else { return Ok(()) };
    let yardsticks = yardsticks(one.job.as_ref());
    contestants.extend(yardsticks);
    let report = bench.measure(&mut contestants, Order::Fixed, seed)?;
    for figures in &report.figures {
        let of = |row: &&mut Row| store_of(row) == figures.id && row.ns_per_test.is_some();
        measured.rows.iter_mut().filter(of).for_each(|row| put_preparing(row, figures));
    }
    Ok(())
}

/// The first triangle whose record is not what it has to be.
fn first_difference(job: &mut dyn Job) -> Option<usize> {
    job.answers().iter().position(|answer| answer.triangle.is_none())
}

/// [`store`] of a row's variant.
fn store_of(row: &Row) -> String {
    format!("{} {} {}", row.kernel, row.stored, row.precision)
}

fn put_preparing(row: &mut Row, figures: &Figures) {
    if let Status::Invalid(reason) = &figures.status {
        row.reason = format!("preparing: {reason}");
        return;
    }
    row.prepare_ns_per_triangle = figures.ns_per_test;
    row.prepare_ns_low = figures.ns_low;
    row.prepare_ns_high = figures.ns_high;
    row.prepare_cycles_per_triangle = figures.cycles_per_test;
    row.prepare_cycles_low = figures.cycles_interval.map(|interval| interval.low);
    row.prepare_cycles_high = figures.cycles_interval.map(|interval| interval.high);
}

fn costs(row: &Row) -> Option<Costs> {
    Some(Costs { prepare: Cost::of_preparing(row)?, test: Cost::of_test(row)? })
}

/// Says of every row from how many rays on it is cheaper than the form that prepares nothing: its own
/// kernel's, where that has one, else the reference kernel's.
fn put_crossings(rows: &mut [Row]) {
    let plain: Vec<Row> = rows.iter().filter(|row| row.stored == "vertices").cloned().collect();
    for row in rows.iter_mut().filter(|row| row.stored != "vertices") {
        let driven = |other: &&Row| {
            [&other.drive, &other.level, &other.exit] == [&row.drive, &row.level, &row.exit]
        };
        let of = |kernel: &str| plain.iter().filter(driven).find(|other| other.kernel == kernel);
        let Some(other) = of(&row.kernel).or_else(|| of("moller-trumbore")) else { continue };
        row.pays_against.clone_from(&other.kernel);
        let (Some(own), Some(other)) = (costs(row), costs(other)) else { continue };
        if let Some(found) = crossing(own, other) {
            row.pays_from_rays = Some(found.rays);
            row.pays_from_low = Some(found.low);
            row.pays_from_high = found.high;
        }
    }
}

/// A row per row and number of rays: what preparing and that many tests cost together.
fn sums(rows: &[Row], rays_per_triangle: &[u64]) -> Vec<Row> {
    let mut sums = Vec::new();
    for row in rows {
        let Some(Costs { prepare, test }) = costs(row) else { continue };
        for rays in rays_per_triangle {
            let times = *rays as f64;
            let sum = prepare.plus(times, test);
            sums.push(Row {
                rays_per_triangle: Some(*rays),
                total_cycles_per_triangle: Some(sum.median),
                total_cycles_per_ray: Some(sum.median / times),
                total_cycles_per_ray_low: Some(sum.low / times),
                total_cycles_per_ray_high: Some(sum.high / times),
                ..about(row)
            });
        }
    }
    sums
}

/// What a row is about, without what was measured.
fn about(row: &Row) -> Row {
    let mut about = row.without_clock();
    about.status.clone_from(&row.status);
    about.rounds = row.rounds;
    about
}

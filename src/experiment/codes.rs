//! Where a listing's calls end over random pairs, and how long each exit takes (thesis B, tables
//! 4.5 and 4.7).

use std::collections::BTreeMap;

use super::cells::{Bench, Measured};
use super::rows::{of_variant, put_figures};
use super::workload::CodesWorkload;
use crate::measure::{
    Chain, Contestant, Order, Progress, Protocol, Role, Surroundings, measure_group,
};
use crate::oracle::{Query, classify};
use crate::registry::Variant;
use crate::table::Row;
use crate::workload::{Ray, Triangle, WorkloadError, draw_pairs, hash};

/// Pairs that end with one code: how many there are, and the first of them.
#[derive(Default)]
struct Exit {
    calls: u64,
    rays: Vec<Ray>,
    triangles: Vec<Triangle>,
}

/// How many pairs are drawn, told apart and forgotten at a time.
const BATCH: usize = 1 << 14;

/// Why codes cannot be told or timed.
#[derive(Debug, thiserror::Error)]
pub enum CodesError {
    /// The pairs cannot be drawn.
    #[error(transparent)]
    Workload(#[from] WorkloadError),
    /// A group cannot be measured.
    #[error(transparent)]
    Protocol(#[from] crate::measure::ProtocolError),
}

/// A row per listing, code and order. Listings whose hits are not the exact line hits, but for
/// pairs that rounding or their epsilon decides, are wrong and not timed.
///
/// # Errors
/// As drawing and measuring.
pub fn run(
    experiment: &str,
    variants: &[&'static Variant],
    workload: &CodesWorkload,
    seed: u64,
    bench: &mut Bench<'_>,
) -> Result<Measured, CodesError> {
    let mut measured = Measured { rows: Vec::new(), figures: Vec::new(), wrong: Vec::new() };
    for variant in variants {
        let (exits, disagreements) = sort(variant, workload, seed)?;
        let mut row = of_variant(variant);
        row.experiment = experiment.into();
        row.workload = "pairs-codes".into();
        row.query = "line".into();
        row.winding = "natural".into();
        row.generator = workload.generator.word().into();
        row.triangles = Some(workload.pairs as u64);
        row.rays = Some(workload.pairs as u64);
        row.tests = Some(workload.pairs as u64);
        row.seed = Some(seed);
        row.status = "ok".into();
        if !(variant.available)() {
            row.status = "skipped".into();
            row.reason = format!("no {}", variant.axes.level);
        } else if disagreements > most_disagreements(workload.pairs) {
            row.status = "wrong-result".into();
            row.reason = format!("{disagreements} hits or misses differ from the exact answer");
            measured.wrong.push(variant.id());
        }
        for order in &workload.orders {
            let rows = &mut measured.rows;
            time(variant, &exits, &row, *order, (workload.pairs, seed), bench, rows)?;
        }
    }
    Ok(measured)
}

/// Undecided pairs are rare: margins below 64 roundings of 2^-24 at condition numbers of order 10
/// have a chance of order 10^-4 (and |det| <= 1e-6 of 10^-5); one in a thousand is none of that.
fn most_disagreements(pairs: usize) -> u64 {
    (pairs as u64).div_ceil(1000)
}

/// Sorts random pairs by the code with which the listing ends, and counts those about which it
/// does not agree with the exact line hit.
fn sort(
    variant: &Variant,
    workload: &CodesWorkload,
    seed: u64,
) -> Result<(BTreeMap<u8, Exit>, u64), WorkloadError> {
    let mut exits: BTreeMap<u8, Exit> = BTreeMap::new();
    let mut disagreements = 0;
    let mut rays = Vec::with_capacity(BATCH);
    let mut triangles = Vec::with_capacity(BATCH);
    let mut drawn = 0;
    draw_pairs(workload.generator, seed, workload.pairs, |ray, triangle| {
        rays.push(ray);
        triangles.push(triangle);
        drawn += 1;
        if rays.len() == BATCH || drawn == workload.pairs {
            disagreements +=
                tell_apart(variant, (&rays, &triangles), workload.timed_pairs, &mut exits);
            rays.clear();
            triangles.clear();
        }
    })?;
    Ok((exits, disagreements))
}

fn tell_apart(
    variant: &Variant,
    (rays, triangles): (&[Ray], &[Triangle]),
    most: usize,
    exits: &mut BTreeMap<u8, Exit>,
) -> u64 {
    let Some(bind) = &variant.pairs else { return 0 };
    let mut disagreements = 0;
    let answers = bind(rays, triangles).answers();
    for ((ray, triangle), answer) in rays.iter().zip(triangles).zip(answers) {
        let exit = exits.entry(answer.code).or_default();
        exit.calls += 1;
        if exit.rays.len() < most {
            exit.rays.push(*ray);
            exit.triangles.push(*triangle);
        }
        let exact = classify(&Query::of(ray, triangle)).is_hit();
        disagreements += u64::from(exact != answer.triangle.is_some());
    }
    disagreements
}

/// Times the exits of a listing side by side and adds a row for each.
fn time(
    variant: &'static Variant,
    exits: &BTreeMap<u8, Exit>,
    row: &Row,
    order: Order,
    (pairs, seed): (usize, u64),
    bench: &mut Bench<'_>,
    rows: &mut Vec<Row>,
) -> Result<(), CodesError> {
    let first = rows.len();
    let mut contestants = Vec::new();
    for (code, exit) in exits {
        let meant = |index: usize| variant.about.codes.get(index).copied().unwrap_or("");
        rows.push(Row {
            code: Some(u64::from(*code)),
            hits: Some(exit.calls),
            share: Some(exit.calls as f64 / pairs as f64),
            order: order.word().into(),
            reason: if *code == 0 { "hit" } else { meant(usize::from(*code) - 1) }.into(),
            workload_hash: format!("{:016x}", hash::workload(&exit.rays, &exit.triangles)),
            ..row.clone()
        });
        if row.status == "ok"
            && let Some(bind) = &variant.pairs
        {
            let role = if *code == 0 { Role::Reference } else { Role::Subject };
            let job = bind(&exit.rays, &exit.triangles);
            contestants.push(Contestant::new(format!("code {code}"), role, job));
        }
    }
    if contestants.is_empty() {
        return Ok(());
    }
    contestants.push(Contestant::new("chain", Role::Chain, Box::new(Chain::default())));
    let protocol = Protocol { rounds: bench.rounds, ..Protocol::new(order, seed) };
    let mut done = 0;
    let mut tell = |progress: Progress| {
        (bench.progress)(progress.done_blocks.saturating_sub(done));
        done = progress.done_blocks;
    };
    let mut surroundings = Surroundings {
        clock: bench.clock,
        disturbance: bench.disturbance,
        progress: &mut tell,
        cancel: bench.cancel,
    };
    let report = measure_group(&mut contestants, &protocol, &mut surroundings)?;
    for (row, figures) in rows[first..].iter_mut().zip(&report.figures) {
        put_figures(row, figures, "ok");
    }
    Ok(())
}

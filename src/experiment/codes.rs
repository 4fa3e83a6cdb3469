//! Where a listing's calls end over random pairs, and how long each exit takes (thesis B, tables
//! 4.5 and 4.7).

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;

use super::bench::Bench;
use super::cells::Measured;
use super::run::Trouble;
use super::scene::reported;
use super::together::{Waiting, measure_waiting};
use super::workload::CodesWorkload;
use crate::accuracy::{Truth, judge};
use crate::measure::{Chain, Contestant, Order, Protocol, Role};
use crate::oracle::{Query, classify};
use crate::registry::Variant;
use crate::rows::of_variant;
use crate::table::Row;
use crate::workload::{Ray, Triangle, WorkloadError, draw_pairs, hash};

/// Pairs that end with one code: how many there are, and the first of them.
#[derive(Default)]
struct Exit {
    calls: u64,
    rays: Vec<Ray>,
    triangles: Vec<Triangle>,
}

/// Exits that a listing has more often than not, for estimates.
pub const USUAL_EXITS: usize = 3;

/// How many pairs are drawn, told apart and forgotten at a time.
const BATCH: usize = 1 << 14;

/// A row per listing, code and order. A listing that decides a pair in a way that neither rounding
/// nor its own epsilon explains is wrong, and is not timed.
///
/// # Errors
/// As drawing, measuring and keeping.
pub fn run(
    experiment: &str,
    variants: &[&'static Variant],
    workload: &CodesWorkload,
    seed: u64,
    bench: &mut Bench<'_>,
) -> Result<Measured, Trouble> {
    let mut measured = Measured { rows: Vec::new(), figures: Vec::new(), wrong: Vec::new() };
    let mut waiting = Vec::new();
    for variant in variants {
        if bench.cancel.load(Ordering::Relaxed) {
            break;
        }
        let mut row = blank(experiment, variant, workload, seed);
        if let Some(reason) = unfit(variant) {
            row.status = "skipped".into();
            row.reason = reason;
            measured.rows.push(row);
            let place = measured.rows.len() - 1;
            bench.keep_untimed(&variant.id(), &[place], &mut measured.rows)?;
            continue;
        }
        let (exits, wrong) = sort(variant, workload, seed)?;
        if let Some(reason) = wrong {
            row.status = "wrong-result".into();
            row.reason = reason;
            measured.wrong.push(variant.id());
        }
        for order in &workload.orders {
            let rows = &mut measured.rows;
            let of = (workload.pairs, seed);
            waiting.extend(prepare(variant, &exits, &row, *order, of, bench, rows)?);
        }
    }
    measure_waiting(waiting, bench, &mut measured.rows)?;
    Ok(measured)
}

fn blank(experiment: &str, variant: &Variant, workload: &CodesWorkload, seed: u64) -> Row {
    let pairs = Some(workload.pairs as u64);
    Row {
        experiment: experiment.into(),
        workload: "pairs-codes".into(),
        query: "line".into(),
        winding: "natural".into(),
        generator: workload.generator.word().into(),
        triangles: pairs,
        rays: pairs,
        tests: pairs,
        seed: Some(seed),
        status: "ok".into(),
        ..of_variant(variant)
    }
}

/// Why a variant has no codes to tell, if it has none.
fn unfit(variant: &Variant) -> Option<String> {
    let axes = &variant.axes;
    if !(variant.available)() {
        return Some(format!("no {}", axes.level));
    }
    let asks_for_lines = axes.query == "ray" && axes.cull == "off" && axes.kernel != "chirkov";
    (variant.pairs.is_none() || !asks_for_lines)
        .then(|| "it does not answer whether a line meets a triangle".to_owned())
}

/// Sorts random pairs by the code with which the listing ends, and looks for a wrong decision.
fn sort(
    variant: &Variant,
    workload: &CodesWorkload,
    seed: u64,
) -> Result<(BTreeMap<u8, Exit>, Option<String>), WorkloadError> {
    let mut exits: BTreeMap<u8, Exit> = BTreeMap::new();
    let mut wrong = None;
    let mut rays = Vec::with_capacity(BATCH);
    let mut triangles = Vec::with_capacity(BATCH);
    let mut drawn = 0;
    draw_pairs(workload.generator, seed, workload.pairs, |ray, triangle| {
        rays.push(ray);
        triangles.push(triangle);
        drawn += 1;
        if rays.len() == BATCH || drawn == workload.pairs {
            let found = tell_apart(variant, (&rays, &triangles), workload.timed_pairs, &mut exits);
            wrong = wrong.take().or(found);
            rays.clear();
            triangles.clear();
        }
    })?;
    Ok((exits, wrong))
}

/// Adds pairs to their exits; those whose answer is right in every output are kept for timing.
/// Returns the first decision that nothing explains.
fn tell_apart(
    variant: &Variant,
    (rays, triangles): (&[Ray], &[Triangle]),
    most: usize,
    exits: &mut BTreeMap<u8, Exit>,
) -> Option<String> {
    let bind = variant.pairs.as_ref()?;
    let reported = reported(variant);
    let mut wrong = None;
    let answers = bind(rays, triangles).answers();
    for ((ray, triangle), answer) in rays.iter().zip(triangles).zip(answers) {
        let exit = exits.entry(answer.code).or_default();
        exit.calls += 1;
        let query = Query::of(ray, triangle);
        let agrees = classify(&query).is_hit() == answer.triangle.is_some();
        if agrees && exit.rays.len() >= most {
            continue;
        }
        let judgement = judge(&[answer], &[Truth::of(ray, triangle)], reported);
        // A listing that takes |det| <= epsilon for parallel is timed on such pairs as well.
        let by_epsilon = says_parallel(variant, answer.code);
        let right = judgement.wrong.is_none() && (agrees || by_epsilon);
        if (right || by_epsilon) && exit.rays.len() < most {
            exit.rays.push(*ray);
            exit.triangles.push(*triangle);
        }
        if !agrees && !by_epsilon {
            wrong = wrong.or(judgement.wrong);
        }
    }
    wrong
}

/// Whether a code of a listing stands for its own epsilon.
fn says_parallel(variant: &Variant, code: u8) -> bool {
    let index = usize::from(code).checked_sub(1);
    let meaning = index.and_then(|index| variant.about.codes.get(index));
    meaning.is_some_and(|meaning| meaning.starts_with('|') && meaning.ends_with("eps"))
}

/// Adds a row for each exit of a listing, and gets them ready to be timed side by side; nothing, where
/// the rows were kept or none is to be timed.
fn prepare(
    variant: &'static Variant,
    exits: &BTreeMap<u8, Exit>,
    row: &Row,
    order: Order,
    (pairs, seed): (usize, u64),
    bench: &mut Bench<'_>,
    rows: &mut Vec<Row>,
) -> Result<Option<Waiting>, Trouble> {
    let first = rows.len();
    rows.extend(exits.iter().map(|(code, exit)| of_exit(variant, *code, exit, row, order, pairs)));
    let piece = format!("{} {order}", row.id);
    let all: Vec<usize> = (first..rows.len()).collect();
    if bench.take_back(&piece, &all, rows)? {
        bench.pass_over(USUAL_EXITS);
        return Ok(None);
    }
    let mut places = Vec::new();
    let mut contestants = Vec::new();
    for ((code, exit), place) in exits.iter().zip(&all) {
        if row.status == "ok"
            && !exit.rays.is_empty()
            && let Some(bind) = &variant.pairs
        {
            let role = if *code == 0 { Role::Reference } else { Role::Subject };
            let job = bind(&exit.rays, &exit.triangles);
            places.push(*place);
            contestants.push(Contestant::new(format!("code {code}"), role, job));
        }
    }
    if contestants.is_empty() {
        bench.keep_piece(&piece, &all, rows)?;
        return Ok(None);
    }
    contestants.push(Contestant::new("chain", Role::Chain, Box::new(Chain::default())));
    let protocol = Protocol { rounds: bench.rounds, ..Protocol::new(order, seed) };
    Ok(Some(Waiting { places, contestants, protocol, piece, all }))
}

/// The row of an exit before it is timed.
fn of_exit(variant: &Variant, code: u8, exit: &Exit, row: &Row, order: Order, pairs: usize) -> Row {
    let meant = |index: usize| variant.about.codes.get(index).copied().unwrap_or("");
    Row {
        code: Some(u64::from(code)),
        calls: Some(exit.calls),
        hits: (code == 0).then_some(exit.calls),
        share: Some(exit.calls as f64 / pairs as f64),
        order: order.word().into(),
        reason: if code == 0 { "hit" } else { meant(usize::from(code) - 1) }.into(),
        workload_hash: format!("{:016x}", hash::workload(&exit.rays, &exit.triangles)),
        ..row.clone()
    }
}

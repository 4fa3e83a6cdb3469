//! The sweep as a whole.

use super::family::Family;
use super::sweep::Sweep;
use super::*;
use crate::job::Answer;
use crate::oracle::Query;
use crate::registry::Asked;
use crate::shard::Shard;
use crate::spread::Watch;
use crate::table::Row;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

fn sweep(ids: &[&str], kernels: &[&str], seed: u64) -> Sweep {
    let families: Vec<Family> = ids.iter().map(|id| find(id).expect(id)).collect();
    let words: Vec<String> = kernels.iter().map(|word| (*word).to_owned()).collect();
    let forms = forms(&words, Some(Precision::F32)).expect("they are kernels");
    Sweep { families, forms, depth: Depth::Quick, seed, shard: Shard::WHOLE }
}

fn rows(sweep: &Sweep, threads: usize) -> Vec<Row> {
    let cancel = AtomicBool::new(false);
    let watch = Watch { cancel: &cancel, done: &|_| {}, threads: Some(threads) };
    let outcome = sweep.run(&watch);
    assert!(outcome.complete);
    outcome.rows
}

#[test]
fn rows_do_not_depend_on_the_number_of_threads() {
    let few = |seed| sweep(&["grazing", "lattice-mesh", "t-zero"], &["wald", "chirkov"], seed);
    let one = rows(&few(1), 1);
    assert_eq!(one, rows(&few(1), 3));
    assert_ne!(one, rows(&few(2), 1));
}

#[test]
fn shards_sorted_by_place_are_the_whole() {
    let kernels = ["wald", "chirkov", "woop-watertight"];
    let of = |shard: &str| {
        let ids = ["tiny", "grazing", "lattice-mesh", "permuted-axes"];
        let one = sweep(&ids, &kernels, 1);
        let shard = shard.parse().expect("a share");
        let forms = forms(&kernels.map(str::to_owned), None).expect("they are kernels");
        let cancel = AtomicBool::new(false);
        let watch = Watch { cancel: &cancel, done: &|_| {}, threads: None };
        let outcome = Sweep { shard, forms, ..one }.run(&watch);
        outcome.places.into_iter().zip(outcome.rows).collect::<Vec<_>>()
    };
    let whole = of("1/1");
    assert!(whole.is_sorted_by_key(|(place, _)| *place));
    let mut parts = ["2/3", "3/3", "1/3"].map(of).concat();
    parts.sort_by_key(|(place, _)| *place);
    // What is said of the inputs alone is in every shard.
    parts.dedup();
    assert_eq!(parts, whole);
}

#[test]
fn what_is_cancelled_is_not_complete() {
    let cancel = AtomicBool::new(true);
    let watch = Watch { cancel: &cancel, done: &|_| {}, threads: None };
    let outcome = sweep(&["grazing"], &["wald"], 1).run(&watch);
    assert!(!outcome.complete && outcome.rows.is_empty());
}

static STOP: AtomicBool = AtomicBool::new(false);

/// A kernel that hits nothing, and is told to end when it is asked.
fn stopping(_: &Query) -> Answer {
    STOP.store(true, Ordering::Relaxed);
    Answer::default()
}

#[test]
fn a_setting_that_was_begun_is_ended_within_it() {
    // One of each kind of work.
    for id in ["grazing", "lattice-mesh", "spawned-rays", "permuted-axes"] {
        STOP.store(false, Ordering::Relaxed);
        let mut sweep = sweep(&[id], &["wald"], 1);
        let wald = sweep.forms.iter().find(|form| !form.flushes()).expect("the usual one");
        let asked = Asked { axes: wald.asked.axes.clone(), ask: stopping, ..*wald.asked };
        let form = Form { asked: Box::leak(Box::new(asked)), ..wald.clone() };
        sweep.forms = vec![form.clone(), form];
        let begun = AtomicUsize::new(0);
        let count = |_: usize| {
            begun.fetch_add(1, Ordering::Relaxed);
        };
        let outcome = sweep.run(&Watch { cancel: &STOP, done: &count, threads: Some(1) });
        assert!(STOP.load(Ordering::Relaxed) && begun.into_inner() == 1, "{id}");
        assert!(!outcome.complete && outcome.rows.is_empty(), "{id}");
    }
}

#[test]
fn plane_kernels_fail_far_away_before_those_that_translate_first() {
    let rows = rows(&sweep(&["far"], &["moller-trumbore", "perpendicular-planes"], 1), 2);
    let knee = |kernel: &str| {
        let row = rows.iter().find(|row| row.record == "knee" && row.kernel == kernel);
        row.expect(kernel).knee.unwrap_or(f64::INFINITY)
    };
    assert!(knee("perpendicular-planes") < knee("moller-trumbore"));
}

#[test]
fn rays_at_exact_edges_are_lost_by_kernels_that_round() {
    let rows = rows(&sweep(&["lattice-mesh"], &["moller-trumbore", "wald"], 1), 2);
    let rays: Vec<&Row> = rows.iter().filter(|row| row.record == "rays").collect();
    assert_eq!(rays.len(), 4);
    for row in &rays {
        // Every origin is inside, and every ray meets one point.
        assert_eq!(row.cases, Some(4000));
        assert_eq!(row.nan_outputs, Some(0));
    }
    assert!(rays.iter().map(|row| row.double_hits.unwrap_or(0)).sum::<u64>() > 0);
}

#[test]
fn every_family_gives_rows_of_every_form() {
    let ids: Vec<&str> = families().iter().map(|family| family.id).collect();
    // Meshes have tests of their own, and take long without optimisation.
    let ids: Vec<&str> = ids.into_iter().filter(|id| !id.starts_with("closed-")).collect();
    let mut sweep = sweep(&ids, &["moller-trumbore"], 1);
    for family in &mut sweep.families {
        family.knobs = |_| vec![1.0];
    }
    let rows = rows(&sweep, 2);
    for id in ids {
        let row = rows.iter().find(|row| row.family == id).expect(id);
        assert!(row.cases.is_some_and(|cases| cases > 100), "{id}");
        assert_eq!(row.record, find(id).unwrap().work.record());
    }
}

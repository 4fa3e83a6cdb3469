//! How long searches take, before they are run.

use super::run::CONTROLS;
use super::subject::{Class, Subject};
use super::volumes;
use super::workload::StructuresWorkload;
use crate::scene::built_in;

/// What an estimate takes for granted: so long takes a triangle to be built into a structure and answered
/// about, and a ray to be searched for and judged, each with every structure.
const SECONDS_PER_TRIANGLE: f64 = 16e-6;
const SECONDS_PER_RAY: f64 = 15e-6;
const SECONDS_PER_LIST_TEST: f64 = 25e-9;

/// Blocks that are timed.
pub fn blocks(workload: &StructuresWorkload, rounds: usize) -> usize {
    let subjects = workload.subjects().unwrap_or_default();
    let in_class = |class: &Class| {
        let here = |one: &&Subject| one.class() == *class && one.lacks().is_none();
        match subjects.iter().filter(here).count() {
            0 => 0,
            count => rounds * (count + CONTROLS),
        }
    };
    let of_set: usize = Class::ALL.iter().map(in_class).sum();
    let sets = workload.scenes.len() * workload.rays.len();
    of_set * sets + workload.volumes.as_ref().map_or(0, |volumes| volumes::blocks(volumes, rounds))
}

/// Seconds of building, checking and calibrating.
pub fn seconds_around(workload: &StructuresWorkload) -> f64 {
    let subjects = workload.subjects().unwrap_or_default();
    let of_class = |class: Class| subjects.iter().filter(|one| one.class() == class).count() as f64;
    let of_scene = |scene: &String| {
        let mesh = built_in::named(scene).and_then(Result::ok);
        let triangles = mesh.map_or(0, |mesh| mesh.triangles.len());
        let sets = workload.rays.len() as f64;
        let tests = (workload.list_count(triangles) * triangles) as f64;
        SECONDS_PER_TRIANGLE * triangles as f64 * subjects.len() as f64
            + sets * SECONDS_PER_RAY * workload.count() as f64 * subjects.len() as f64
            + sets * SECONDS_PER_LIST_TEST * tests * of_class(Class::Linear)
    };
    workload.scenes.iter().map(of_scene).sum()
}

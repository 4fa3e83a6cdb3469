//! What of structures needs no clock: orders of insertion, and chances to meet a part of a volume.

use std::sync::atomic::{AtomicBool, Ordering};

use super::set::{chords, opened, scene_name};
use super::subject::leaves_of;
use super::workload::{CountedWorkload, StructuresWorkload};
use crate::experiment::clock_free::Placed;
use crate::rows::of_axes;
use crate::shard::Shard;
use crate::structure::volume::Bounds;
use crate::structure::{Beam, Chance, Hierarchy, StructureJob, by_surface_area, inserted};
use crate::table::Row;
use crate::workload::{Pcg, Ray, Triangle, WorkloadError, hash};

/// The generator's stream for random orders.
const ORDERS: u64 = 0x4f52_4445;
/// Fewest lines that must meet both volumes, and that must meet the outer one alone, by the ratio of the
/// surfaces: then the share is as good as normal, and five standard errors come once in two million pairs.
const ENOUGH: f64 = 100.0;

/// Number of tasks: a row each.
fn tasks(counted: &CountedWorkload) -> usize {
    counted.scenes.len() * (counted.orders + 1)
}

/// The rows of a share of the tasks: for each scene one per order, then one of chances.
///
/// # Errors
/// As making a scene.
pub fn rows(
    experiment: &str,
    workload: &StructuresWorkload,
    seed: u64,
    shard: Shard,
    cancel: &AtomicBool,
) -> Result<Vec<Placed>, WorkloadError> {
    let Some(counted) = &workload.counted else { return Ok(Vec::new()) };
    let mut rows = Vec::new();
    for task in shard.range(tasks(counted)) {
        if cancel.load(Ordering::Relaxed) {
            break;
        }
        let (scene, order) = (task / (counted.orders + 1), task % (counted.orders + 1));
        let scene = &counted.scenes[scene];
        let mesh = opened(scene)?;
        let (triangles, rays) = (mesh.list(), chords(&mesh, counted.lines, seed)?);
        let row = if order < counted.orders {
            of_order(&workload.kernels[0], (&triangles, &rays), order, seed)
        } else {
            of_chances(&triangles, &rays)
        };
        let row = Row {
            experiment: experiment.into(),
            workload: "scene-counted".into(),
            scene: scene_name(scene).into(),
            ray_class: "random".into(),
            triangles: Some(triangles.len() as u64),
            rays: Some(rays.len() as u64),
            query: "ray".into(),
            generator: "pcg".into(),
            workload_hash: format!("{:016x}", hash::workload(&rays, &triangles)),
            seed: Some(seed),
            status: "ok".into(),
            ..row
        };
        rows.push((task as u64, row));
    }
    Ok(rows)
}

/// What a ray costs in the hierarchy that an order of insertion makes.
fn of_order(
    kernel: &str,
    (triangles, rays): (&[Triangle], &[Ray]),
    order: usize,
    seed: u64,
) -> Row {
    let leaf = leaves_of(&[kernel.to_owned()]).ok().and_then(|leaves| leaves.into_iter().next());
    let Some(leaf) = leaf else { return Row::default() };
    let (name, order) = order_of(triangles, order, seed);
    let tree = Hierarchy::<Bounds>::new(triangles, &inserted(triangles, &order));
    let tree = Box::new(tree) as Box<dyn crate::structure::Structure>;
    let counts = StructureJob::new(tree, (leaf.prepare)(triangles), rays, false).counts();
    let per_ray = |count: u64| Some(count as f64 / counts.rays.max(1) as f64);
    let own = of_axes(&leaf.axes);
    Row {
        id: format!("inserted/{}", own.id),
        record: "insertion".into(),
        structure: "inserted".into(),
        variation: name,
        tests: Some(counts.triangles),
        hits: Some(counts.hits),
        tests_per_ray: counts.triangles_per_ray(),
        nodes_per_ray: per_ray(counts.nodes),
        volumes_per_ray: per_ray(counts.volumes),
        passed_share: counts.share_passed(),
        ..own
    }
}

/// As given, along an axis, and as drawn.
fn order_of(triangles: &[Triangle], number: usize, seed: u64) -> (String, Vec<u32>) {
    let mut order: Vec<u32> = (0..triangles.len() as u32).collect();
    match number {
        0 => ("as given".to_owned(), order),
        1 => {
            let place = |index: &u32| triangles[*index as usize].a.x;
            order.sort_by(|one, other| place(one).total_cmp(&place(other)));
            ("along x".to_owned(), order)
        }
        _ => {
            Pcg::stream(seed.wrapping_add(number as u64), ORDERS).shuffle(&mut order);
            (format!("random {}", number - 1), order)
        }
    }
}

/// How far shares of lines are from ratios of surfaces, in a hierarchy of boxes.
fn of_chances(triangles: &[Triangle], rays: &[Ray]) -> Row {
    let tree = Hierarchy::<Bounds>::new(triangles, &by_surface_area(triangles));
    let beams: Vec<Beam> = rays.iter().filter_map(Beam::of_ray).collect();
    let errors: Vec<f64> = tree.chances(&beams).iter().filter_map(standard_errors).collect();
    Row {
        id: "surface/chances".into(),
        kernel: "none".into(),
        record: "chance".into(),
        structure: "surface".into(),
        chance_pairs: Some(errors.len() as u64),
        chance_error_max: errors.into_iter().reduce(f64::max),
        build: crate::measure::BuildInfo::of_this_program().label(),
        ..Row::default()
    }
}

/// Distance of a share from the ratio of surfaces, in standard errors of a share of so many draws; nothing
/// where too few lines are expected.
fn standard_errors(chance: &Chance<Bounds>) -> Option<f64> {
    let share = chance.child.area() / chance.parent.area();
    let (lines, expected) = (chance.parent_met as f64, share * chance.parent_met as f64);
    let is_enough = expected >= ENOUGH && lines - expected >= ENOUGH;
    let error = (chance.child_met as f64 - expected).abs() / (expected * (1.0 - share)).sqrt();
    is_enough.then_some(error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_held_against_ratios_of_surfaces() {
        let unit = |x: f32| {
            let corner = |x: f32| glam::Vec3::new(x, 1.0, 1.0);
            Bounds::of(&Triangle { a: glam::Vec3::ZERO, b: corner(x), c: corner(x) })
        };
        // Surfaces of 10 and of 6.
        let (Some(parent), Some(child)) = (unit(2.0), unit(1.0)) else { panic!("finite boxes") };
        let chance = |parent_met, child_met| Chance { parent, child, parent_met, child_met };
        assert_eq!(standard_errors(&chance(1000, 600)), Some(0.0));
        // A standard error is sqrt(1000 * 0.6 * 0.4), 15.5 lines.
        let error = standard_errors(&chance(1000, 631)).expect("enough lines");
        assert!((error - 31.0 / 240.0f64.sqrt()).abs() < 1e-12);
        assert_eq!(standard_errors(&chance(160, 96)), None);
    }

    #[test]
    fn orders_are_all_of_the_triangles_and_differ() {
        let mesh = opened("soup:50").expect("a built-in scene");
        let triangles = mesh.list();
        let all: Vec<_> = (0..4).map(|number| order_of(&triangles, number, 7)).collect();
        for (place, (name, order)) in all.iter().enumerate() {
            let mut sorted = order.clone();
            sorted.sort_unstable();
            assert!(sorted.iter().copied().eq(0..50), "{name}");
            assert!(all[..place].iter().all(|other| other.0 != *name && other.1 != *order));
        }
    }
}

//! How much of what a packet does its rays needed: a packet goes on while any of its rays does.

use super::scene::Scene;
use crate::counting::{Counter, counters};
use crate::oracle::Query;
use crate::registry::{Asked, asked};
use crate::table::Row;
use crate::workload::{Ray, Triangle};

/// Who says how far a hit is. Which kernel does it does not matter: rays are drawn so that no nearest hit is
/// in doubt.
const NEAREST_BY: &str = "moller-trumbore/f64/single/sse2/early/last/plain/tuv";

/// Fills the column `useful_lanes` of early packets, where rays come in bunches.
pub fn put(rows: &mut [Row], scene: &Scene) {
    if scene.facts.spread.is_none() {
        return;
    }
    let Some(by) = asked().iter().find(|asked| is_nearest_by(asked)) else { return };
    let counters = counters();
    let mut distances: Vec<Vec<f32>> = Vec::new();
    for row in rows.iter_mut().filter(|row| row.exit == "early") {
        let Some(lanes) = row.drive.strip_prefix("packet").and_then(|n| n.parse().ok()) else {
            continue;
        };
        if distances.is_empty() {
            let bounds = |ray: &Ray| bounds(ray, &scene.triangles, by);
            distances = scene.rays.iter().map(bounds).collect();
        }
        let counter = counters.iter().find(|counter| counts(counter, row));
        row.useful_lanes = counter
            .map(|counter| useful(counter, lanes, (&scene.rays, &scene.triangles), &distances));
    }
}

fn is_nearest_by(asked: &Asked) -> bool {
    asked.id() == NEAREST_BY.replace("sse2", asked.axes.level)
}

/// Whether the counter is of the row's form.
fn counts(counter: &Counter, row: &Row) -> bool {
    counter.kernel == row.kernel
        && counter.stored == row.stored
        && counter.edges == row.edges
        && counter.cross == row.cross
        && counter.division == row.division
        && counter.output == "tuv"
}

/// What bounds a ray's search before each triangle: the distance of the nearest hit so far.
fn bounds(ray: &Ray, triangles: &[Triangle], by: &Asked) -> Vec<f32> {
    let mut bound = ray.t_max;
    let mut bounds = Vec::with_capacity(triangles.len());
    for triangle in triangles {
        bounds.push(bound);
        let answer = (by.ask)(&Query::of(&Ray { t_max: bound, ..*ray }, triangle));
        if answer.triangle.is_some() {
            bound = answer.t as f32;
        }
    }
    bounds
}

/// Operations of every ray's own tests, over those of the packets: as many as its longest test has,
/// for each of its rays.
fn useful(
    counter: &Counter,
    lanes: usize,
    (rays, triangles): (&[Ray], &[Triangle]),
    bounds: &[Vec<f32>],
) -> f64 {
    let (mut needed, mut done) = (0, 0);
    for (packet, bounds) in rays.chunks_exact(lanes).zip(bounds.chunks_exact(lanes)) {
        for (place, triangle) in triangles.iter().enumerate() {
            let mut longest = 0;
            for (ray, bounds) in packet.iter().zip(bounds) {
                let (_, operations) =
                    (counter.run)(&Ray { t_max: bounds[place], ..*ray }, triangle);
                let operations = operations.arithmetic() + operations.compare;
                needed += operations;
                longest = longest.max(operations);
            }
            done += longest * lanes as u64;
        }
    }
    needed as f64 / done as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::{Facts, NearestWorkload};
    use crate::measure::Order;

    /// The share of a packet of sixteen rays so far apart.
    fn share(spread: f64) -> f64 {
        let text = format!(
            "coherence = \"bunches\"\nspread = [{spread}]\norders = [\"fixed\"]\nrays = 64"
        );
        let workload: NearestWorkload = toml::from_str(&text).expect("a plain workload");
        let scene = Scene::nearest(&workload, Some(spread), Order::Fixed, 1).expect("it is drawn");
        let row = Row {
            kernel: "wald".into(),
            stored: "precomputed".into(),
            division: "last".into(),
            exit: "early".into(),
            drive: "packet16".into(),
            ..Row::default()
        };
        let mut rows = [row.clone(), Row { exit: "full".into(), ..row }];
        put(&mut rows, &scene);
        assert_eq!(rows[1].useful_lanes, None);
        rows[0].useful_lanes.expect("an early packet of bunches")
    }

    #[test]
    fn rays_that_are_all_alike_waste_nothing_and_random_ones_much() {
        let (alike, apart) = (share(1e-6), share(100.0));
        assert!(alike > 0.99 && alike <= 1.0, "{alike}");
        assert!(apart > 1.0 / 16.0 && apart < 0.9, "{apart}");
    }

    #[test]
    fn other_rays_have_no_share() {
        let facts = Facts::default();
        let mut rows = [Row { exit: "early".into(), drive: "packet16".into(), ..Row::default() }];
        put(&mut rows, &Scene::of_points(facts, Vec::new(), Vec::new()));
        assert_eq!(rows[0].useful_lanes, None);
    }
}

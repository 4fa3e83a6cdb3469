//! Operations per kernel and exit path, counted while the kernels run; no clock.

use super::clock_free::Placed;
use crate::counting::{Counter, counters, paths};
use crate::shard::Shard;
use crate::table::Row;
use crate::workload::{Generator, Ray, Triangle, WorkloadError, draw_pairs, hash};

/// Pairs on which exits are looked for: every exit of every kernel but those that wait for
/// rounding (|det| <= eps) takes at least one in a hundred of them.
const PAIRS: usize = 4000;

/// A row per form and exit path, with the operations of its longest path; a task is a form.
///
/// # Errors
/// As drawing.
pub fn rows(experiment: &str, seed: u64, shard: Shard) -> Result<Vec<Placed>, WorkloadError> {
    let (mut rays, mut triangles) = (Vec::new(), Vec::new());
    draw_pairs(Generator::Pcg, seed, PAIRS, |ray, triangle| {
        rays.push(ray);
        triangles.push(triangle);
    })?;
    let counters = counters();
    let of_task = |task: usize| {
        let rows = of_counter(&counters[task], (&rays, &triangles)).into_iter();
        rows.map(move |row| {
            (task as u64, Row { experiment: experiment.into(), seed: Some(seed), ..row })
        })
    };
    Ok(shard.range(counters.len()).flat_map(of_task).collect())
}

fn of_counter(counter: &Counter, (rays, triangles): (&[Ray], &[Triangle])) -> Vec<Row> {
    let paths = paths(counter, rays, triangles);
    let row = |path: &crate::counting::ExitPath| Row {
        kernel: path.kernel.into(),
        precision: "f32".into(),
        drive: "single".into(),
        exit: "early".into(),
        division: path.division.into(),
        rounding: "plain".into(),
        output: path.output.into(),
        stored: path.stored.into(),
        edges: path.edges.into(),
        cross: path.cross.into(),
        workload: "pairs-operations".into(),
        query: "line".into(),
        winding: "natural".into(),
        generator: "pcg".into(),
        workload_hash: format!("{:016x}", hash::workload(rays, triangles)),
        tests: Some(rays.len() as u64),
        calls: Some(path.calls),
        share: Some(path.calls as f64 / rays.len() as f64),
        status: "ok".into(),
        code: Some(u64::from(path.code)),
        ops_add: Some(path.longest.add),
        ops_sub: Some(path.longest.sub),
        ops_neg: Some(path.longest.neg),
        ops_mul: Some(path.longest.mul),
        ops_div: Some(path.longest.div),
        ops_condition: Some(path.longest.condition),
        ..Row::default()
    };
    paths.iter().map(row).collect()
}

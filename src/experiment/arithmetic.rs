//! Multiplications and additions alone: how much wider registers can gain at most.

use super::bench::Bench;
use super::rows::put_group;
use super::run::Trouble;
use crate::batch::OPERATIONS;
use crate::measure::{BuildInfo, Chain, Contestant, Order, Role};
use crate::registry::units;
use crate::table::Row;

/// A row per level and precision; a `test` is one multiplication or addition of one lane. Ratios
/// refer to the first unit, the narrowest.
///
/// # Errors
/// A group that cannot be measured or kept.
pub fn run(experiment: &str, seed: u64, bench: &mut Bench<'_>) -> Result<Vec<Row>, Trouble> {
    let mut rows = Vec::new();
    let mut contestants = Vec::new();
    let mut places = Vec::new();
    for unit in units() {
        let mut row = Row {
            id: format!("arithmetic/{}/packet{}/{}", unit.precision, unit.lanes, unit.level),
            experiment: experiment.into(),
            kernel: "arithmetic".into(),
            precision: unit.precision.into(),
            drive: format!("packet{}", unit.lanes),
            level: unit.level.into(),
            rounding: "plain".into(),
            workload: "arithmetic".into(),
            order: Order::Fixed.word().into(),
            tests: Some(OPERATIONS * unit.lanes as u64),
            build: BuildInfo::of_this_program().label(),
            seed: Some(seed),
            ..Row::default()
        };
        if (unit.available)() {
            let role = if contestants.is_empty() { Role::Reference } else { Role::Subject };
            contestants.push(Contestant::new(row.id.clone(), role, (unit.job)()));
            places.push(rows.len());
        } else {
            row.status = "skipped".into();
            row.reason = format!("no {}", unit.level);
        }
        rows.push(row);
    }
    let all: Vec<usize> = (0..rows.len()).collect();
    if bench.take_back(PIECE, &all, &mut rows)? {
        bench.pass_over(places.len());
        return Ok(rows);
    }
    contestants.push(Contestant::new("chain", Role::Chain, Box::new(Chain::default())));
    let report = bench.measure(&mut contestants, Order::Fixed, seed)?;
    for (place, figures) in places.into_iter().zip(&report.figures) {
        put_group(&mut rows[place], figures, &report, "ok");
    }
    if !report.cancelled {
        bench.keep_piece(PIECE, &all, &rows)?;
    }
    Ok(rows)
}

/// All units are one group.
const PIECE: &str = "units";

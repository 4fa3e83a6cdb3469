//! Multiplications and additions alone: how much wider registers can gain at most.

use super::bench::Bench;
use super::rows::put_group;
use super::run::Trouble;
use crate::batch::OPERATIONS;
use crate::job::Job;
use crate::measure::{BuildInfo, Chain, Contestant, Order, Role};
use crate::registry::{Unit, units};
use crate::table::Row;

/// A row per level and precision; a `test` is one multiplication or addition of one lane. Ratios
/// refer to the first unit, the narrowest.
///
/// # Errors
/// A group that cannot be measured or kept.
pub fn run(experiment: &str, seed: u64, bench: &mut Bench<'_>) -> Result<Vec<Row>, Trouble> {
    let member = |unit: Unit| {
        let row = Row {
            id: format!("arithmetic/{}/packet{}/{}", unit.precision, unit.lanes, unit.level),
            experiment: experiment.into(),
            kernel: "arithmetic".into(),
            precision: unit.precision.into(),
            drive: format!("packet{}", unit.lanes),
            level: unit.level.into(),
            rounding: "plain".into(),
            tests: Some(OPERATIONS * unit.lanes as u64),
            seed: Some(seed),
            ..Row::default()
        };
        Member { row, job: (unit.available)().then(unit.job) }
    };
    measure(PIECE, units().into_iter().map(member).collect(), seed, bench)
}

/// All units are one group.
const PIECE: &str = "units";

/// A loop of arithmetic to be measured.
pub struct Member {
    /// Its row, with its own columns.
    pub row: Row,
    /// The loop, where this processor has the level.
    pub job: Option<Box<dyn Job>>,
}

/// The rows of loops that are measured as one group, the piece of that name. Ratios refer to the first.
///
/// # Errors
/// A group that cannot be measured or kept.
pub fn measure(
    piece: &str,
    members: Vec<Member>,
    seed: u64,
    bench: &mut Bench<'_>,
) -> Result<Vec<Row>, Trouble> {
    let mut rows = Vec::new();
    let mut contestants = Vec::new();
    let mut places = Vec::new();
    for Member { mut row, job } in members {
        row.workload = "arithmetic".into();
        row.order = Order::Fixed.word().into();
        row.build = BuildInfo::of_this_program().label();
        if let Some(job) = job {
            let role = if contestants.is_empty() { Role::Reference } else { Role::Subject };
            contestants.push(Contestant::new(row.id.clone(), role, job));
            places.push(rows.len());
        } else {
            row.status = "skipped".into();
            row.reason = format!("no {}", row.level);
        }
        rows.push(row);
    }
    let all: Vec<usize> = (0..rows.len()).collect();
    if bench.take_back(piece, &all, &mut rows)? {
        bench.pass_over(places.len());
        return Ok(rows);
    }
    if places.is_empty() {
        return Ok(rows);
    }
    contestants.push(Contestant::new("chain", Role::Chain, Box::new(Chain::default())));
    let report = bench.measure(&mut contestants, Order::Fixed, seed)?;
    for (place, figures) in places.into_iter().zip(&report.figures) {
        put_group(&mut rows[place], figures, &report, "ok");
    }
    if !report.cancelled {
        bench.keep_piece(piece, &all, &rows)?;
    }
    Ok(rows)
}

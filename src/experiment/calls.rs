//! Single rays once more, as a program calls them that must know one answer before it asks the
//! next question: how long an answer takes (latency), and how long a call takes whose code and
//! branches have been forgotten since the last one (cold). Throughput ranks routines for loops;
//! these rank them for the leaf of a hierarchy. Where every ray is tested against all triangles,
//! what is called is the walk of one ray, and the figures are those of a test of it.

use super::bench::Bench;
use super::cells::{Cell, Piece};
use crate::measure::{
    Contestant, Dependent, Figures, Group, GroupReport, Invalid, Order, Pace, Protocol,
    ProtocolError, Role, Status,
};
use crate::table::Row;

/// Half of a block of throughput: latencies differ by more than what the other half would add.
const LATENCY_BLOCK_NS: u64 = 30_000;

/// A quarter of the rounds of throughput: both figures are coarser than what more would add (a cold call
/// is ten steps of a good clock, mostly the clock's own and the call's), and with as many rounds they
/// would be two thirds of all blocks.
pub fn call_rounds(rounds: usize) -> usize {
    (rounds / 4).max(Protocol::LEAST_ROUNDS)
}

/// Reference, empty loop and chain.
pub const CALL_CONTROLS: usize = 3;

/// The single rays of a group, with a reference and the empty loop and the chain.
struct Calls {
    /// Which cell they are of.
    cell: usize,
    contestants: Vec<Contestant>,
    /// Where the row of each stands; `None` of the controls.
    places: Vec<Option<usize>>,
    order: Order,
    seed: u64,
}

/// Measures the single rays of groups that were measured in a loop, in turns, and fills the columns
/// of latency and cold calls.
///
/// # Errors
/// A group that cannot be measured.
pub fn measure(
    pieces: Vec<Piece>,
    cells: &mut [Cell],
    bench: &mut Bench<'_>,
) -> Result<(), ProtocolError> {
    let mut calls: Vec<Calls> = pieces.into_iter().filter_map(|piece| of(piece, cells)).collect();
    if calls.is_empty() {
        return Ok(());
    }
    let rounds = call_rounds(bench.rounds);
    let protocol = |calls: &Calls| Protocol { rounds, ..Protocol::new(calls.order, calls.seed) };
    let cold = |calls: &Calls| Protocol { pace: Pace::Cold, ..protocol(calls) };
    measure_as(&mut calls, cells, bench, cold, put_cold)?;
    for group in &mut calls {
        let contestants = std::mem::take(&mut group.contestants);
        group.contestants = contestants.into_iter().map(dependent).collect();
    }
    let latency = |calls: &Calls| Protocol {
        pace: Pace::Latency,
        block_ns: LATENCY_BLOCK_NS,
        ..protocol(calls)
    };
    measure_as(&mut calls, cells, bench, latency, put_latency)
}

/// Who takes part of a group; nobody, where it has no single rays.
fn of(piece: Piece, cells: &[Cell]) -> Option<Calls> {
    let cell = &cells[piece.cell];
    let rows = &cell.measured.rows;
    let places = piece.places.iter().map(|place| Some(*place)).chain(std::iter::repeat(None));
    let takes_part = |contestant: &Contestant, place: Option<usize>| match contestant.role {
        Role::Subject => place.is_some_and(|place| is_single(&rows[place])),
        Role::Reference => place.is_none_or(|place| is_single(&rows[place])),
        Role::Empty | Role::Chain => true,
        // What copies differ by is told by the throughput of the same rounds.
        Role::Placebo => false,
    };
    let both = piece.contestants.into_iter().zip(places);
    let (contestants, places): (Vec<Contestant>, Vec<Option<usize>>) =
        both.filter(|(contestant, place)| takes_part(contestant, *place)).unzip();
    let (order, seed) = (cell.order, cell.seed);
    let calls = Calls { cell: piece.cell, contestants, places, order, seed };
    calls.places.iter().any(Option::is_some).then_some(calls)
}

fn dependent(contestant: Contestant) -> Contestant {
    match contestant.role {
        Role::Chain => contestant,
        _ => Contestant { job: Box::new(Dependent::new(contestant.job)), ..contestant },
    }
}

fn measure_as(
    calls: &mut [Calls],
    cells: &mut [Cell],
    bench: &mut Bench<'_>,
    protocol: impl Fn(&Calls) -> Protocol,
    fill: fn(&mut Row, &Figures, Option<f64>),
) -> Result<(), ProtocolError> {
    let protocols: Vec<Protocol> = calls.iter().map(protocol).collect();
    let both = calls.iter_mut().zip(&protocols);
    let mut groups: Vec<Group<'_>> = both
        .map(|(calls, protocol)| Group { contestants: &mut calls.contestants, protocol })
        .collect();
    let reports = bench.measure_together(&mut groups)?;
    for (calls, report) in calls.iter().zip(&reports) {
        put(report, &calls.places, &mut cells[calls.cell].measured.rows, fill);
    }
    Ok(())
}

fn is_single(row: &Row) -> bool {
    row.drive == "single" && matches!(row.status.as_str(), "ok" | "inexact")
}

/// Fills the rows of a group; `floor` is the time of the call that tests nothing.
fn put(
    report: &GroupReport,
    places: &[Option<usize>],
    rows: &mut [Row],
    fill: fn(&mut Row, &Figures, Option<f64>),
) {
    let floor = report.figures.iter().find(|figures| figures.role == Role::Empty);
    let floor = floor.and_then(|figures| figures.ns_per_test);
    for (figures, place) in report.figures.iter().zip(places) {
        if let Some(place) = place {
            match &figures.status {
                Status::Ok => fill(&mut rows[*place], figures, floor),
                Status::Invalid(reason) => put_invalid(&mut rows[*place], reason),
            }
        }
    }
}

/// Other answers as a call than in a loop spoil the row; anything else leaves the columns empty.
fn put_invalid(row: &mut Row, reason: &Invalid) {
    if matches!(reason, Invalid::Interrupted { .. }) {
        return;
    }
    if matches!(reason, Invalid::Hits { .. } | Invalid::Tally { .. }) {
        row.status = "invalid".into();
        row.verdict = "invalid".into();
    }
    let before = if row.reason.is_empty() { String::new() } else { format!("{}; ", row.reason) };
    row.reason = format!("{before}as a call: {reason}");
}

fn put_latency(row: &mut Row, figures: &Figures, floor_ns: Option<f64>) {
    row.latency_ns_per_test = figures.ns_per_test;
    row.latency_ns_low = figures.ns_low;
    row.latency_ns_high = figures.ns_high;
    row.latency_cycles_per_test = figures.cycles_per_test;
    row.latency_floor_ns = floor_ns;
    let ratio = figures.ratio_to_reference;
    row.latency_ratio_to_reference = ratio.map(|ratio| ratio.estimate);
    row.latency_ratio_low = ratio.map(|ratio| ratio.low);
    row.latency_ratio_high = ratio.map(|ratio| ratio.high);
}

fn put_cold(row: &mut Row, figures: &Figures, floor_ns: Option<f64>) {
    row.cold_ns_per_test = figures.ns_per_test;
    row.cold_ns_low = figures.ns_low;
    row.cold_ns_high = figures.ns_high;
    row.cold_floor_ns = floor_ns;
    let ratio = figures.ratio_to_reference;
    row.cold_ratio_to_reference = ratio.map(|ratio| ratio.estimate);
    row.cold_ratio_low = ratio.map(|ratio| ratio.low);
    row.cold_ratio_high = ratio.map(|ratio| ratio.high);
}

//! Single rays once more, as a program calls them that must know one answer before it asks the
//! next question: how long an answer takes (latency), and how long a call takes whose code and
//! branches have been forgotten since the last one (cold). Throughput ranks routines for loops;
//! these rank them for the leaf of a hierarchy. Where every ray is tested against all triangles,
//! what is called is the walk of one ray, and the figures are those of a test of it.

use super::bench::Bench;
use crate::measure::{
    Contestant, Dependent, Figures, GroupReport, Invalid, Order, Pace, Protocol, ProtocolError,
    Role, Status,
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

/// Measures the single rays among `contestants`, whose rows stand at `places` (in their order,
/// before the controls), and fills the columns of latency and cold calls.
///
/// # Errors
/// A group that cannot be measured.
pub fn measure(
    contestants: Vec<Contestant>,
    places: &[usize],
    order: Order,
    seed: u64,
    bench: &mut Bench<'_>,
    rows: &mut [Row],
) -> Result<(), ProtocolError> {
    let places = places.iter().map(|place| Some(*place)).chain(std::iter::repeat(None));
    let takes_part = |contestant: &Contestant, place: Option<usize>| match contestant.role {
        Role::Subject => place.is_some_and(|place| is_single(&rows[place])),
        Role::Reference => place.is_none_or(|place| is_single(&rows[place])),
        Role::Empty | Role::Chain => true,
        // What copies differ by is told by the throughput of the same rounds.
        Role::Placebo => false,
    };
    let (mut group, places): (Vec<Contestant>, Vec<Option<usize>>) = contestants
        .into_iter()
        .zip(places)
        .filter(|(contestant, place)| takes_part(contestant, *place))
        .unzip();
    if places.iter().all(Option::is_none) {
        return Ok(());
    }
    let protocol = Protocol { rounds: call_rounds(bench.rounds), ..Protocol::new(order, seed) };
    let cold = Protocol { pace: Pace::Cold, ..protocol.clone() };
    put(&bench.measure_as(&mut group, &cold)?, &places, rows, put_cold);
    let dependent = |contestant: Contestant| match contestant.role {
        Role::Chain => contestant,
        _ => Contestant { job: Box::new(Dependent::new(contestant.job)), ..contestant },
    };
    let mut group: Vec<Contestant> = group.into_iter().map(dependent).collect();
    let latency = Protocol { pace: Pace::Latency, block_ns: LATENCY_BLOCK_NS, ..protocol };
    put(&bench.measure_as(&mut group, &latency)?, &places, rows, put_latency);
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

//! How long it takes to build a structure.

use std::sync::atomic::Ordering;

use super::subject::Subject;
use crate::experiment::bench::Bench;
use crate::stats::{median, sign_interval};
use crate::table::Row;
use crate::workload::Triangle;

/// Times that a structure is built, at most; enough for an interval.
const MOST_BUILDS: usize = 9;
/// Nanoseconds after which it is not begun again: what takes so long is told by one time.
const ENOUGH_NS: u64 = 200_000_000;

/// Milliseconds of each of some buildings, from triangles to a structure with prepared leaves. Too long for
/// blocks of the usual length, and too different from structure to structure for rounds.
pub fn times_ms(subject: &Subject, triangles: &[Triangle], bench: &mut Bench<'_>) -> Vec<f64> {
    let mut times = Vec::new();
    let mut sum = 0;
    while times.len() < MOST_BUILDS && sum < ENOUGH_NS && !bench.cancel.load(Ordering::Relaxed) {
        let start = bench.clock.now_ns();
        subject.rebuild(triangles);
        let ns = bench.clock.now_ns().saturating_sub(start);
        times.push(ns as f64 * 1e-6);
        sum += ns;
    }
    times
}

/// Writes them into a row. Without enough for an interval, it is that of their extremes.
pub fn put(row: &mut Row, times: &[f64]) {
    row.build_ms = median(times);
    let interval = sign_interval(times).map(|interval| (interval.low, interval.high));
    let extreme = |fold: fn(f64, f64) -> f64| times.iter().copied().reduce(fold);
    let ends = interval.or_else(|| extreme(f64::min).zip(extreme(f64::max)));
    (row.build_low, row.build_high) = (ends.map(|ends| ends.0), ends.map(|ends| ends.1));
}

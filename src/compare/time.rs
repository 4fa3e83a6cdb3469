//! What got slower.
//!
//! Two figures of a row stand for its time: its cycles, and its ratio to the reference of its
//! group. Cycles are compared as they are. Ratios are compared only where the reference itself
//! stayed what it was: a faster reference makes no other kernel slower.
//!
//! A change counts if its estimate is beyond the threshold and beyond the noise floor of both runs,
//! its interval leaves 1 out, and both halves of the rounds are beyond the threshold, each by
//! itself. "The same" is a finding too: the whole interval lies within the threshold. Everything
//! else is unresolved, and so is what the noise floor alone hides.
//!
//! The halves are ratios to the reference, also where cycles are judged. Cycles of a whole group
//! can change by half between two runs of one program, when a neighbour comes to share the core,
//! and both halves of the rounds see it: only what changes against others measured in the same
//! rounds, while these stay what they were, is a change of the code. So the reference, whose own
//! ratio is always 1, is confirmed by the ratios of the others, which fall when it rises; alone in
//! its group it is not confirmed. Nor is what makes a whole group slower at once, and what was
//! measured beside such a neighbour.
//!
//! One process has its own luck with addresses, which no round of it shows. What must not fail by
//! chance repeats the comparison with fresh processes, as `scripts/compare_commits.sh` does.
//!
//! All is reckoned in logarithms, so that swapping the sides changes signs and nothing else.

use super::finding::{Change, Judged};
use super::group::References;
use super::threshold::Threshold;
use crate::table::Row;

/// Least noise floor: saved cycles of one program differ by 0.14 to 0.26 % over fresh processes.
const LEAST_FLOOR: f64 = 0.002;

/// New over base, in logarithms.
#[derive(Clone, Copy)]
struct Quotient {
    estimate: f64,
    /// Ends of its interval.
    interval: Option<(f64, f64)>,
    /// What confirms it: the change from either half of the rounds alone.
    halves: Option<(f64, f64)>,
}

/// What one figure says, what decides first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    Changed,
    /// Beyond the threshold, and not confirmed.
    Unconfirmed,
    Same,
    /// Within the threshold, but the interval is not.
    Wide,
}

/// Judges the time of a cell; `None` where there is no figure to judge by.
pub(super) fn judge(
    base: &Row,
    new: &Row,
    references: &References,
    threshold: Threshold,
) -> Option<Judged> {
    if !stands(base) || !stands(new) {
        return None;
    }
    let own_reference = is_reference(base) && is_reference(new);
    let kept = references.drift(new).is_none_or(|drift| drift.abs() <= threshold.log());
    let ratio = if kept && !own_reference { by_ratio(base, new) } else { None };
    let figures = [
        ("cycles_per_test", by_cycles(base, new, references, own_reference)),
        ("ratio_to_reference", ratio),
    ];
    let floor = noise_floor(base).max(noise_floor(new)).max(LEAST_FLOOR).ln_1p();
    let steady = references.steady(new, threshold.log()) && !is_crowded(base) && !is_crowded(new);
    let outcomes = figures.into_iter().filter_map(|(figure, quotient)| {
        let mut quotient = quotient?;
        quotient.halves = quotient.halves.filter(|_| steady);
        Some((outcome(quotient, threshold.log(), floor), figure, quotient))
    });
    // Of equals the first: cycles before ratios.
    let (outcome, figure, quotient) = outcomes.min_by_key(|(outcome, ..)| *outcome)?;
    let change = Change {
        ratio: Some(quotient.estimate.exp()),
        low: quotient.interval.map(|(low, _)| low.exp()),
        high: quotient.interval.map(|(_, high)| high.exp()),
        ..Change::of(figure, base, new)
    };
    Some(match outcome {
        Outcome::Changed if quotient.estimate > 0.0 => Judged::Worse(change),
        Outcome::Changed => Judged::Better(change),
        Outcome::Same => Judged::Same,
        Outcome::Unconfirmed | Outcome::Wide => Judged::Unresolved(change),
    })
}

fn outcome(quotient: Quotient, threshold: f64, floor: f64) -> Outcome {
    let sign = quotient.estimate.signum();
    let beyond = |log: f64| sign * log > threshold;
    let leaves_one_out = |(low, high): (f64, f64)| sign * low > 0.0 && sign * high > 0.0;
    let confirmed = quotient.interval.is_some_and(leaves_one_out)
        && quotient.halves.is_some_and(|(first, second)| beyond(first) && beyond(second));
    let inside = |(low, high): (f64, f64)| -threshold < low && high < threshold;
    if beyond(quotient.estimate) && sign * quotient.estimate > floor && confirmed {
        Outcome::Changed
    } else if quotient.interval.is_some_and(inside) {
        Outcome::Same
    } else if beyond(quotient.estimate) {
        Outcome::Unconfirmed
    } else {
        Outcome::Wide
    }
}

/// Whether a row was measured beside a neighbour on the core: what he takes differs from kernel to
/// kernel, and no round shows it.
fn is_crowded(row: &Row) -> bool {
    row.crowded_share.is_some_and(|share| share > 0.0)
}

/// Whether the figures of a row stand.
pub(super) fn stands(row: &Row) -> bool {
    matches!(row.status.as_str(), "ok" | "inexact")
}

/// Whether a row is the reference of its group: then its ratio is 1 in every round.
pub(super) fn is_reference(row: &Row) -> bool {
    let one = |ratio: Option<f64>| ratio.is_none_or(|ratio| ratio == 1.0);
    let others = [row.ratio_low, row.ratio_high, row.ratio_first_half, row.ratio_second_half];
    row.ratio_to_reference == Some(1.0) && others.into_iter().all(one)
}

/// What this row's group calls a difference, relative.
fn noise_floor(row: &Row) -> f64 {
    let placebo = || positive(row.ratio_placebo).map(|ratio| ratio.ln().abs());
    row.noise_floor.or_else(placebo).unwrap_or(0.0)
}

fn by_ratio(base: &Row, new: &Row) -> Option<Quotient> {
    let estimate = ln_quotient(base.ratio_to_reference, new.ratio_to_reference)?;
    Some(Quotient {
        estimate,
        interval: ratio_interval(base, new, estimate),
        halves: halves(base, new),
    })
}

fn by_cycles(
    base: &Row,
    new: &Row,
    references: &References,
    own_reference: bool,
) -> Option<Quotient> {
    let estimate = ln_quotient(base.cycles_per_test, new.cycles_per_test)?;
    let has_ratio = base.ratio_to_reference.is_some() && new.ratio_to_reference.is_some();
    if has_ratio && !own_reference {
        let (interval, halves) = (ratio_interval(base, new, estimate), halves(base, new));
        return Some(Quotient { estimate, interval, halves });
    }
    let ends = |row: &Row| (row.cycles_low, row.cycles_per_test, row.cycles_high);
    let interval = if same_measurement(base, new) {
        Some((estimate, estimate))
    } else {
        interval(ends(base), ends(new), estimate)
    };
    let own = ln_quotient(base.cycles_first_half, new.cycles_first_half)
        .zip(ln_quotient(base.cycles_second_half, new.cycles_second_half));
    let others = references.against_others(new).filter(|_| own_reference);
    let halves = others.zip(own).map(|(a, b)| (weaker(a.0, b.0), weaker(a.1, b.1)));
    Some(Quotient { estimate, interval, halves })
}

/// The smaller of two changes; none if they go opposite ways.
fn weaker(a: f64, b: f64) -> f64 {
    if a.signum() != b.signum() { 0.0 } else { a.signum() * a.abs().min(b.abs()) }
}

fn ratio_interval(base: &Row, new: &Row, estimate: f64) -> Option<(f64, f64)> {
    if same_measurement(base, new) {
        return Some((estimate, estimate));
    }
    let ends = |row: &Row| (row.ratio_low, row.ratio_to_reference, row.ratio_high);
    interval(ends(base), ends(new), estimate)
}

/// What the ratio became, by either half of the rounds.
pub(super) fn halves(base: &Row, new: &Row) -> Option<(f64, f64)> {
    ln_quotient(base.ratio_first_half, new.ratio_first_half)
        .zip(ln_quotient(base.ratio_second_half, new.ratio_second_half))
}

/// Whether two rows are one measurement and not two that agree: every figure of time is equal to
/// the last bit. Then there is no chance between them.
fn same_measurement(base: &Row, new: &Row) -> bool {
    let figures = |row: &Row| {
        let ratio = [row.ratio_to_reference, row.ratio_low, row.ratio_high];
        let halves = [row.ratio_first_half, row.ratio_second_half];
        (row.ns_per_test, row.min_ns, row.rounds, row.cycles_per_test, ratio, halves)
    };
    figures(base) == figures(new)
}

/// The interval of a quotient from (low, estimate, high) of either side, the widths relative to
/// their estimates: each end is taken with the other side's opposite end, so that the interval
/// covers wherever both sides' do. It holds the estimate, whatever was done to a file by hand.
fn interval(
    base: (Option<f64>, Option<f64>, Option<f64>),
    new: (Option<f64>, Option<f64>, Option<f64>),
    estimate: f64,
) -> Option<(f64, f64)> {
    let below = ln_quotient(new.1, new.0)? - ln_quotient(base.1, base.2)?;
    let above = ln_quotient(new.1, new.2)? - ln_quotient(base.1, base.0)?;
    Some((estimate + below.min(0.0), estimate + above.max(0.0)))
}

/// ln(new / base), which changes its sign exactly when the sides are swapped.
pub(super) fn ln_quotient(base: Option<f64>, new: Option<f64>) -> Option<f64> {
    Some(positive(new)?.ln() - positive(base)?.ln())
}

pub(super) fn positive(figure: Option<f64>) -> Option<f64> {
    figure.filter(|figure| *figure > 0.0 && figure.is_finite())
}

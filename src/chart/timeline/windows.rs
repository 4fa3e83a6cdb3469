//! Rounds -> windows of time: how far the reference was from its usual time, and what was lost.

use crate::stats::median;
use crate::table::Round;
use std::collections::BTreeMap;

/// Windows of a long run: of that many, each is a few pixels wide.
const MOST: usize = 160;
/// Rounds that a window has on average at least, so that its quartiles mean something.
const FEWEST_ROUNDS: usize = 16;

/// Of a window's rounds that count, so many make quartiles.
const FEWEST_COUNTING: usize = 4;

/// A round with its place.
pub(super) struct Placed<'a> {
    /// It.
    pub round: &'a Round,
    /// The reference's time over its median in the group, less 1, in percent.
    pub percent: f64,
}

/// A narrow piece of the run's time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Window {
    /// Seconds since the run began.
    pub from: f64,
    /// The same.
    pub to: f64,
    /// Lower quartile, median and upper quartile of the rounds that count, in percent; `None` where
    /// too few rounds count.
    pub quartiles: Option<[f64; 3]>,
    /// Rounds, dropped ones included.
    pub rounds: usize,
    /// Rounds dropped as disturbed.
    pub dirty: usize,
    /// Rounds with a neighbour on the core.
    pub crowded: usize,
}

/// Rounds of groups with a reference, against the group's own median: that of its clean rounds,
/// where there are any.
pub(super) fn placed(rounds: &[Round]) -> Vec<Placed<'_>> {
    let mut times: BTreeMap<(&str, &str), [Vec<f64>; 2]> = BTreeMap::new();
    for round in rounds {
        let of_cell = times.entry((&round.experiment, &round.cell)).or_default();
        let is_clean = usize::from(round.state == "clean");
        of_cell[is_clean].extend(round.reference_ns_per_test);
    }
    let typical: BTreeMap<(&str, &str), f64> = times
        .into_iter()
        .filter_map(|(cell, [others, clean])| Some((cell, median(&clean).or(median(&others))?)))
        .collect();
    let percent = |round: &'_ Round| -> Option<f64> {
        let typical = typical.get(&(round.experiment.as_str(), round.cell.as_str()))?;
        Some(100.0 * (round.reference_ns_per_test? / typical - 1.0))
    };
    let placed = rounds.iter().filter_map(|round| Some(Placed { round, percent: percent(round)? }));
    placed.filter(|one| one.percent.is_finite() && one.round.at_s.is_finite()).collect()
}

/// Windows of equal length from the beginning of the run to its last round, those without a round
/// left out.
pub(super) fn windows(placed: &[Placed<'_>]) -> Vec<Window> {
    let end = placed.iter().map(|one| one.round.at_s).fold(0.0, f64::max);
    let count = (placed.len() / FEWEST_ROUNDS).clamp(1, MOST);
    let length = if end > 0.0 { end / count as f64 } else { 1.0 };
    let mut members: BTreeMap<usize, Vec<&Placed<'_>>> = BTreeMap::new();
    for one in placed {
        let index = ((one.round.at_s.max(0.0) / length) as usize).min(count - 1);
        members.entry(index).or_default().push(one);
    }
    let window = |(index, members): (usize, Vec<&Placed<'_>>)| {
        let of = |state: &str| members.iter().filter(|one| one.round.state == state).count();
        let counting = members.iter().filter(|one| one.round.state != "dirty");
        Window {
            from: index as f64 * length,
            to: (index + 1) as f64 * length,
            quartiles: quartiles(counting.map(|one| one.percent).collect()),
            rounds: members.len(),
            dirty: of("dirty"),
            crowded: of("crowded"),
        }
    };
    members.into_iter().map(window).collect()
}

/// Median, and the medians of the halves below and above it, which both have the middle one where
/// the number is odd (Tukey's hinges).
fn quartiles(mut values: Vec<f64>) -> Option<[f64; 3]> {
    if values.len() < FEWEST_COUNTING {
        return None;
    }
    values.sort_by(f64::total_cmp);
    let half = values.len().div_ceil(2);
    let above = &values[values.len() - half..];
    Some([median(&values[..half])?, median(&values)?, median(above)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn round(cell: &str, at_s: f64, ns: f64, state: &str) -> Round {
        Round {
            experiment: "h-4".into(),
            cell: cell.into(),
            round: 0,
            at_s,
            reference_ns_per_test: Some(ns),
            state: state.into(),
        }
    }

    #[test]
    fn quartiles_need_four_values() {
        assert_eq!(quartiles(Vec::new()), None);
        assert_eq!(quartiles(vec![3.0; 3]), None);
        assert_eq!(quartiles(vec![4.0, 1.0, 3.0, 2.0]), Some([1.5, 2.5, 3.5]));
        assert_eq!(quartiles(vec![5.0, 1.0, 3.0, 2.0, 4.0]), Some([2.0, 3.0, 4.0]));
    }

    #[test]
    fn groups_are_held_against_their_own_median() {
        let rounds = [
            round("0 fixed", 0.0, 4.0, "clean"),
            round("0 fixed", 1.0, 6.0, "dirty"),
            round("1 fixed", 2.0, 400.0, "clean"),
            round("1 fixed", 3.0, 400.0, "crowded"),
        ];
        let percent: Vec<f64> = placed(&rounds).iter().map(|one| one.percent).collect();
        assert_eq!(percent, [0.0, 50.0, 0.0, 0.0]);
        // Without a clean round, the others tell what is usual.
        let crowded = [round("0 fixed", 0.0, 4.0, "crowded")];
        assert_eq!(placed(&crowded)[0].percent, 0.0);
    }

    #[test]
    fn a_window_counts_what_was_dropped_and_leaves_it_out_of_its_median() {
        let mut rounds: Vec<Round> =
            (0..32).map(|at| round("0 fixed", f64::from(at), 4.0, "clean")).collect();
        rounds[3] = round("0 fixed", 3.0, 400.0, "dirty");
        rounds[31] = round("0 fixed", 31.0, 5.0, "crowded");
        let placed = placed(&rounds);
        let found = windows(&placed);
        assert_eq!(found.len(), 2);
        let of = |window: &Window| (window.rounds, window.dirty, window.crowded);
        assert_eq!((of(&found[0]), of(&found[1])), ((16, 1, 0), (16, 0, 1)));
        assert_eq!(found[0].quartiles, Some([0.0; 3]));
        assert_eq!((found[0].from, found[1].to), (0.0, 31.0));
    }

    #[test]
    fn where_every_round_was_dropped_there_is_no_median_and_a_pause_is_no_window() {
        let state = |at: u32| if at < 16 { "dirty" } else { "clean" };
        let rounds: Vec<Round> = (0..32)
            .map(|at| round("0 fixed", f64::from(if at < 16 { 0 } else { 100 }), 4.0, state(at)))
            .collect();
        let found = windows(&placed(&rounds));
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].quartiles, found[0].dirty), (None, 16));
        assert!(windows(&[]).is_empty());
        // A run of one moment has one window.
        let moment = [round("0 fixed", 0.0, 4.0, "clean")];
        assert_eq!(windows(&placed(&moment)).len(), 1);
    }
}

//! An axis of errors: logarithmic, cut where many decades are empty, with a place for zero.

use crate::chart::axis::Axis;

/// Empty decades beyond which the axis is cut: single and double precision are nine apart, and
/// what is to be compared lies within one of them.
const EMPTY_DECADES: f64 = 2.0;
/// Share of the axis that a cut takes.
const CUT: f64 = 0.03;
/// Share of it that zero takes, where there is one.
const ZERO: f64 = 0.05;
/// No piece is drawn as if it had fewer decades than this.
const LEAST_DECADES: f64 = 1.0;
/// Room beside the outermost values of a piece.
const MARGIN: f64 = 1.35;

/// The axis.
pub(super) struct Errors {
    pieces: Vec<Piece>,
    /// Whether zero has a place, at the left edge.
    pub has_zero: bool,
}

/// A piece without a cut, from `from` to `to` of the whole length.
struct Piece {
    axis: Axis,
    from: f64,
    to: f64,
}

impl Errors {
    /// An axis for these ranges; `None` where none is above zero.
    pub fn of(ranges: &[(f64, f64)]) -> Option<Self> {
        let has_zero = ranges.iter().any(|(low, _)| *low <= 0.0);
        let runs = runs(ranges);
        let start = if has_zero { ZERO } else { 0.0 };
        let weight =
            |(low, high): &(f64, f64)| (high * MARGIN / (low / MARGIN)).log10().max(LEAST_DECADES);
        let weights: f64 = runs.iter().map(weight).sum();
        let length = 1.0 - start - CUT * runs.len().saturating_sub(1) as f64;
        let (mut pieces, mut from) = (Vec::new(), start);
        for run in &runs {
            let to = from + length * weight(run) / weights;
            pieces.push(Piece { axis: Axis::log(&[run.0 / MARGIN, run.1 * MARGIN])?, from, to });
            from = to + CUT;
        }
        (!pieces.is_empty()).then_some(Errors { pieces, has_zero })
    }

    /// Place of an error from 0 to 1. Zero is in the middle of its own place; what lies in a cut is
    /// at its edge.
    pub fn place(&self, error: f64) -> f64 {
        if error <= 0.0 {
            return ZERO / 2.0;
        }
        let reached = |piece: &&Piece| piece.axis.place(error) < 1.0;
        let piece = self.pieces.iter().find(reached).or(self.pieces.last());
        piece.map_or(0.0, |piece| piece.from + piece.axis.place(error) * (piece.to - piece.from))
    }

    /// Ticks with their places, as many as have room on an axis of that length.
    pub fn ticks(&self, length: f64, size: f64) -> Vec<(f64, String)> {
        let mut ticks = Vec::new();
        if self.has_zero {
            ticks.push((ZERO / 2.0, "0".to_owned()));
        }
        for piece in &self.pieces {
            let room = (piece.to - piece.from) * length;
            let own = piece.axis.ticks_within(room, size);
            ticks.extend(own.into_iter().map(|(value, words)| (self.place(value), words)));
        }
        ticks
    }

    /// Middles of the cuts.
    pub fn cuts(&self) -> Vec<f64> {
        self.pieces.windows(2).map(|pair| (pair[0].to + pair[1].from) / 2.0).collect()
    }

    /// Ends of the pieces.
    pub fn pieces(&self) -> impl Iterator<Item = (f64, f64)> {
        self.pieces.iter().map(|piece| (piece.from, piece.to))
    }
}

/// The ranges put together where they are less than [`EMPTY_DECADES`] apart, in rising order.
fn runs(ranges: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let above = |(low, high): &(f64, f64)| {
        (*high > 0.0).then_some((if *low > 0.0 { *low } else { *high }, *high))
    };
    let mut ranges: Vec<(f64, f64)> = ranges.iter().filter_map(above).collect();
    ranges.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut runs: Vec<(f64, f64)> = Vec::new();
    for (low, high) in ranges {
        match runs.last_mut() {
            Some(run) if (low / run.1).log10() <= EMPTY_DECADES => run.1 = run.1.max(high),
            _ => runs.push((low, high)),
        }
    }
    runs
}

//! From values to places: linear and logarithmic axes with ticks at 1, 2 and 5.

use super::text;

/// An axis over finite values.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    low: f64,
    high: f64,
    log: bool,
}

impl Axis {
    /// An axis that starts at zero (or below, for values below) and ends on a tick.
    pub fn from_zero(values: &[f64], ticks: usize) -> Self {
        let (low, high) = range(values);
        Axis::linear(low.min(0.0), high.max(0.0), ticks)
    }

    /// An axis that starts at zero only where that leaves the values most of its length; lines are
    /// read by their slopes and distances, which an empty lower half would flatten.
    pub fn fitted(values: &[f64], ticks: usize) -> Self {
        let (low, high) = range(values);
        if low >= 0.0 && low < 0.3 * high {
            Axis::linear(0.0, high, ticks)
        } else {
            Axis::linear(low, high, ticks)
        }
    }

    /// A logarithmic axis over the values above zero; `None` if there are none.
    pub fn log(values: &[f64]) -> Option<Self> {
        let positive: Vec<f64> = values.iter().copied().filter(|value| *value > 0.0).collect();
        if positive.is_empty() {
            return None;
        }
        let (low, high) = range(&positive);
        let (low, high) = (low.max(LEAST), high.max(LEAST));
        // A margin keeps markers off the frame, and the ends apart where all values are equal.
        Some(Axis { low: low / 1.15, high: high * 1.15, log: true })
    }

    /// Exactly the range of the values, for an axis whose points should reach both ends.
    pub fn exact(values: &[f64]) -> Self {
        let (low, high) = range(values);
        if low == high {
            let half = 0.5f64.max(low.abs() / 100.0);
            Axis { low: low - half, high: high + half, log: false }
        } else {
            Axis { low, high, log: false }
        }
    }

    fn linear(low: f64, high: f64, ticks: usize) -> Self {
        let spread = if high > low { high - low } else { high.abs().max(1.0) };
        let step = step(spread, ticks);
        let (low, high) = ((low / step).floor() * step, (high / step).ceil() * step);
        if high > low {
            Axis { low, high, log: false }
        } else {
            Axis { low, high: low + step, log: false }
        }
    }

    /// Whether a value has a place on the axis.
    pub fn shows(&self, value: f64) -> bool {
        value.is_finite() && (!self.log || value > 0.0)
    }

    /// Whether a value lies between the ends of the axis.
    pub fn reaches(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    /// Place of a value from 0 (low end) to 1 (high end).
    pub fn place(&self, value: f64) -> f64 {
        let of = |value: f64| if self.log { value.max(f64::MIN_POSITIVE).ln() } else { value };
        ((of(value) - of(self.low)) / (of(self.high) - of(self.low))).clamp(0.0, 1.0)
    }

    /// Whether zero, where bars start, is on the axis.
    pub fn has_zero(&self) -> bool {
        !self.log && self.low <= 0.0 && self.high >= 0.0
    }

    /// Ticks and their labels, about as many as asked for.
    pub fn ticks(&self, about: usize) -> Vec<(f64, String)> {
        if self.log { self.log_ticks(about) } else { self.linear_ticks(about) }
    }

    /// As many ticks as have room side by side on an axis of that length.
    pub fn ticks_within(&self, length: f64, size: f64) -> Vec<(f64, String)> {
        let candidates = [6, 5, 4, 3, 2, 1].map(|about| self.ticks(about));
        candidates.into_iter().find(|ticks| self.fit(ticks, length, size)).unwrap_or_default()
    }

    /// Whether labels of that size, centred on their ticks in rising order, leave each other room.
    pub fn fit(&self, ticks: &[(f64, String)], length: f64, size: f64) -> bool {
        ticks.windows(2).all(|pair| {
            let distance = (self.place(pair[1].0) - self.place(pair[0].0)) * length;
            let words = pair.iter().map(|(_, words)| text::width(words, size, false)).sum::<f64>();
            distance >= words / 2.0 + 5.0
        })
    }

    fn linear_ticks(&self, about: usize) -> Vec<(f64, String)> {
        let step = step(self.high - self.low, about);
        let first = (self.low / step - 1e-6).ceil() as i64;
        let last = (self.high / step + 1e-6).floor() as i64;
        let tick = |index| (index as f64 * step, text::tick(index as f64 * step, step));
        (first..=last).map(tick).collect()
    }

    /// 1-2-5 in every decade while that stays readable, else whole decades, else every nth.
    fn log_ticks(&self, about: usize) -> Vec<(f64, String)> {
        let (first, last) = (self.low.log10().floor() as i32, self.high.log10().ceil() as i32);
        let decades = (last - first).max(1) as usize;
        let within = |value: &f64| (self.low..=self.high).contains(value);
        let fine = |decade| [1, 2, 5].map(|digit| power(digit, decade));
        let ticks: Vec<f64> = (first..=last).flat_map(fine).filter(within).collect();
        if !ticks.is_empty() && ticks.len() <= about.max(3) * 2 {
            return ticks.into_iter().map(|value| (value, text::tick(value, value))).collect();
        }
        let stride = decades.div_ceil(about.max(1) * 2);
        let coarse = (first..=last).step_by(stride).map(|decade| power(1, decade)).filter(within);
        coarse.map(|value| (value, text::tick(value, value))).collect()
    }
}

/// `digit` times ten to the `decade`, correctly rounded: a product of powers would print digits of noise.
fn power(digit: u32, decade: i32) -> f64 {
    format!("{digit}e{decade}").parse().unwrap_or(f64::NAN)
}

/// Beyond these an axis has no place of its own: spreads and margins must be numbers as well.
const MOST: f64 = 1e300;
/// Likewise, of logarithmic ones.
const LEAST: f64 = 1e-300;

fn range(values: &[f64]) -> (f64, f64) {
    let finite = values.iter().copied().filter(|value| value.is_finite());
    let finite = finite.map(|value| value.clamp(-MOST, MOST));
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low <= high { (low, high) } else { (0.0, 1.0) }
}

/// The smallest of 1, 2, 5 times a power of ten that gives at most `ticks` steps.
fn step(spread: f64, ticks: usize) -> f64 {
    let raw = (spread / ticks.max(1) as f64).max(f64::MIN_POSITIVE * 1e10);
    let decade = raw.log10().floor() as i32;
    let steps = [power(1, decade), power(2, decade), power(5, decade), power(1, decade + 1)];
    steps.into_iter().find(|step| *step >= raw * (1.0 - 1e-9)).unwrap_or(raw)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_finite_value_has_a_place_and_ticks_are_few() {
        let ends = [0.0, 1.0, -1.0, 5e-324, 1e-300, 1e300, f64::MAX, f64::MIN, 1e16, 1e16 + 2.0];
        for low in ends {
            for high in ends {
                let values = [low, high];
                let linear = [Axis::from_zero, Axis::fitted].map(|axis| axis(&values, 5));
                let all =
                    linear.into_iter().chain([Axis::exact(&values)]).chain(Axis::log(&values));
                for axis in all {
                    let places = values.map(|value| axis.place(value));
                    assert!(places.iter().all(|place| (0.0..=1.0).contains(place)), "{axis:?}");
                    let ticks = axis.ticks(5);
                    assert!(ticks.len() < 40, "{axis:?}: {ticks:?}");
                    assert!(ticks.iter().all(|(tick, _)| tick.is_finite()), "{axis:?}: {ticks:?}");
                }
            }
        }
    }
}

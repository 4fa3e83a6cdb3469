//! From when on a change of time counts.

use std::fmt;
use std::str::FromStr;

/// A relative change, > 0: 0.03 is 3 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold(f64);

/// Ten times slower needs no threshold to be seen.
const MOST_PERCENT: f64 = 1000.0;

/// A text that is no threshold; says what is one.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "allowed: a percentage above 0 % and up to 1000 %, such as 3%, or a share below 1 such as 0.03"
)]
pub struct ThresholdError;

impl Threshold {
    /// In percent.
    pub fn percent(self) -> f64 {
        self.0 * 100.0
    }

    /// ln(1 + threshold): slower and faster by the same factor are equally far from 0.
    pub(super) fn log(self) -> f64 {
        self.0.ln_1p()
    }
}

impl FromStr for Threshold {
    type Err = ThresholdError;

    /// `3%`, `3 %` or `0.03`. A bare number of 1 or more is refused: `3` means 3 % to most, and
    /// 300 % to whoever writes 0.03.
    fn from_str(text: &str) -> Result<Self, ThresholdError> {
        let text = text.trim();
        let share = match text.strip_suffix('%') {
            Some(percent) => percent.trim_end().parse::<f64>().ok().map(|percent| percent / 100.0),
            None => text.parse::<f64>().ok().filter(|share| *share < 1.0),
        };
        let allowed = |share: &f64| *share > 0.0 && *share <= MOST_PERCENT / 100.0;
        share.filter(allowed).map(Threshold).ok_or(ThresholdError)
    }
}

impl fmt::Display for Threshold {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}%", self.percent())
    }
}

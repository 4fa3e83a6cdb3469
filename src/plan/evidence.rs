//! What measuring says about leaving something out.

use crate::stats::{Ratio, paired_ratio};

/// What is saved by leaving something out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saving {
    /// Time without it over time with it.
    pub ratio: Ratio,
    /// The smallest relative difference that is told from chance.
    pub floor: f64,
}

impl Saving {
    /// Of times per test, one a round, in the same rounds; `floor` is what identical code differs by.
    /// `None` where there are too few of them.
    pub fn of(without: &[f64], with: &[f64], floor: f64) -> Option<Self> {
        Some(Saving { ratio: paired_ratio(without, with)?, floor })
    }

    /// Whether the difference is within noise: the interval reaches into what identical code differs by.
    pub fn is_noise(&self) -> bool {
        self.ratio.low <= 1.0 + self.floor && self.ratio.high >= 1.0 / (1.0 + self.floor)
    }

    /// Whether it is slower without, beyond noise.
    pub fn is_loss(&self) -> bool {
        !self.is_noise() && self.ratio.estimate > 1.0
    }

    /// Percent of the time with it; 0 where that is noise, negative where it is slower without.
    pub fn percent(&self) -> f64 {
        if self.is_noise() { 0.0 } else { (1.0 - self.ratio.estimate) * 100.0 }
    }

    /// In words.
    pub fn words(&self) -> String {
        if self.is_noise() {
            let floor = 100.0 * self.floor;
            return format!("no difference in time beyond the noise of {floor:.1} %");
        }
        let low = (1.0 - self.ratio.high) * 100.0;
        let high = (1.0 - self.ratio.low) * 100.0;
        format!("saves {:.1} % ({low:.1} to {high:.1})", self.percent())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn saving(without: f64, with: f64, floor: f64) -> Saving {
        let rounds = [1.0, 1.01, 0.99, 1.0, 1.02, 0.98, 1.0, 1.0];
        let times = |time: f64| rounds.map(|slow| time * slow);
        Saving::of(&times(without), &times(with), floor).expect("eight rounds")
    }

    #[test]
    fn noise_saves_nothing() {
        let half = saving(5.0, 10.0, 0.01);
        assert!(!half.is_noise() && !half.is_loss());
        assert!((half.percent() - 50.0).abs() < 1e-9);
        let tiny = saving(9.95, 10.0, 0.01);
        assert!(tiny.is_noise());
        assert_eq!(tiny.percent(), 0.0);
        assert!(tiny.words().contains("noise of 1.0 %"));
        // The same difference, told by a finer machine.
        assert!(saving(9.95, 10.0, 0.001).percent() > 0.0);
    }

    #[test]
    fn what_is_slower_without_is_a_loss() {
        let loss = saving(12.0, 10.0, 0.01);
        assert!(loss.is_loss() && loss.percent() < 0.0);
        assert!(saving(10.05, 10.0, 0.01).is_noise());
    }
}

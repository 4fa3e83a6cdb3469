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

    /// What may be said of it.
    pub fn verdict(&self) -> Verdict {
        let (least, most) = (1.0 / (1.0 + self.floor), 1.0 + self.floor);
        if self.ratio.high < least {
            Verdict::Saves
        } else if self.ratio.low > most {
            Verdict::Costs
        } else if self.ratio.low >= least && self.ratio.high <= most {
            Verdict::Same
        } else {
            Verdict::Undecided
        }
    }

    /// Whether no difference is told: there is none, or it cannot be told from noise.
    pub fn is_noise(&self) -> bool {
        matches!(self.verdict(), Verdict::Same | Verdict::Undecided)
    }

    /// Whether it is slower without, beyond noise.
    pub fn is_loss(&self) -> bool {
        self.verdict() == Verdict::Costs
    }

    /// Percent of the time with it; 0 where that is noise, negative where it is slower without.
    pub fn percent(&self) -> f64 {
        if self.is_noise() { 0.0 } else { self.unjudged() }
    }

    /// Percent of the time with it, noise or not.
    fn unjudged(&self) -> f64 {
        (1.0 - self.ratio.estimate) * 100.0
    }

    /// In words.
    pub fn words(&self) -> String {
        let floor = 100.0 * self.floor;
        let low = (1.0 - self.ratio.high) * 100.0;
        let high = (1.0 - self.ratio.low) * 100.0;
        let percent = self.unjudged();
        let said = if percent < 0.0 {
            let (least, most) = (-high, -low);
            format!("takes {:.1} % longer ({least:.1} to {most:.1})", -percent)
        } else {
            format!("saves {percent:.1} % ({low:.1} to {high:.1})")
        };
        match self.verdict() {
            Verdict::Saves | Verdict::Costs => said,
            Verdict::Same => format!("saves nothing beyond the noise of {floor:.1} %"),
            Verdict::Undecided => {
                format!("undecided: {said}, not clear of the noise of {floor:.1} %")
            }
        }
    }
}

/// What an interval says beside what identical code differs by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is faster without.
    Saves,
    /// It is slower without.
    Costs,
    /// All of the interval is within noise.
    Same,
    /// A part of it is.
    Undecided,
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
        assert_eq!(tiny.words(), "saves nothing beyond the noise of 1.0 %");
        // The same difference, told by a finer machine.
        assert!(saving(9.95, 10.0, 0.001).percent() > 0.0);
    }

    #[test]
    fn what_reaches_out_of_the_noise_is_undecided() {
        let ratio = Ratio { estimate: 0.985, low: 0.97, high: 1.0 };
        let between = Saving { ratio, floor: 0.01 };
        assert_eq!(between.verdict(), Verdict::Undecided);
        assert_eq!((between.percent(), between.is_noise()), (0.0, true));
        let words = "undecided: saves 1.5 % (0.0 to 3.0), not clear of the noise of 1.0 %";
        assert_eq!(between.words(), words);
        let narrow = Ratio { low: 0.98, high: 0.989, ..ratio };
        assert_eq!(Saving { ratio: narrow, floor: 0.01 }.verdict(), Verdict::Saves);
    }

    #[test]
    fn what_is_slower_without_is_a_loss() {
        let loss = saving(12.0, 10.0, 0.01);
        assert!(loss.is_loss() && loss.percent() < 0.0);
        assert_eq!(loss.words(), "takes 20.0 % longer (20.0 to 20.0)");
        assert!(saving(10.05, 10.0, 0.01).is_noise());
    }
}

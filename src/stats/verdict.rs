//! What may be said of a ratio: not whether two things differ (any two do), but whether by more
//! than matters and more than the machine can tell.

use super::{Ratio, binomial_half, holm};

/// What is said of one thing against another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Takes less time, by more than the margin.
    Faster,
    /// Takes more time, by more than the margin.
    Slower,
    /// The whole interval lies within the margin: shown to be equivalent, which is more than not
    /// shown to be different.
    Same,
    /// The data decide neither.
    Unresolved {
        /// About how many more rounds would; `None` if the ratio lies on the margin itself.
        more_rounds: Option<u64>,
    },
}

impl Verdict {
    /// The word in the column `verdict`.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Faster => "faster",
            Verdict::Slower => "slower",
            Verdict::Same => "same",
            Verdict::Unresolved { .. } => "unresolved",
        }
    }
}

/// A verdict with the probability behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision {
    /// What is said.
    pub verdict: Verdict,
    /// Probability of as many rounds beyond the margin if the true ratio is not beyond it, for
    /// the whole family: saying so errs anywhere in it with at most this.
    pub p_value: f64,
}

/// Largest [`Decision::p_value`] that makes a difference.
pub const LEVEL: f64 = 0.05;

/// Judges a family of comparisons at once. Each is its paired ratio and the log ratios of the
/// rounds that it was made from; `margin` is a relative difference, > 0, that nobody cares about
/// or nobody could see. `None` when a log ratio is not finite, a family member has no round, or
/// the margin is not positive.
///
/// Different: the sign test of "the median is at most the margin away from 1", both sides, Holm
/// over the family, at [`LEVEL`]. Same: the exact interval of the ratio lies inside of the margin
/// (two one-sided tests). So no ratio can be both.
pub fn decide(family: &[(Ratio, Vec<f64>)], margin: f64) -> Option<Vec<Decision>> {
    if !(margin > 0.0 && margin.is_finite()) {
        return None;
    }
    let edge = margin.ln_1p();
    let p_values: Option<Vec<f64>> =
        family.iter().map(|(_, logs)| beyond(logs, edge).map(|(p, _)| p)).collect();
    let adjusted = holm(&p_values?)?;
    let one = |((ratio, logs), p_value): (&(Ratio, Vec<f64>), f64)| {
        let (_, slower) = beyond(logs, edge)?;
        let verdict = if p_value <= LEVEL {
            if slower { Verdict::Slower } else { Verdict::Faster }
        } else if ratio.high.ln() <= edge && ratio.low.ln() >= -edge {
            Verdict::Same
        } else {
            Verdict::Unresolved { more_rounds: more_rounds(ratio, logs.len(), edge) }
        };
        Some(Decision { verdict, p_value })
    };
    family.iter().zip(adjusted).map(one).collect()
}

/// Two-sided p-value of "the median lies within `edge` of 0", and whether it is above that it
/// would lie. A tie with the edge counts against a difference.
fn beyond(logs: &[f64], edge: f64) -> Option<(f64, bool)> {
    if logs.is_empty() || !logs.iter().all(|log| log.is_finite()) {
        return None;
    }
    let not_above = logs.iter().filter(|&&log| log <= edge).count();
    let not_below = logs.iter().filter(|&&log| log >= -edge).count();
    let tail = binomial_half(not_above.min(not_below), logs.len());
    Some((f64::min(2.0 * tail, 1.0), not_above < not_below))
}

/// Rounds that are missing until the interval, which narrows with the root of their number, no
/// longer contains the nearer edge of the margin.
fn more_rounds(ratio: &Ratio, rounds: usize, edge: f64) -> Option<u64> {
    let half_width = (ratio.high.ln() - ratio.low.ln()) / 2.0;
    let gap = (ratio.estimate.ln().abs() - edge).abs();
    let times = (half_width / gap).powi(2);
    // The interval is not symmetric: it may touch the edge although half of it does not reach so
    // far. A quarter more is the least that is worth asking for.
    let more = rounds as f64 * (times - 1.0).max(0.25);
    (more.is_finite() && more < 1e9).then_some(more.ceil() as u64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stats::paired_ratio;
    use rand::{Rng, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    fn member(logs: &[f64]) -> (Ratio, Vec<f64>) {
        let above: Vec<f64> = logs.iter().map(|log| log.exp()).collect();
        let ratio = paired_ratio(&above, &vec![1.0; logs.len()]).expect("6 or more");
        (ratio, logs.to_vec())
    }

    /// `rounds` values around `middle`, evenly spread by `spread` to both sides.
    fn around(middle: f64, spread: f64, rounds: usize) -> Vec<f64> {
        let step = |i: usize| (2.0 * i as f64 / (rounds - 1) as f64 - 1.0) * spread;
        (0..rounds).map(|i| middle + step(i)).collect()
    }

    fn words(family: &[Vec<f64>], margin: f64) -> Vec<&'static str> {
        let family: Vec<_> = family.iter().map(|logs| member(logs)).collect();
        let decisions = decide(&family, margin).expect("can be judged");
        decisions.iter().map(|decision| decision.verdict.word()).collect()
    }

    #[test]
    fn every_verdict_is_reached() {
        let family = [
            around(0.05, 0.01, 64),
            around(-0.05, 0.01, 64),
            around(0.002, 0.01, 64),
            around(0.009, 0.02, 64),
        ];
        assert_eq!(words(&family, 0.01), ["slower", "faster", "same", "unresolved"]);
    }

    #[test]
    fn swapping_sides_swaps_faster_and_slower() {
        let family = [around(0.05, 0.03, 32), around(0.0, 0.004, 32), around(-0.02, 0.03, 32)];
        let mirrored: Vec<Vec<f64>> =
            family.iter().map(|logs| logs.iter().map(|log| -log).collect()).collect();
        let swapped = words(&mirrored, 0.01).into_iter().map(|word| match word {
            "faster" => "slower",
            "slower" => "faster",
            other => other,
        });
        assert_eq!(words(&family, 0.01), swapped.collect::<Vec<_>>());
    }

    #[test]
    fn a_larger_family_asks_for_more() {
        // 8 of 8 beyond the margin: p = 2/256 for one, ten times that for ten.
        let alone = [vec![0.05; 8]];
        assert_eq!(words(&alone, 0.01), ["slower"]);
        let ten = vec![vec![0.05; 8]; 10];
        assert!(words(&ten, 0.01).iter().all(|word| *word == "unresolved"));
    }

    #[test]
    fn the_rounds_asked_for_would_decide() {
        let logs = around(0.015, 0.06, 64);
        let [Decision { verdict: Verdict::Unresolved { more_rounds: Some(more) }, .. }] =
            decide(&[member(&logs)], 0.01).expect("can be judged")[..]
        else {
            panic!("unresolved is expected")
        };
        let enough = around(0.015, 0.06, 64 + 2 * more as usize);
        assert_eq!(words(&[enough], 0.01), ["slower"]);
        assert!(more > 64, "{more}");
    }

    #[test]
    fn what_cannot_be_judged() {
        let good = member(&[0.0; 8]);
        assert!(decide(std::slice::from_ref(&good), 0.0).is_none());
        assert!(decide(std::slice::from_ref(&good), f64::NAN).is_none());
        assert!(decide(&[(good.0, vec![])], 0.01).is_none());
        assert!(decide(&[(good.0, vec![f64::NAN; 8])], 0.01).is_none());
        assert_eq!(decide(&[], 0.01), Some(vec![]));
    }

    /// Log ratios with the heavy right tail of a shared machine: mostly narrow, one in ten far out.
    fn skewed(rng: &mut Pcg64Mcg, median: f64) -> f64 {
        let uniform = |rng: &mut Pcg64Mcg| (rng.next_u64() >> 11) as f64 * (-53f64).exp2();
        let sign = if rng.next_u64() & 1 == 0 { -1.0 } else { 1.0 };
        let scale = if sign > 0.0 && uniform(rng) < 0.2 { 0.5 } else { 0.005 };
        median + sign * uniform(rng) * scale
    }

    #[test]
    fn intervals_cover_and_verdicts_err_as_rarely_as_they_say() {
        let mut rng = Pcg64Mcg::seed_from_u64(20_261_122);
        let (trials, rounds) = (4000, 64);
        let (mut covered, mut different, mut found) = (0, 0, 0);
        for _ in 0..trials {
            let mut at = |median: f64| -> Vec<f64> {
                (0..rounds).map(|_| skewed(&mut rng, median)).collect()
            };
            let null = member(&at(0.01f64.ln_1p()));
            covered += usize::from(null.0.contains(1.01));
            // The worst case that is no difference: the true ratio on the margin itself.
            let decision = decide(&[null], 0.01).expect("can be judged")[0];
            different += usize::from(decision.verdict == Verdict::Slower);
            let slower = decide(&[member(&at(0.02f64.ln_1p()))], 0.01).expect("can be judged")[0];
            found += usize::from(slower.verdict == Verdict::Slower);
        }
        // The exact probabilities for 64 rounds, ranks 24 and 41, are 96.71 % and 1.64 %; the
        // standard errors of 4000 trials are 0.28 and 0.20 of a per cent: five of them each.
        assert!((0.9531..=0.9811).contains(&(covered as f64 / trials as f64)), "{covered}");
        assert!(different as f64 / trials as f64 <= 0.0264, "{different}");
        assert!(found as f64 / trials as f64 > 0.95, "{found}");
    }
}

//! The sign test and the interval for a median that it inverts to.
//!
//! Exact for every continuous distribution, and for ties conservative: Conover, Practical
//! Nonparametric Statistics, 3rd ed., sections 3.2 (quantile interval) and 3.4 (sign test).

use super::median::sorted;
use serde::{Deserialize, Serialize};

/// Least probability with which an interval of this module covers the true median.
pub const CONFIDENCE: f64 = 0.95;

/// A closed interval, in the unit of the values that it was made from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Interval {
    /// Whether `value` lies in the interval, ends included.
    pub fn contains(&self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }
}

/// P(X <= `k`) for X binomial with `n` trials of probability one half.
pub fn binomial_half(k: usize, n: usize) -> f64 {
    if k >= n {
        return 1.0;
    }
    // In logarithms: 2^-n alone is zero beyond n = 1074.
    let mut ln_term = -(n as f64) * std::f64::consts::LN_2;
    let mut sum = 0.0;
    for i in 0..=k {
        sum += ln_term.exp();
        ln_term += ((n - i) as f64 / (i + 1) as f64).ln();
    }
    f64::min(sum, 1.0)
}

/// The interval from the r-th smallest to the r-th largest value, r as large as [`CONFIDENCE`]
/// allows: P(X < r) <= 2.5 %. `None` below 6 values (5 cover with 93.75 % only) or when one is
/// not finite.
pub fn sign_interval(values: &[f64]) -> Option<Interval> {
    let sorted = sorted(values)?;
    let rank = lower_rank(sorted.len())?;
    Some(Interval { low: sorted[rank - 1], high: sorted[sorted.len() - rank] })
}

/// Two-sided p-value of "the median is `hypothesis`". Ties count on both sides, so that p <= 5 %
/// says exactly the same as "outside of [`sign_interval`]". `None` for an empty slice or when a
/// value is not finite.
pub fn sign_test(values: &[f64], hypothesis: f64) -> Option<f64> {
    if values.is_empty() || !hypothesis.is_finite() || !values.iter().all(|v| v.is_finite()) {
        return None;
    }
    let at_most = values.iter().filter(|&&v| v <= hypothesis).count();
    let at_least = values.iter().filter(|&&v| v >= hypothesis).count();
    let tail = binomial_half(at_most.min(at_least), values.len());
    Some(f64::min(2.0 * tail, 1.0))
}

/// Largest rank r, counted from 1, with 2 P(X < r) <= 1 - confidence.
fn lower_rank(n: usize) -> Option<usize> {
    let tail = (1.0 - CONFIDENCE) / 2.0;
    let mut ln_term = -(n as f64) * std::f64::consts::LN_2;
    let mut sum = 0.0;
    for i in 0..=n / 2 {
        sum += ln_term.exp();
        if sum > tail {
            return (i > 0).then_some(i);
        }
        ln_term += ((n - i) as f64 / (i + 1) as f64).ln();
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ascending(n: usize) -> Vec<f64> {
        (1..=n).map(|i| i as f64).collect()
    }

    #[test]
    fn binomial_by_hand() {
        let close = |a: f64, b: f64| (a - b).abs() < 1e-14;
        assert!(close(binomial_half(0, 6), 1.0 / 64.0));
        assert!(close(binomial_half(1, 10), 11.0 / 1024.0));
        assert!(close(binomial_half(2, 5), 0.5));
        assert_eq!(binomial_half(5, 5), 1.0);
        // 2^-2000 is no f64, yet half of the probability lies below the middle.
        assert!((binomial_half(999, 1999) - 0.5).abs() < 1e-9);
    }

    #[test]
    fn ranks_of_the_printed_tables() {
        let tables =
            [(6, 1), (8, 1), (9, 2), (10, 2), (15, 4), (20, 6), (25, 8), (50, 18), (64, 24)];
        for (n, rank) in tables {
            let found = sign_interval(&ascending(n));
            let wanted = Interval { low: rank as f64, high: (n + 1 - rank) as f64 };
            assert_eq!(found, Some(wanted), "n = {n}");
        }
    }

    #[test]
    fn too_few_values_have_no_interval() {
        for n in 0..6 {
            assert_eq!(sign_interval(&ascending(n)), None, "n = {n}");
        }
        assert_eq!(sign_interval(&[1.0, 2.0, 3.0, 4.0, 5.0, f64::NAN]), None);
    }

    #[test]
    fn interval_does_not_depend_on_the_order() {
        let forward = ascending(31);
        let mut other: Vec<f64> = forward.iter().rev().copied().collect();
        other.rotate_left(7);
        assert_eq!(sign_interval(&forward), sign_interval(&other));
    }

    #[test]
    fn ties_give_a_point() {
        let tied = [3.0; 12];
        assert_eq!(sign_interval(&tied), Some(Interval { low: 3.0, high: 3.0 }));
        assert_eq!(sign_test(&tied, 3.0), Some(1.0));
        assert!(sign_test(&tied, 2.9).is_some_and(|p| p < 0.001));
    }

    #[test]
    fn p_values_by_hand() {
        // 8 of 9 above: 2 (1 + 9) / 512.
        let p = sign_test(&[-1.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0], 0.0);
        assert!(p.is_some_and(|p| (p - 20.0 / 512.0).abs() < 1e-14));
        assert_eq!(sign_test(&[1.0], 0.0), Some(1.0));
        assert_eq!(sign_test(&[], 0.0), None);
        assert_eq!(sign_test(&[f64::NAN], 0.0), None);
    }

    #[test]
    fn interval_is_where_the_test_does_not_reject() {
        let values = [1.0, 2.0, 2.0, 2.0, 3.5, 4.0, 4.0, 6.0, 8.0, 9.0, 9.0, 12.0];
        let interval = sign_interval(&values);
        let mut inside = 0;
        for step in 0..130 {
            let at = f64::from(step) * 0.1;
            let accepted = sign_test(&values, at).is_some_and(|p| p > 0.05);
            assert_eq!(interval.map(|i| i.contains(at)), Some(accepted), "at {at}");
            inside += usize::from(accepted);
        }
        assert!(inside > 10 && inside < 120);
    }
}

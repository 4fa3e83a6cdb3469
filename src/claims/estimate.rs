//! A figure and the interval that it lies in, and arithmetic with both.
//!
//! Intervals are combined by their ends, as if all errors went the worst way at once. That is safe: where
//! the ends are those of a 95 % interval each and errors are about normal, the ends of a sum, and to
//! first order those of any smooth function, contain the true figure with at least 95 %, however
//! the errors depend on each other (standard deviations add at most linearly).

use crate::stats::normal_quantile;

/// A figure and where it lies, in the unit of its column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The figure.
    pub value: f64,
    /// Lower end of its interval; the figure itself where it is exact.
    pub low: f64,
    /// Upper end of it.
    pub high: f64,
}

impl Estimate {
    /// A figure without an error.
    pub fn exact(value: f64) -> Self {
        Estimate { value, low: value, high: value }
    }

    /// Whether there is no error.
    pub fn is_exact(&self) -> bool {
        self.low == self.high
    }

    /// All three finite, and in their order.
    pub fn checked(self) -> Option<Self> {
        let finite = self.low.is_finite() && self.value.is_finite() && self.high.is_finite();
        (finite && self.low <= self.high).then_some(self)
    }

    /// With the ends where they are if `comparisons` intervals are to cover all at once what one covers
    /// with 95 % (Bonferroni; Holm's steps call it with what is left).
    ///
    /// A stored interval is that of a median by the sign test: from one order statistic of the rounds to
    /// another, whose ranks lie as many standard deviations (half the root of the number of rounds) from
    /// the middle as the normal distribution says. Where rounds lie about evenly between those ranks,
    /// which is the assumption, the ends move in proportion to those standard deviations: from the
    /// quantile 1 - 0.025 to that of 1 - 0.025 / comparisons. They may lie evenly themselves, or, as
    /// ratios do, their logarithms; of both the wider interval is taken.
    pub fn corrected(self, comparisons: usize) -> Self {
        if self.is_exact() || comparisons < 2 {
            return self;
        }
        let tail = 0.025;
        let quantile = |tail: f64| normal_quantile(1.0 - tail);
        let (Some(one), Some(all)) = (quantile(tail), quantile(tail / comparisons as f64)) else {
            return self;
        };
        let times = all / one;
        let Estimate { value, low, high } = self;
        let evenly = Estimate {
            value,
            low: value - (value - low) * times,
            high: value + (high - value) * times,
        };
        if low <= 0.0 {
            return evenly;
        }
        // The lower end of the logarithms is the higher one of both.
        Estimate { high: evenly.high.max(value * (high / value).powf(times)), ..evenly }
    }

    /// With the ends moved by a share of themselves, outwards.
    pub fn loosened(self, share: f64) -> Self {
        let Estimate { value, low, high } = self;
        Estimate { value, low: low - share * low.abs(), high: high + share * high.abs() }
    }

    /// The sum.
    pub fn plus(self, other: Self) -> Self {
        Estimate {
            value: self.value + other.value,
            low: self.low + other.low,
            high: self.high + other.high,
        }
    }

    /// With the sign changed.
    pub fn negated(self) -> Self {
        Estimate { value: -self.value, low: -self.high, high: -self.low }
    }

    /// The product.
    pub fn times(self, other: Self) -> Self {
        let ends = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        Estimate {
            value: self.value * other.value,
            low: ends.into_iter().fold(f64::INFINITY, f64::min),
            high: ends.into_iter().fold(f64::NEG_INFINITY, f64::max),
        }
    }

    /// The quotient; `None` where the divisor may be 0.
    pub fn over(self, other: Self) -> Option<Self> {
        if other.low <= 0.0 && other.high >= 0.0 {
            return None;
        }
        let Estimate { value, low, high } = other;
        let inverse = Estimate { value: 1.0 / value, low: 1.0 / high, high: 1.0 / low };
        self.times(inverse).checked().map(|found| {
            // x / y, not x * (1 / y), which rounds twice.
            let value = self.value / other.value;
            Estimate { value, low: found.low.min(value), high: found.high.max(value) }
        })
    }

    /// A function that never falls, of the figure and of its ends; `None` where it has no value.
    pub fn rising(self, function: fn(f64) -> f64) -> Option<Self> {
        let Estimate { value, low, high } = self;
        Estimate { value: function(value), low: function(low), high: function(high) }.checked()
    }

    /// The absolute value.
    pub fn absolute(self) -> Self {
        let Estimate { value, low, high } = self;
        let most = low.abs().max(high.abs());
        let least = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
        Estimate { value: value.abs(), low: least, high: most }
    }

    /// The square: narrower than the product with itself, which does not know that both are one.
    pub fn squared(self) -> Self {
        let size = self.absolute();
        let square = |x: f64| x * x;
        Estimate { value: square(size.value), low: square(size.low), high: square(size.high) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(value: f64, low: f64, high: f64) -> Estimate {
        Estimate { value, low, high }
    }

    #[test]
    fn arithmetic_takes_the_outer_ends() {
        let (a, b) = (of(2.0, 1.0, 3.0), of(4.0, 2.0, 8.0));
        assert_eq!(a.plus(b), of(6.0, 3.0, 11.0));
        assert_eq!(a.plus(b.negated()), of(-2.0, -7.0, 1.0));
        assert_eq!(a.times(b), of(8.0, 2.0, 24.0));
        assert_eq!(a.over(b), Some(of(0.5, 0.125, 1.5)));
        assert_eq!(a.negated().times(b), of(-8.0, -24.0, -2.0));
    }

    #[test]
    fn nothing_is_divided_by_what_may_be_zero() {
        let a = Estimate::exact(1.0);
        for divisor in [of(1.0, 0.0, 2.0), of(0.5, -1.0, 2.0), Estimate::exact(0.0)] {
            assert_eq!(a.over(divisor), None);
        }
        assert_eq!(a.over(of(-2.0, -4.0, -1.0)), Some(of(-0.5, -1.0, -0.25)));
    }

    #[test]
    fn squares_and_absolute_values_know_of_zero() {
        let across = of(1.0, -2.0, 3.0);
        assert_eq!(across.absolute(), of(1.0, 0.0, 3.0));
        assert_eq!(across.squared(), of(1.0, 0.0, 9.0));
        assert_eq!(of(-2.0, -3.0, -1.0).squared(), of(4.0, 1.0, 9.0));
        assert_eq!(across.rising(f64::ln), None);
    }

    #[test]
    fn one_comparison_needs_no_correction_and_two_need_that_of_the_tables() {
        let a = of(10.0, 9.0, 11.0);
        let one = a.corrected(1);
        assert!((one.low - 9.0).abs() < 1e-12 && (one.high - 11.0).abs() < 1e-12);
        // The quantile of 0.9875 is 2.241402728, that of 0.975 1.959963985.
        let times: f64 = 2.241_402_728 / 1.959_963_985;
        let two = a.corrected(2);
        assert!((two.low - (10.0 - times)).abs() < 1e-7, "{two:?}");
        assert!((two.high - 10.0 * 1.1f64.powf(times)).abs() < 1e-7, "{two:?}");
        let across = of(0.0, -1.0, 2.0).corrected(2);
        assert!((across.high - 2.0 * times).abs() < 1e-7 && (across.low + times).abs() < 1e-7);
        assert_eq!(Estimate::exact(3.0).corrected(9), Estimate::exact(3.0));
    }
}

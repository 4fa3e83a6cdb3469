//! Sums and quantiles that do not depend on the order in which values came.

/// What half, one in a hundred and one in a thousand of the values exceed, and the largest. `None`
/// without values.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quantiles {
    /// The median.
    pub p50: Option<f64>,
    /// One value in a hundred is above it.
    pub p99: Option<f64>,
    /// One value in a thousand is above it.
    pub p999: Option<f64>,
    /// The largest.
    pub max: Option<f64>,
}

/// Values in rising order.
pub(super) struct Sorted(Vec<f64>);

impl Sorted {
    pub fn new(mut values: Vec<f64>) -> Self {
        // Equal values are equal bits (but for zeros, which sort by sign), so that any sort of the
        // same values gives the same list.
        values.sort_unstable_by(f64::total_cmp);
        Sorted(values)
    }

    /// The mean, summed from the smallest on: the same whatever order the values came in.
    pub fn mean(&self) -> Option<f64> {
        let count = self.0.len();
        (count > 0).then(|| self.0.iter().sum::<f64>() / count as f64)
    }

    pub fn max(&self) -> Option<f64> {
        self.0.last().copied()
    }

    /// The value of rank `share` (0 the smallest, 1 the largest), to the nearest rank.
    fn quantile(&self, share: f64) -> Option<f64> {
        let last = self.0.len().checked_sub(1)?;
        self.0.get((last as f64 * share).round() as usize).copied()
    }

    pub fn quantiles(&self) -> Quantiles {
        Quantiles {
            p50: self.quantile(0.5),
            p99: self.quantile(0.99),
            p999: self.quantile(0.999),
            max: self.max(),
        }
    }
}

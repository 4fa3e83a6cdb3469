//! Where the values of many triangles lie.

use serde::Serialize;

/// Quantiles by nearest rank: each is one of the values. `None` where there is no value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Quantiles {
    /// The smallest.
    pub smallest: Option<f64>,
    /// 1 % are no larger.
    pub p01: Option<f64>,
    /// Half are no larger.
    pub median: Option<f64>,
    /// 99 % are no larger.
    pub p99: Option<f64>,
    /// The largest.
    pub largest: Option<f64>,
}

impl Quantiles {
    /// Of finite values, in any order.
    pub fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let rank = |share: f64| {
            let rank = (share * values.len() as f64).ceil() as usize;
            values.get(rank.max(1) - 1).copied()
        };
        Quantiles {
            smallest: values.first().copied(),
            p01: rank(0.01),
            median: rank(0.5),
            p99: rank(0.99),
            largest: values.last().copied(),
        }
    }
}

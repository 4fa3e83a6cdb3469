//! From how many rays per triangle on it pays to prepare more.

use crate::table::Row;

/// A cost, and where it lies with confidence.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// The median.
    pub median: f64,
    /// Lower end of its interval.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Cost {
    /// Of a test, in cycles, as a row has it.
    pub fn of_test(row: &Row) -> Option<Self> {
        Some(Cost { median: row.cycles_per_test?, low: row.cycles_low?, high: row.cycles_high? })
    }

    /// Of preparing a triangle, in cycles. What is stored as it comes is not prepared: nothing.
    pub fn of_preparing(row: &Row) -> Option<Self> {
        if row.stored == "vertices" {
            return Some(Cost::default());
        }
        Some(Cost {
            median: row.prepare_cycles_per_triangle?,
            low: row.prepare_cycles_low?,
            high: row.prepare_cycles_high?,
        })
    }

    /// This and so many times the other.
    pub fn plus(self, times: f64, other: Cost) -> Self {
        Cost {
            median: self.median + times * other.median,
            low: self.low + times * other.low,
            high: self.high + times * other.high,
        }
    }

    /// How much more this is than the other.
    fn over(self, other: Cost) -> Self {
        Cost {
            median: self.median - other.median,
            low: self.low - other.high,
            high: self.high - other.low,
        }
    }
}

/// What a form costs per triangle, once and for every ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// Preparing a triangle.
    pub prepare: Cost,
    /// Testing it against a ray.
    pub test: Cost,
}

/// From how many rays per triangle on a form costs less than another; not rounded to whole rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// By the medians.
    pub rays: f64,
    /// With every cost at the end of its interval that is best for it.
    pub low: f64,
    /// With every cost at the worst end; `None` where its test is not surely the faster one.
    pub high: Option<f64>,
}

/// Where prepare + rays x test of `own` falls below that of `other`. `None` where the test is no
/// faster: it never does, however many rays there are.
pub fn crossing(own: Costs, other: Costs) -> Option<Crossing> {
    let (more, gain) = (own.prepare.over(other.prepare), other.test.over(own.test));
    if gain.median <= 0.0 {
        return None;
    }
    let rays = |more: f64, gain: f64| more.max(0.0) / gain;
    Some(Crossing {
        rays: rays(more.median, gain.median),
        low: rays(more.low, gain.high),
        high: (gain.low > 0.0).then(|| rays(more.high, gain.low)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cost(median: f64, margin: f64) -> Cost {
        Cost { median, low: median - margin, high: median + margin }
    }

    fn costs(prepare: Cost, test: Cost) -> Costs {
        Costs { prepare, test }
    }

    #[test]
    fn the_crossing_is_what_preparing_costs_over_what_a_ray_saves() {
        let other = costs(cost(0.0, 0.0), cost(20.0, 1.0));
        let own = costs(cost(40.0, 4.0), cost(12.0, 1.0));
        // 40 / 8; 36 / 10 and 44 / 6 at best and at worst.
        let wanted = Crossing { rays: 5.0, low: 3.6, high: Some(44.0 / 6.0) };
        assert_eq!(crossing(own, other), Some(wanted));
    }

    #[test]
    fn both_preparations_count() {
        let other = costs(cost(10.0, 0.0), cost(20.0, 0.0));
        let own = costs(cost(40.0, 0.0), cost(10.0, 0.0));
        assert_eq!(crossing(own, other).map(|crossing| crossing.rays), Some(3.0));
        // What prepares less and tests faster pays at once.
        let own = costs(cost(5.0, 0.0), cost(10.0, 0.0));
        assert_eq!(crossing(own, other).map(|crossing| crossing.rays), Some(0.0));
    }

    #[test]
    fn a_test_that_is_no_faster_never_pays() {
        let other = costs(cost(0.0, 0.0), cost(20.0, 1.0));
        assert_eq!(crossing(costs(cost(9.0, 1.0), cost(20.0, 1.0)), other), None);
        assert_eq!(crossing(costs(cost(9.0, 1.0), cost(25.0, 1.0)), other), None);
    }

    #[test]
    fn a_test_that_may_be_no_faster_has_no_upper_end() {
        let other = costs(cost(0.0, 0.0), cost(20.0, 1.0));
        let found = crossing(costs(cost(9.0, 1.0), cost(19.0, 1.0)), other);
        // 9 / 1, at best 8 / 3.
        assert_eq!(found, Some(Crossing { rays: 9.0, low: 8.0 / 3.0, high: None }));
    }

    #[test]
    fn at_the_crossing_both_cost_the_same() {
        let other = costs(cost(0.0, 0.0), cost(17.0, 1.0));
        let own = costs(cost(51.0, 4.0), cost(13.0, 1.0));
        let rays = crossing(own, other).expect("the test is faster").rays;
        let total = |costs: Costs| costs.prepare.plus(rays, costs.test).median;
        assert_eq!((rays, total(own)), (12.75, total(other)));
    }
}

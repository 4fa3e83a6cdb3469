//! What a figure is held against.

use super::claim::Part;
use super::estimate::Estimate;
use super::words::shown;

/// Where a figure must lie.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Bound {
    /// Nowhere in particular; no part that was read has this.
    #[default]
    None,
    /// Less than this.
    Below(f64),
    /// More than this.
    Above(f64),
    /// This or more.
    AtLeast(f64),
    /// This or less.
    AtMost(f64),
    /// From the first to the second.
    Between(f64, f64),
}

/// Whether an interval lies on the right side of a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// All of it.
    Right,
    /// None of it.
    Wrong,
    /// A part of it.
    Both,
}

impl Bound {
    /// The bound of a part; `None` unless exactly one is given, and in order.
    pub fn of(part: &Part) -> Option<Self> {
        let given = [
            part.below.map(Bound::Below),
            part.above.map(Bound::Above),
            part.at_least.map(Bound::AtLeast),
            part.at_most.map(Bound::AtMost),
            part.equals.map(|at| Bound::Between(at, at)),
            part.between.map(|[low, high]| Bound::Between(low, high)),
        ];
        let mut given = given.into_iter().flatten();
        let one = given.next()?;
        let in_order = !matches!(one, Bound::Between(low, high) if low > high);
        (given.next().is_none() && in_order).then_some(one)
    }

    /// On which side a figure's interval lies.
    pub fn side(self, found: &Estimate) -> Side {
        let Estimate { low, high, .. } = *found;
        let (right, wrong) = match self {
            Bound::None => (false, false),
            Bound::Below(bound) => (high < bound, low >= bound),
            Bound::Above(bound) => (low > bound, high <= bound),
            Bound::AtLeast(bound) => (low >= bound, high < bound),
            Bound::AtMost(bound) => (high <= bound, low > bound),
            Bound::Between(least, most) => {
                (low >= least && high <= most, high < least || low > most)
            }
        };
        match (right, wrong) {
            (true, _) => Side::Right,
            (_, true) => Side::Wrong,
            _ => Side::Both,
        }
    }

    /// How far a figure is from failing, in units of the bound (of 1 where that is 0); negative
    /// where it fails.
    pub fn distance(self, value: f64) -> f64 {
        let unit = |bound: f64| if bound == 0.0 { 1.0 } else { bound.abs() };
        match self {
            Bound::None => 0.0,
            Bound::Below(bound) | Bound::AtMost(bound) => (bound - value) / unit(bound),
            Bound::Above(bound) | Bound::AtLeast(bound) => (value - bound) / unit(bound),
            Bound::Between(least, most) => {
                ((value - least) / unit(least)).min((most - value) / unit(most))
            }
        }
    }

    /// How many times its own half-width a figure is away from the bound: the larger, the more
    /// decided it is.
    pub fn decidedness(self, found: &Estimate) -> f64 {
        let Estimate { value, low, high } = *found;
        let away = |bound: f64| {
            let half = if value > bound { value - low } else { high - value };
            let distance = (value - bound).abs();
            if half > 0.0 { distance / half } else { f64::INFINITY }
        };
        match self {
            Bound::None => 0.0,
            Bound::Below(bound)
            | Bound::AtMost(bound)
            | Bound::Above(bound)
            | Bound::AtLeast(bound) => away(bound),
            Bound::Between(least, most) => away(least).min(away(most)),
        }
    }

    /// In words, behind "is".
    pub fn words(self) -> String {
        match self {
            Bound::None => "anything".to_owned(),
            Bound::Below(bound) => format!("below {}", shown(bound)),
            Bound::Above(bound) => format!("above {}", shown(bound)),
            Bound::AtLeast(bound) => format!("at least {}", shown(bound)),
            Bound::AtMost(bound) => format!("at most {}", shown(bound)),
            Bound::Between(least, most) if least == most => shown(least),
            Bound::Between(least, most) => format!("from {} to {}", shown(least), shown(most)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn side(bound: Bound, low: f64, high: f64) -> Side {
        bound.side(&Estimate { value: f64::midpoint(low, high), low, high })
    }

    #[test]
    fn ends_belong_where_the_word_says() {
        assert_eq!(side(Bound::Below(1.0), 0.5, 0.9), Side::Right);
        assert_eq!(side(Bound::Below(1.0), 0.5, 1.0), Side::Both);
        assert_eq!(side(Bound::Below(1.0), 1.0, 1.5), Side::Wrong);
        assert_eq!(side(Bound::AtMost(1.0), 0.5, 1.0), Side::Right);
        assert_eq!(side(Bound::AtMost(1.0), 1.0, 1.5), Side::Both);
        assert_eq!(side(Bound::Above(1.0), 0.5, 1.0), Side::Wrong);
        assert_eq!(side(Bound::AtLeast(1.0), 1.0, 1.0), Side::Right);
        assert_eq!(side(Bound::AtLeast(1.0), 0.5, 1.0), Side::Both);
        let between = Bound::Between(1.0, 2.0);
        assert_eq!(side(between, 1.0, 2.0), Side::Right);
        assert_eq!(side(between, 0.9, 1.5), Side::Both);
        assert_eq!(side(between, 0.5, 3.0), Side::Both);
        assert_eq!(side(between, 2.1, 3.0), Side::Wrong);
    }

    #[test]
    fn distances_are_in_units_of_the_bound() {
        assert_eq!(Bound::Below(2.0).distance(1.0), 0.5);
        assert_eq!(Bound::Above(2.0).distance(1.0), -0.5);
        assert_eq!(Bound::AtMost(0.0).distance(3.0), -3.0);
        assert_eq!(Bound::Between(1.0, 4.0).distance(3.0), 0.25);
    }

    #[test]
    fn the_interval_towards_the_bound_counts() {
        let found = Estimate { value: 2.0, low: 1.5, high: 6.0 };
        assert_eq!(Bound::Above(1.0).decidedness(&found), 2.0);
        assert_eq!(Bound::Below(4.0).decidedness(&found), 0.5);
        assert_eq!(Bound::Below(4.0).decidedness(&Estimate::exact(2.0)), f64::INFINITY);
    }
}

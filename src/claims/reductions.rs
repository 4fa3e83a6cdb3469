//! One figure of several.

use super::estimate::Estimate;
use super::lack::Lack;
use crate::stats;

type Reduced = Result<Estimate, Lack>;

fn finite(found: Estimate, name: &str) -> Reduced {
    found.checked().ok_or_else(|| Lack::new(format!("{name} has no finite value")))
}

/// A function that falls in no figure, of the figures, of their lower and of their upper ends.
fn by_ends(figures: &[Estimate], name: &str, function: impl Fn(&[f64]) -> f64) -> Reduced {
    let of = |end: fn(&Estimate) -> f64| function(&figures.iter().map(end).collect::<Vec<_>>());
    finite(Estimate { value: of(|f| f.value), low: of(|f| f.low), high: of(|f| f.high) }, name)
}

/// The sum.
pub fn sum(figures: &[Estimate]) -> Reduced {
    by_ends(figures, "sum", |ends| ends.iter().sum())
}

/// The arithmetic mean.
pub fn mean(figures: &[Estimate]) -> Reduced {
    by_ends(figures, "mean", |ends| ends.iter().sum::<f64>() / ends.len() as f64)
}

/// The geometric mean of positive figures.
pub fn geomean(figures: &[Estimate]) -> Reduced {
    let logs: Option<Vec<Estimate>> = figures.iter().map(|figure| figure.rising(f64::ln)).collect();
    let logs = logs.ok_or_else(|| Lack::new("geomean: a figure may not be positive"))?;
    finite(mean(&logs)?.rising(f64::exp).unwrap_or(Estimate::exact(f64::NAN)), "geomean")
}

/// The smallest.
pub fn min(figures: &[Estimate]) -> Reduced {
    by_ends(figures, "min", |ends| ends.iter().copied().fold(f64::INFINITY, f64::min))
}

/// The largest.
pub fn max(figures: &[Estimate]) -> Reduced {
    by_ends(figures, "max", |ends| ends.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

/// The median.
pub fn median(figures: &[Estimate]) -> Reduced {
    by_ends(figures, "median", |ends| stats::median(ends).unwrap_or(f64::NAN))
}

/// The largest over the smallest. At least 1, whatever the intervals.
pub fn spread(figures: &[Estimate]) -> Reduced {
    if figures.len() < 2 {
        return Err(Lack::new("the spread of one figure says nothing; two or more are needed"));
    }
    let found = max(figures)?.over(min(figures)?);
    let found = found.ok_or_else(|| Lack::new("spread: the smallest figure may be 0"))?;
    Ok(Estimate { low: found.low.max(1.0), high: found.high.max(1.0), ..found })
}

/// The slope of the straight line of least squares over `x`; it is linear in every figure.
pub fn slope(x: &[f64], figures: &[Estimate]) -> Reduced {
    let middle = x.iter().sum::<f64>() / x.len() as f64;
    let square: f64 = x.iter().map(|x| (x - middle) * (x - middle)).sum();
    if square <= 0.0 || !square.is_finite() {
        return Err(Lack::new("a straight line needs figures at two places or more"));
    }
    let parts = x.iter().zip(figures).map(|(x, figure)| {
        let weight = (x - middle) / square;
        figure.times(Estimate::exact(weight))
    });
    finite(parts.fold(Estimate::exact(0.0), Estimate::plus), "slope")
}

/// Rank correlation (Spearman, mean ranks for ties) of exact figures with others. Its ends are the least
/// and the largest of all orders that the intervals allow, so there may be eight figures at the most.
pub fn spearman(exact: &[Estimate], figures: &[Estimate]) -> Reduced {
    const MOST: usize = 8;
    let count = figures.len();
    if !(2..=MOST).contains(&count) || exact.iter().any(|figure| !figure.is_exact()) {
        let words = format!("spearman takes 2 to {MOST} exact figures first, then as many others");
        return Err(Lack::new(words));
    }
    let ranks = ranks(&exact.iter().map(|figure| figure.value).collect::<Vec<_>>());
    let values: Vec<f64> = figures.iter().map(|figure| figure.value).collect();
    let value = correlation(&ranks, &self::ranks(&values));
    let (mut low, mut high) = (value, value);
    each_order(figures, &mut Vec::new(), &mut |order| {
        let mut place = vec![0.0; count];
        order.iter().enumerate().for_each(|(rank, &index)| place[index] = rank as f64);
        let found = correlation(&ranks, &place);
        low = low.min(found);
        high = high.max(found);
    });
    finite(Estimate { value, low, high }, "spearman")
}

/// Calls `found` with every ascending order that is possible within the intervals.
fn each_order(figures: &[Estimate], order: &mut Vec<usize>, found: &mut impl FnMut(&[usize])) {
    if order.len() == figures.len() {
        return found(order);
    }
    for next in 0..figures.len() {
        let left = |other: &usize| !order.contains(other) && *other != next;
        // Nothing that is left may surely be smaller.
        let smallest =
            (0..figures.len()).filter(left).all(|other| figures[other].high >= figures[next].low);
        if !order.contains(&next) && smallest {
            order.push(next);
            each_order(figures, order, found);
            order.pop();
        }
    }
}

/// Ranks from 0, the mean of their ranks for equal values.
fn ranks(values: &[f64]) -> Vec<f64> {
    let below = |value: &f64| values.iter().filter(|other| *other < value).count() as f64;
    let equal = |value: &f64| values.iter().filter(|other| *other == value).count() as f64;
    values.iter().map(|value| below(value) + (equal(value) - 1.0) / 2.0).collect()
}

/// Correlation of two lists of ranks; of equal lists exactly 1, since sums of halves are exact.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let middle = (a.len() as f64 - 1.0) / 2.0;
    let product = |a: &[f64], b: &[f64]| -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - middle) * (b - middle)).sum()
    };
    let (both, one, other) = (product(a, b), product(a, a), product(b, b));
    if one == other { both / one } else { both / (one * other).sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(value: f64, low: f64, high: f64) -> Estimate {
        Estimate { value, low, high }
    }

    fn exact(values: &[f64]) -> Vec<Estimate> {
        values.iter().copied().map(Estimate::exact).collect()
    }

    #[test]
    fn ends_follow_the_ends() {
        let figures = [of(1.0, 0.5, 4.0), of(2.0, 1.0, 3.0), of(6.0, 6.0, 6.0)];
        assert_eq!(mean(&figures), Ok(of(3.0, 2.5, 13.0 / 3.0)));
        assert_eq!(min(&figures), Ok(of(1.0, 0.5, 3.0)));
        assert_eq!(max(&figures), Ok(of(6.0, 6.0, 6.0)));
        assert_eq!(median(&figures), Ok(of(2.0, 1.0, 4.0)));
        assert_eq!(spread(&figures), Ok(of(6.0, 2.0, 12.0)));
        assert!(spread(&figures[..1]).is_err());
        let two = geomean(&exact(&[2.0, 8.0])).expect("positive");
        assert!((two.value - 4.0).abs() < 1e-12);
        assert!(geomean(&[of(1.0, 0.0, 2.0)]).is_err());
    }

    #[test]
    fn the_slope_of_a_line_is_its_own_and_errors_add_up() {
        let figures = [of(1.0, 0.0, 2.0), of(3.0, 3.0, 3.0), of(5.0, 4.0, 6.0)];
        assert_eq!(slope(&[0.0, 1.0, 2.0], &figures), Ok(of(2.0, 1.0, 3.0)));
        assert!(slope(&[1.0, 1.0], &figures[..2]).is_err());
    }

    #[test]
    fn ranks_correlate_as_printed_in_textbooks() {
        // 1 - 6 * (1 + 1 + 0 + 1 + 1) / (5 * 24) = 0.8.
        let found =
            spearman(&exact(&[1.0, 2.0, 3.0, 4.0, 5.0]), &exact(&[2.0, 1.0, 3.0, 5.0, 4.0]));
        assert!(found.is_ok_and(|rho| (rho.value - 0.8).abs() < 1e-15 && rho.is_exact()));
        let same = spearman(&exact(&[3.0, 1.0, 2.0]), &exact(&[30.0, 10.0, 20.0]));
        assert_eq!(same, Ok(Estimate::exact(1.0)));
        assert!(spearman(&exact(&[1.0; 9]), &exact(&[1.0; 9])).is_err());
        assert!(spearman(&[of(1.0, 0.0, 2.0), of(3.0, 3.0, 3.0)], &exact(&[1.0, 2.0])).is_err());
    }

    #[test]
    fn intervals_that_overlap_leave_several_orders() {
        let figures = [of(1.0, 0.0, 2.5), of(2.0, 1.5, 3.0), of(9.0, 8.0, 10.0)];
        // 1 2 3, or 2 1 3: 1 - 6 * 2 / 24.
        assert_eq!(spearman(&exact(&[1.0, 2.0, 3.0]), &figures), Ok(of(1.0, 0.5, 1.0)));
    }
}

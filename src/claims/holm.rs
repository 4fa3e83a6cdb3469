//! Several figures against their bounds, with intervals that are corrected for their number.

use super::bound::{Bound, Side};
use super::estimate::Estimate;

/// A figure with the side of its bound that it lies on.
pub type Judged = (Estimate, Side);

/// A figure and its bound.
pub struct Member<F> {
    /// The bound.
    pub bound: Bound,
    /// Whether nothing in it was left to chance; such a figure takes no part in the count.
    pub exact: bool,
    /// The figure, with its intervals corrected for so many comparisons.
    pub figure: F,
}

/// Judges figures against their bounds by Holm's steps: the one that is the most decided must be so with
/// an interval that is corrected for all of them, the next one for one less. From the first on
/// that is not decided, none is, and all are shown with its correction. So the chance that any
/// figure is called decided by accident stays that of one interval.
pub fn judge<F: Fn(usize) -> Estimate>(family: &[Member<F>]) -> Vec<Judged> {
    let alone: Vec<Estimate> = family.iter().map(|member| (member.figure)(1)).collect();
    let side = |at: usize, found: &Estimate| family[at].bound.side(found);
    let mut judged: Vec<Judged> =
        alone.iter().enumerate().map(|(at, found)| (*found, side(at, found))).collect();
    let mut order: Vec<usize> = (0..family.len()).filter(|&at| !family[at].exact).collect();
    let decidedness = |at: usize| family[at].bound.decidedness(&alone[at]);
    // Stable: equal ones stay in the order of the claim.
    order.sort_by(|&a, &b| decidedness(b).total_cmp(&decidedness(a)));
    let mut comparisons = order.len();
    let mut stopped = false;
    for at in order {
        let found = (family[at].figure)(comparisons);
        let side = side(at, &found);
        stopped |= side == Side::Both;
        // Even if this correction decides it: it comes behind one that is not decided.
        judged[at] = (found, if stopped { Side::Both } else { side });
        if !stopped {
            comparisons -= 1;
        }
    }
    judged
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half-widths of `half` around `value`, corrected.
    fn figure(value: f64, half: f64) -> impl Fn(usize) -> Estimate {
        move |comparisons| {
            Estimate { value, low: value - half, high: value + half }.corrected(comparisons)
        }
    }

    fn sides(values: &[(f64, f64)]) -> Vec<Side> {
        let member = |(value, half): &(f64, f64)| Member {
            bound: Bound::Above(0.0),
            exact: *half == 0.0,
            figure: figure(*value, *half),
        };
        judge(&values.iter().map(member).collect::<Vec<_>>())
            .into_iter()
            .map(|(_, side)| side)
            .collect()
    }

    #[test]
    fn one_figure_is_judged_as_it_is() {
        assert_eq!(sides(&[(1.0, 0.99)]), [Side::Right]);
        assert_eq!(sides(&[(-1.0, 0.99)]), [Side::Wrong]);
        assert_eq!(sides(&[(1.0, 1.01)]), [Side::Both]);
    }

    #[test]
    fn the_most_decided_carries_the_largest_correction() {
        // With two, the first needs 2.2414 / 1.96 = 1.1436 half-widths, the second one.
        assert_eq!(sides(&[(1.0, 0.99), (1.2, 1.0)]), [Side::Right, Side::Right]);
        assert_eq!(sides(&[(1.0, 0.99), (1.1, 1.0)]), [Side::Both, Side::Both]);
    }

    #[test]
    fn exact_figures_cost_nothing() {
        let found = sides(&[(1.0, 0.99), (1.0, 0.0), (-1.0, 0.0)]);
        assert_eq!(found, [Side::Right, Side::Right, Side::Wrong]);
    }

    #[test]
    fn the_shown_interval_is_the_corrected_one() {
        let member =
            |value| Member { bound: Bound::Above(0.0), exact: false, figure: figure(value, 1.0) };
        let found = judge(&[member(9.0), member(5.0)]);
        assert!(found[0].0.low < 8.0 && found[0].1 == Side::Right);
        assert!((found[1].0.low - 4.0).abs() < 1e-9);
    }
}

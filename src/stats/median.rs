//! The median.

/// The median of `values` (any unit): the middle one, or the mean of the two middle ones.
/// `None` for an empty slice or when a value is not finite.
pub fn median(values: &[f64]) -> Option<f64> {
    let sorted = sorted(values)?;
    let half = sorted.len() / 2;
    match sorted.len() {
        0 => None,
        n if n % 2 == 1 => Some(sorted[half]),
        // Halved before the sum: two values near the largest number do not overflow.
        _ => Some(sorted[half - 1] * 0.5 + sorted[half] * 0.5),
    }
}

/// The values in ascending order; `None` when one is not finite.
pub(super) fn sorted(values: &[f64]) -> Option<Vec<f64>> {
    if !values.iter().all(|v| v.is_finite()) {
        return None;
    }
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    Some(sorted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_answers() {
        assert_eq!(median(&[]), None);
        assert_eq!(median(&[7.0]), Some(7.0));
        assert_eq!(median(&[3.0, 1.0]), Some(2.0));
        assert_eq!(median(&[5.0, 1.0, 3.0]), Some(3.0));
        assert_eq!(median(&[4.0, 1.0, 3.0, 2.0]), Some(2.5));
        assert_eq!(median(&[2.0, 2.0, 2.0, 9.0]), Some(2.0));
        assert_eq!(median(&[f64::MAX, f64::MAX]), Some(f64::MAX));
    }

    #[test]
    fn not_finite_has_no_median() {
        assert_eq!(median(&[1.0, f64::NAN, 2.0]), None);
        assert_eq!(median(&[1.0, f64::INFINITY, 2.0]), None);
    }

    #[test]
    fn one_outlier_does_not_move_it() {
        assert_eq!(median(&[1.0, 2.0, 3.0]), median(&[1.0, 2.0, 1e9]));
    }
}

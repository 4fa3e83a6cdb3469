//! Many comparisons at once.

/// Holm's step-down correction (Holm 1979): the p-values of a family, adjusted so that calling
/// everything at or below a level a finding errs anywhere in the family with at most that level.
/// In the order given. `None` when a p-value lies outside of [0, 1].
pub fn holm(p_values: &[f64]) -> Option<Vec<f64>> {
    if !p_values.iter().all(|p| (0.0..=1.0).contains(p)) {
        return None;
    }
    let mut by_size: Vec<usize> = (0..p_values.len()).collect();
    by_size.sort_by(|&a, &b| p_values[a].total_cmp(&p_values[b]));
    let mut adjusted = vec![0.0; p_values.len()];
    let mut largest: f64 = 0.0;
    for (position, &index) in by_size.iter().enumerate() {
        let remaining = (p_values.len() - position) as f64;
        // Never below that of a smaller p-value: the first one kept keeps all after it.
        largest = largest.max(f64::min(remaining * p_values[index], 1.0));
        adjusted[index] = largest;
    }
    Some(adjusted)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(found: Option<Vec<f64>>, wanted: &[f64]) -> bool {
        found.is_some_and(|f| {
            f.len() == wanted.len() && f.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12)
        })
    }

    #[test]
    fn known_answer() {
        // By hand: 0.005 x 4, 0.01 x 3, 0.03 x 2, and 0.04 x 1 raised to 0.06.
        assert!(close(holm(&[0.01, 0.04, 0.03, 0.005]), &[0.03, 0.06, 0.06, 0.02]));
    }

    #[test]
    fn corners() {
        assert_eq!(holm(&[]), Some(vec![]));
        assert_eq!(holm(&[0.2]), Some(vec![0.2]));
        assert!(close(holm(&[0.5, 0.9]), &[1.0, 1.0]));
        assert!(close(holm(&[0.01, 0.01]), &[0.02, 0.02]));
        assert_eq!(holm(&[0.1, f64::NAN]), None);
        assert_eq!(holm(&[0.1, 1.1]), None);
    }
}

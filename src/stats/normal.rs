//! The normal distribution, where nothing but its quantiles is asked for.

/// The number below which a standard normal variable lies with probability `p`, 0 < p < 1, to about
/// the last digits; `None` for other `p`. Found by halving an interval, since nothing here is
/// called often enough to need an approximation.
pub fn normal_quantile(p: f64) -> Option<f64> {
    if !(p > 0.0 && p < 1.0) {
        return None;
    }
    if p > 0.5 {
        // The tail is computed without cancellation on this side only.
        return normal_quantile(1.0 - p).map(|quantile| -quantile);
    }
    // P(X < -39) is less than the smallest number.
    let (mut low, mut high) = (-39.0, 0.0);
    while low < high {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            break;
        }
        let probability = 0.5 * libm::erfc(-middle * std::f64::consts::FRAC_1_SQRT_2);
        if probability < p { low = middle } else { high = middle }
    }
    Some(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_the_printed_tables() {
        for (p, wanted) in [(0.975, 1.959_963_985), (0.995, 2.575_829_304), (0.025, -1.959_963_985)]
        {
            let found = normal_quantile(p).expect("between 0 and 1");
            // The tables have nine digits behind the point.
            assert!((found - wanted).abs() < 1e-9, "{p}: {found}");
        }
        assert!(normal_quantile(0.5).is_some_and(|median| median.abs() < 1e-15));
    }

    #[test]
    fn what_has_no_quantile() {
        for p in [0.0, 1.0, -0.1, 1.1, f64::NAN] {
            assert_eq!(normal_quantile(p), None);
        }
    }
}

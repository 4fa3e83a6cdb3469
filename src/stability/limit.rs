//! When a kernel is said to fail at a setting.

use super::precision::Precision;

/// Decisions deep in the wrong, in a million cases, at which a kernel is said to fail.
const DEEP_PER_MILLION: f64 = 1000.0;

/// Whether the 99th percentile of the relative error of t, or that of the error of the weights
/// (`errors`, of those that there are), exceeds what the precision is good for, or more than 1000
/// decisions in a million `cases` are deep in the wrong.
pub fn fails(errors: [Option<f64>; 2], deep: u64, cases: u64, precision: Precision) -> bool {
    let beyond = |error: f64| error > precision.knee_error();
    let rate = deep as f64 / cases.max(1) as f64 * 1e6;
    errors.into_iter().flatten().any(beyond) || rate > DEEP_PER_MILLION
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_or_deep_decisions_make_it_fail() {
        let fails = |t, weights, deep| fails([t, weights], deep, 1_000, Precision::F32);
        assert!(!fails(Some(1e-3), Some(1e-3), 1), "on the limit is within it");
        assert!(fails(Some(1.1e-3), None, 0) && fails(None, Some(1.1e-3), 0));
        assert!(fails(None, None, 2), "2000 in a million");
        assert!(super::fails([Some(1e-8), None], 0, 1, Precision::F64));
    }
}

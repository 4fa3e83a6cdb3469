//! Bits that a computed number has lost.

use crate::number::Precision;

/// How many bits of a computed number are wrong: log2(1 + number of floats of the precision from the
/// exact one, rounded, to it), at most all of them (the scale of Herbie: Panchekha et al., PLDI
/// 2015). The exact number is `high + low`. What is not finite has lost all.
pub(super) fn bits_lost(precision: Precision, computed: f64, high: f64, low: f64) -> f64 {
    let all = f64::from(precision.digits());
    if !computed.is_finite() {
        return all;
    }
    let (computed, exact) = match precision {
        Precision::F32 => (place_single(computed as f32), place_single(single(high, low))),
        Precision::F64 => (place_double(computed), place_double(high)),
    };
    // From `libm`, the same on every machine.
    libm::log2(1.0 + computed.abs_diff(exact) as f64).min(all)
}

/// The f32 nearest to `high + low`, where `high` is already the f64 nearest to it: rounding twice
/// to nearest would be wrong where `high` is halfway between two f32, so the first is undone and
/// made to odd (Boldo and Melquiond 2008), which no later rounding can mistake for halfway.
fn single(high: f64, low: f64) -> f32 {
    if low == 0.0 || high == 0.0 || !low.is_finite() {
        return high as f32;
    }
    let towards_zero = (low < 0.0) != (high < 0.0);
    let bits = high.to_bits() - u64::from(towards_zero);
    f64::from_bits(bits | 1) as f32
}

/// Number of a float in the order of all, both zeros at 0.
fn place_single(x: f32) -> i64 {
    let magnitude = i64::from(x.abs().to_bits());
    if x < 0.0 { -magnitude } else { magnitude }
}

/// The same for f64.
fn place_double(x: f64) -> i64 {
    // The sign bit is off, so it fits.
    let magnitude = x.abs().to_bits() as i64;
    if x < 0.0 { -magnitude } else { magnitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_counted_in_steps_between_floats() {
        let next = |x: f32, steps: usize| (0..steps).fold(x, |x, _| x.next_up());
        for (steps, bits) in [(0, 0.0), (1, 1.0), (3, 2.0), (1023, 10.0)] {
            let lost = bits_lost(Precision::F32, f64::from(next(1.0, steps)), 1.0, 0.0);
            assert!((lost - bits).abs() < 1e-12, "{steps}: {lost}");
        }
        // Across zero: the two smallest numbers are two steps apart.
        let tiny = f64::from_bits(1);
        let lost = bits_lost(Precision::F64, tiny, -tiny, 0.0);
        assert!((lost - 3f64.log2()).abs() < 1e-12, "{lost}");
        assert_eq!(bits_lost(Precision::F64, -0.0, 0.0, 0.0), 0.0);
        assert_eq!(bits_lost(Precision::F64, 1.0, -1.0, 0.0), 53.0);
        for bad in [f64::NAN, f64::INFINITY] {
            assert_eq!(bits_lost(Precision::F32, bad, 1.0, 0.0), 24.0);
            assert_eq!(bits_lost(Precision::F64, bad, 1.0, 0.0), 53.0);
        }
    }

    #[test]
    fn a_number_halfway_between_two_floats_goes_where_its_rest_points() {
        let half = 1.0 + 0.5f64.powi(24);
        let rest = 0.5f64.powi(80);
        assert_eq!(single(half, 0.0), 1.0);
        assert_eq!(single(half, rest), 1.0f32.next_up());
        assert_eq!(single(half, -rest), 1.0);
        assert_eq!(single(-half, -rest), -1.0f32.next_up());
        // The next one is rounded to even, away from zero, if nothing points elsewhere.
        let odd = 1.0 + 3.0 * 0.5f64.powi(24);
        assert_eq!(single(odd, 0.0), next_but_one(1.0));
        assert_eq!(single(odd, -rest), 1.0f32.next_up());
    }

    fn next_but_one(x: f32) -> f32 {
        x.next_up().next_up()
    }
}

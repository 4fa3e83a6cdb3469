//! What a precision can tell apart: spacing and order of its floats.

/// The floats of a precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Format {
    Single,
    Double,
}

impl Format {
    /// f32 for a unit roundoff of 2^-24, f64 for one of 2^-53.
    pub fn of(unit_roundoff: f64) -> Self {
        // Any value between the two would do.
        if unit_roundoff > 0.5f64.powi(40) { Format::Single } else { Format::Double }
    }

    /// Bits of the significand.
    fn digits(self) -> i32 {
        match self {
            Format::Single => f32::MANTISSA_DIGITS as i32,
            Format::Double => f64::MANTISSA_DIGITS as i32,
        }
    }

    /// Unit in the last place at a finite `x`: 2^(max(floor(log2 |x|), emin) - p + 1), with emin the
    /// exponent of the smallest normal number (Muller et al., Handbook of Floating-Point
    /// Arithmetic, 2nd edition 2018, 2.3.2).
    pub fn ulp(self, x: f64) -> f64 {
        let smallest = match self {
            Format::Single => f32::MIN_EXP - 1,
            Format::Double => f64::MIN_EXP - 1,
        };
        // A subnormal f64 has 0 in its field, which puts it below the smallest of either precision.
        let exponent = ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023;
        power_of_two(exponent.max(smallest) - self.digits() + 1)
    }

    /// How many bits of a computed number are wrong: log2(1 + number of floats from the exact one,
    /// rounded, to it), at most all of them (the scale of Herbie: Panchekha et al., PLDI 2015).
    /// The exact number is `high + low`. What is not finite has lost all.
    pub fn bits_lost(self, computed: f64, high: f64, low: f64) -> f64 {
        let all = f64::from(self.digits());
        if !computed.is_finite() {
            return all;
        }
        let (computed, exact) = match self {
            Format::Single => (place_single(computed as f32), place_single(single(high, low))),
            Format::Double => (place_double(computed), place_double(high)),
        };
        // From `libm`, the same on every machine.
        libm::log2(1.0 + computed.abs_diff(exact) as f64).min(all)
    }
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

/// 2^exponent, for exponents of f64 numbers.
fn power_of_two(exponent: i32) -> f64 {
    if exponent >= f64::MIN_EXP - 1 {
        f64::from_bits(((exponent + 1023) as u64) << 52)
    } else {
        f64::from_bits(1 << (exponent + 1074).max(0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_in_the_last_place_is_the_gap_to_the_next_float() {
        for x in [1.0f32, 1.5, 3.0e-7, 1e30, f32::MIN_POSITIVE, 1e-42, 0.0, -1.5] {
            let gap = f64::from(x.abs().next_up()) - f64::from(x.abs());
            assert_eq!(Format::Single.ulp(f64::from(x)), gap, "{x}");
        }
        for x in [1.0f64, 1.5, 3.0e-7, 1e300, f64::MIN_POSITIVE, 1e-320, 0.0, -1.5] {
            assert_eq!(Format::Double.ulp(x), x.abs().next_up() - x.abs(), "{x}");
        }
    }

    #[test]
    fn bits_are_counted_in_steps_between_floats() {
        let next = |x: f32, steps: usize| (0..steps).fold(x, |x, _| x.next_up());
        for (steps, bits) in [(0, 0.0), (1, 1.0), (3, 2.0), (1023, 10.0)] {
            let lost = Format::Single.bits_lost(f64::from(next(1.0, steps)), 1.0, 0.0);
            assert!((lost - bits).abs() < 1e-12, "{steps}: {lost}");
        }
        // Across zero: the two smallest numbers are two steps apart.
        let tiny = f64::from_bits(1);
        let lost = Format::Double.bits_lost(tiny, -tiny, 0.0);
        assert!((lost - 3f64.log2()).abs() < 1e-12, "{lost}");
        assert_eq!(Format::Double.bits_lost(-0.0, 0.0, 0.0), 0.0);
        assert_eq!(Format::Double.bits_lost(1.0, -1.0, 0.0), 53.0);
        for bad in [f64::NAN, f64::INFINITY] {
            assert_eq!(Format::Single.bits_lost(bad, 1.0, 0.0), 24.0);
            assert_eq!(Format::Double.bits_lost(bad, 1.0, 0.0), 53.0);
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

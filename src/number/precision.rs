//! The two precisions as values: what can be told apart in them.

/// `f32` or `f64`: what inputs are rounded to, what kernels compute in, whose last place errors are
/// counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Precision {
    /// 24 bits, smallest normal number 2^-126.
    F32,
    /// 53 bits, smallest normal number 2^-1022.
    F64,
}

impl Precision {
    /// Both.
    pub const ALL: [Precision; 2] = [Precision::F32, Precision::F64];

    /// The word in ids and columns.
    pub fn name(self) -> &'static str {
        match self {
            Precision::F32 => "f32",
            Precision::F64 => "f64",
        }
    }

    /// The precision of that name.
    pub fn of(name: &str) -> Option<Self> {
        Precision::ALL.into_iter().find(|precision| precision.name() == name)
    }

    /// The precision with that unit roundoff; any value between the two is told from both.
    pub fn of_unit_roundoff(unit_roundoff: f64) -> Self {
        if unit_roundoff > power_of_two(-40) { Precision::F32 } else { Precision::F64 }
    }

    /// The nearest number of this precision, ties to even; infinite beyond its range.
    pub fn round(self, x: f64) -> f64 {
        match self {
            Precision::F32 => f64::from(x as f32),
            Precision::F64 => x,
        }
    }

    /// 2^-24 or 2^-53.
    pub fn unit_roundoff(self) -> f64 {
        power_of_two(-self.digits())
    }

    /// The largest finite number.
    pub fn largest(self) -> f64 {
        match self {
            Precision::F32 => f64::from(f32::MAX),
            Precision::F64 => f64::MAX,
        }
    }

    /// Bits of the significand.
    pub fn digits(self) -> i32 {
        match self {
            Precision::F32 => f32::MANTISSA_DIGITS as i32,
            Precision::F64 => f64::MANTISSA_DIGITS as i32,
        }
    }

    /// Exponent of the smallest normal number.
    pub fn smallest_exponent(self) -> i32 {
        match self {
            Precision::F32 => f32::MIN_EXP - 1,
            Precision::F64 => f64::MIN_EXP - 1,
        }
    }

    /// Exponent of the largest power of two.
    pub fn largest_exponent(self) -> i32 {
        match self {
            Precision::F32 => f32::MAX_EXP - 1,
            Precision::F64 => f64::MAX_EXP - 1,
        }
    }

    /// The unit in the last place of a finite x: `2^(max(floor(log2|x|), e_min) - p + 1)`, for 0 the
    /// smallest subnormal number (Muller et al., Handbook of Floating-Point Arithmetic, 2nd edition
    /// 2018, 2.3.2). `value` is x rounded to f64, `rest` what is left, which decides where x was
    /// rounded up to a power of two.
    pub fn ulp(self, value: f64, rest: f64) -> f64 {
        let is_power = value.to_bits() << 12 == 0;
        let rounded_up = is_power && rest != 0.0 && (rest < 0.0) != (value < 0.0);
        let exponent = exponent(value) - i32::from(rounded_up);
        power_of_two(exponent.max(self.smallest_exponent()) - self.digits() + 1)
    }
}

/// `floor(log2|x|)` of a normal number; -1023 of 0 and of subnormal ones.
pub fn exponent(x: f64) -> i32 {
    // Eleven bits.
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

/// `2^exponent`, exactly; for exponents from -1074 to 1023, beyond which it is that of the end.
pub fn power_of_two(exponent: i32) -> f64 {
    if exponent >= f64::MIN_EXP - 1 {
        f64::from_bits(((exponent.min(1023) + 1023) as u64) << 52)
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
            assert_eq!(Precision::F32.ulp(f64::from(x), 0.0), gap, "{x}");
        }
        for x in [1.0f64, 1.5, 3.0e-7, 1e300, f64::MIN_POSITIVE, 1e-320, 0.0, -1.5] {
            assert_eq!(Precision::F64.ulp(x, 0.0), x.abs().next_up() - x.abs(), "{x}");
        }
    }

    #[test]
    fn what_was_rounded_up_to_a_power_of_two_has_the_smaller_unit() {
        let half = Precision::F32.ulp(1.0, -1e-20);
        assert_eq!(half * 2.0, Precision::F32.ulp(1.0, 1e-20));
        assert_eq!(Precision::F32.ulp(-1.0, 1e-20), half);
    }

    #[test]
    fn powers_are_exact_to_both_ends() {
        assert_eq!(power_of_two(-1074), f64::from_bits(1));
        assert_eq!(power_of_two(-1022), f64::MIN_POSITIVE);
        assert_eq!(power_of_two(1023) * (2.0 - f64::EPSILON), f64::MAX);
        assert_eq!(power_of_two(-24), Precision::F32.unit_roundoff());
    }

    #[test]
    fn a_precision_is_found_by_its_name_and_by_its_rounding() {
        for precision in Precision::ALL {
            assert_eq!(Precision::of(precision.name()), Some(precision));
            assert_eq!(Precision::of_unit_roundoff(precision.unit_roundoff()), precision);
        }
        assert_eq!(Precision::of("f16"), None);
    }
}

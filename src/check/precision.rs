//! The precision that a case is asked in.

/// `f32` or `f64`: what inputs are rounded to, and whose last place errors are counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Precision {
    /// 24 bits, smallest normal number 2^-126.
    F32,
    /// 53 bits, smallest normal number 2^-1022.
    F64,
}

impl Precision {
    /// Both.
    pub const ALL: [Precision; 2] = [Precision::F32, Precision::F64];

    /// The word of the column `precision`.
    pub fn name(self) -> &'static str {
        match self {
            Precision::F32 => "f32",
            Precision::F64 => "f64",
        }
    }

    /// The nearest number of this precision, ties to even; infinite beyond its range.
    pub fn round(self, x: f64) -> f64 {
        match self {
            Precision::F32 => f64::from(x as f32),
            Precision::F64 => x,
        }
    }

    /// Bits of the significand, and exponent of the smallest normal number.
    fn shape(self) -> (i32, i32) {
        match self {
            Precision::F32 => (24, -126),
            Precision::F64 => (53, -1022),
        }
    }

    /// Exponent of the largest power of two.
    pub(super) fn largest_exponent(self) -> i32 {
        match self {
            Precision::F32 => 127,
            Precision::F64 => 1023,
        }
    }

    /// The unit in the last place of an exact x: `2^(max(floor(log2|x|), e_min) - p + 1)`, for 0 the
    /// smallest subnormal number. `value` is x rounded to f64, `rest` what is left, which decides
    /// where x was rounded up to a power of two.
    pub fn ulp(self, value: f64, rest: f64) -> f64 {
        let (bits, smallest) = self.shape();
        let is_power = value.to_bits() << 12 == 0;
        let rounded_up = is_power && rest != 0.0 && (rest < 0.0) != (value < 0.0);
        let exponent = exponent(value) - i32::from(rounded_up);
        libm::scalbn(1.0, exponent.max(smallest) - bits + 1)
    }
}

/// `floor(log2|x|)` of a normal number; -1023 of 0 and of subnormal ones.
pub(super) fn exponent(x: f64) -> i32 {
    // Eleven bits.
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

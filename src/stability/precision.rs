//! The two precisions, as the generators and the judging see them.

/// `f32` or `f64`: what inputs are rounded to and kernels compute in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Precision {
    /// 24 bits.
    F32,
    /// 53 bits.
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

    /// The value rounded to nearest even; exact in f64.
    pub fn round(self, x: f64) -> f64 {
        match self {
            Precision::F32 => f64::from(x as f32),
            Precision::F64 => x,
        }
    }

    /// 2^-24 or 2^-53.
    pub fn unit_roundoff(self) -> f64 {
        match self {
            Precision::F32 => f64::from(f32::EPSILON) / 2.0,
            Precision::F64 => f64::EPSILON / 2.0,
        }
    }

    /// The largest finite number.
    pub fn largest(self) -> f64 {
        match self {
            Precision::F32 => f64::from(f32::MAX),
            Precision::F64 => f64::MAX,
        }
    }

    /// The error at which a kernel is said to fail: one in a thousand leaves a few digits of a f32
    /// picture; f64 is bought for nine.
    pub fn knee_error(self) -> f64 {
        match self {
            Precision::F32 => 1e-3,
            Precision::F64 => 1e-9,
        }
    }
}

/// `10^exponent`, correctly rounded, so that it is the same on every machine; 0 and infinity
/// beyond the range.
pub fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

/// `2^exponent`, exactly; for exponents from -1022 to 1023.
pub fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent.clamp(-1022, 1023) + 1023) as u64) << 52)
}

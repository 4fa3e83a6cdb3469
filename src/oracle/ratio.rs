//! Quotients of integers, correctly rounded to f64.

use dashu_int::IBig;
use dashu_int::Sign;
use dashu_int::UBig;
use dashu_int::ops::{BitTest, DivRem, UnsignedAbs};

/// Exponent of the smallest subnormal number.
const SMALLEST: i64 = -1074;
/// The quotient is computed to this many bits or one more, which a u128 holds.
const QUOTIENT_BITS: i64 = 125;

/// `numerator / denominator * 2^exponent` as the sum of two floats: the first is the exact value
/// rounded to nearest even (infinite beyond the largest float), the second what is left, rounded.
/// The denominator must be positive.
pub fn rounded(numerator: &IBig, denominator: &IBig, exponent: i64) -> (f64, f64) {
    let negative = numerator.sign() == Sign::Negative;
    let numerator = numerator.unsigned_abs();
    let denominator = denominator.unsigned_abs();
    if numerator.is_zero() || denominator.is_zero() {
        return (0.0, 0.0);
    }
    let gap = length(&numerator) - length(&denominator);
    let shift = QUOTIENT_BITS - gap;
    let (quotient, rest) = if shift >= 0 {
        (numerator << shift.unsigned_abs() as usize).div_rem(&denominator)
    } else {
        numerator.div_rem(denominator << shift.unsigned_abs() as usize)
    };
    let quotient = u128::try_from(quotient).unwrap_or(u128::MAX);
    let exponent = exponent - shift;
    let (kept, dropped) = nearest(quotient, exponent, !rest.is_zero());
    let high = scaled(kept, exponent + i64::from(dropped));
    let low = if high.is_finite() { remainder(quotient, kept, dropped, exponent) } else { 0.0 };
    if negative { (-high, -low) } else { (high, low) }
}

/// Rounds `magnitude * 2^exponent` (and a little more, if `sticky`) to 53 bits, or fewer for
/// subnormals: the bits kept, and how many were dropped.
fn nearest(magnitude: u128, exponent: i64, sticky: bool) -> (u128, u32) {
    let bits = 128 - i64::from(magnitude.leading_zeros());
    let dropped = (bits - 53).max(SMALLEST - exponent).max(0);
    if dropped >= 128 {
        // Below half of the smallest subnormal, since a u128 here has at most 126 bits.
        return (0, 127);
    }
    let dropped = dropped as u32;
    if dropped == 0 {
        return (magnitude, 0);
    }
    let kept = magnitude >> dropped;
    let rest = magnitude & ((1 << dropped) - 1);
    let half = 1 << (dropped - 1);
    let up = rest > half || (rest == half && (sticky || kept & 1 == 1));
    (kept + u128::from(up), dropped)
}

/// What rounding took away, itself rounded.
fn remainder(quotient: u128, kept: u128, dropped: u32, exponent: i64) -> f64 {
    let kept = kept << dropped;
    let (kept_again, dropped_again) = nearest(quotient.abs_diff(kept), exponent, false);
    let size = scaled(kept_again, exponent + i64::from(dropped_again));
    if quotient < kept { -size } else { size }
}

/// `magnitude * 2^exponent` for a magnitude up to 2^53 whose product is representable or too large.
fn scaled(magnitude: u128, exponent: i64) -> f64 {
    if magnitude == 0 || exponent < 2 * SMALLEST {
        return 0.0;
    }
    times_power_of_two(magnitude as f64, exponent)
}

/// `x * 2^exponent`, rounded once.
pub fn times_power_of_two(x: f64, exponent: i64) -> f64 {
    // In two steps, so that neither factor over- or underflows where the product does not.
    let exponent = exponent.clamp(3 * SMALLEST / 2, 2000);
    let half = exponent / 2;
    x * power_of_two(half) * power_of_two(exponent - half)
}

/// `2^exponent`, infinite or 0 beyond the range.
fn power_of_two(exponent: i64) -> f64 {
    if (-1022..=1023).contains(&exponent) {
        f64::from_bits(((exponent + 1023) as u64) << 52)
    } else if exponent > 0 {
        f64::INFINITY
    } else {
        // One of the subnormals, or 0.
        f64::from_bits(if exponent < SMALLEST { 0 } else { 1 << (exponent - SMALLEST) })
    }
}

/// The value nearest to `number * 2^exponent`, up to a relative error of 2^-52.
pub fn approximate(number: &IBig, exponent: i64) -> f64 {
    rounded(number, &IBig::ONE, exponent).0
}

fn length(number: &UBig) -> i64 {
    i64::try_from(number.bit_len()).unwrap_or(i64::MAX / 4)
}

//! The few operations on integers that orientation signs need, over `i128` and big integers.

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use std::cmp::Ordering;

/// An integer wide enough for the numbers it is given; nobody checks that again here.
pub trait Integer: Sized {
    /// `mantissa * 2^shift`.
    fn scaled(mantissa: i64, shift: u32) -> Self;
    /// Sum. By value, like `less` and `negated`: a big integer then keeps its memory.
    fn plus(self, other: Self) -> Self;
    /// Difference.
    fn less(self, other: Self) -> Self;
    /// The other sign.
    fn negated(self) -> Self;
    /// Difference of two that are needed further on.
    fn minus(&self, other: &Self) -> Self;
    /// Product.
    fn times(&self, other: &Self) -> Self;
    /// Sign compared with 0.
    fn sign(&self) -> Ordering;
    /// Number of bits of the magnitude; 0 for 0.
    fn bits(&self) -> i64;
    /// The same number as a big integer.
    fn big(&self) -> IBig;
}

impl Integer for i128 {
    fn scaled(mantissa: i64, shift: u32) -> Self {
        i128::from(mantissa) << shift
    }
    fn plus(self, other: Self) -> Self {
        self + other
    }
    fn less(self, other: Self) -> Self {
        self - other
    }
    fn negated(self) -> Self {
        -self
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn sign(&self) -> Ordering {
        self.cmp(&0)
    }
    fn bits(&self) -> i64 {
        i64::from(128 - self.unsigned_abs().leading_zeros())
    }
    fn big(&self) -> IBig {
        IBig::from(*self)
    }
}

impl Integer for IBig {
    fn scaled(mantissa: i64, shift: u32) -> Self {
        IBig::from(mantissa) << shift as usize
    }
    fn plus(self, other: Self) -> Self {
        self + other
    }
    fn less(self, other: Self) -> Self {
        self - other
    }
    fn negated(self) -> Self {
        -self
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn sign(&self) -> Ordering {
        self.cmp(&IBig::ZERO)
    }
    fn bits(&self) -> i64 {
        // A bit length of 2^63 does not fit into memory.
        i64::try_from(self.bit_len()).unwrap_or(i64::MAX)
    }
    fn big(&self) -> IBig {
        self.clone()
    }
}

/// Compares `left * 2^left_exponent` with `factor * right * 2^right_exponent`, exactly.
pub fn compare<I: Integer, F: Integer, J: Integer>(
    left: &I,
    left_exponent: i64,
    factor: &F,
    right: &J,
    right_exponent: i64,
) -> Ordering {
    let sign = sign_of_product(factor.sign(), right.sign());
    if left.sign() != sign || sign == Ordering::Equal {
        return left.sign().cmp(&sign);
    }
    // Magnitudes: left in [2^(l-1), 2^l), the product in [2^(p-2), 2^p).
    let l = left.bits() + left_exponent;
    let p = factor.bits() + right.bits() + right_exponent;
    let larger = if l > p {
        Ordering::Greater
    } else if l <= p - 2 {
        Ordering::Less
    } else {
        let common = left_exponent.min(right_exponent);
        // The two differ by less than the bits of the numbers, or the above had decided.
        let left = shifted(left.big(), left_exponent - common);
        let right = shifted(factor.big() * right.big(), right_exponent - common);
        return left.cmp(&right);
    };
    if sign == Ordering::Less { larger.reverse() } else { larger }
}

fn shifted(number: IBig, shift: i64) -> IBig {
    number << usize::try_from(shift).unwrap_or(0)
}

fn sign_of_product(a: Ordering, b: Ordering) -> Ordering {
    match (a, b) {
        (Ordering::Equal, _) | (_, Ordering::Equal) => Ordering::Equal,
        (a, b) if a == b => Ordering::Greater,
        _ => Ordering::Less,
    }
}

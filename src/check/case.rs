//! One case: a ray and a triangle, as somebody wrote them down.

use crate::number::Precision;
use crate::oracle::Query;

/// The names of a case's numbers: origin, direction, vertices a, b, c, and the range of t.
pub const NUMBERS: [&str; 17] = [
    "ox", "oy", "oz", "dx", "dy", "dz", "ax", "ay", "az", "bx", "by", "bz", "cx", "cy", "cz",
    "tmin", "tmax",
];

/// One number in both precisions, each rounded once from what was written: the nearest f32 to a
/// decimal is not always the nearest to the f64 in between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    single: f32,
    double: f64,
}

impl Number {
    /// Reads a decimal number, `nan`, `inf` or `infinity`; `None` for anything else. What is beyond
    /// the largest number is read as infinite.
    pub fn read(text: &str) -> Option<Self> {
        Some(Number { single: text.parse().ok()?, double: text.parse().ok()? })
    }

    /// The number in a precision, widened.
    pub fn get(self, precision: Precision) -> f64 {
        match precision {
            Precision::F32 => f64::from(self.single),
            Precision::F64 => self.double,
        }
    }
}

impl From<f64> for Number {
    fn from(double: f64) -> Self {
        Number { single: double as f32, double }
    }
}

/// A ray and a triangle, with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Its name.
    pub id: String,
    /// In the order of [`NUMBERS`].
    pub numbers: [Number; 17],
}

impl Case {
    /// The case in a precision. Bounds of t beyond its range are infinite.
    pub fn query(&self, precision: Precision) -> Query {
        let number = |index: usize| self.numbers[index].get(precision);
        let vector = |first: usize| [number(first), number(first + 1), number(first + 2)];
        Query {
            origin: vector(0),
            direction: vector(3),
            end: None,
            triangle: [vector(6), vector(9), vector(12)],
            t_min: number(15),
            t_max: number(16),
        }
    }
}

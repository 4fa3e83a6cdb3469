//! A query as integers: floats decoded and brought to common powers of two.

use super::integer::Integer;
use super::query::Query;

/// `mantissa * 2^exponent`, the mantissa odd or 0: a finite float exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dyadic {
    /// Odd, below 2^53 in magnitude, or 0.
    pub mantissa: i64,
    /// Power of two; 0 for the number 0.
    pub exponent: i64,
}

impl Dyadic {
    /// Takes a finite float apart. (An infinite one gives some large number, a NaN any.)
    pub fn of(x: f64) -> Self {
        let bits = x.to_bits();
        let field = ((bits >> 52) & 0x7ff) as i64;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        // Subnormals have no hidden bit, and the exponent of the smallest normal numbers.
        let magnitude = if field == 0 { fraction } else { fraction | (1 << 52) };
        if magnitude == 0 {
            return Dyadic { mantissa: 0, exponent: 0 };
        }
        let zeros = magnitude.trailing_zeros();
        let odd = magnitude >> zeros;
        Dyadic {
            mantissa: if x.is_sign_negative() { -odd } else { odd },
            exponent: field.max(1) - 1075 + i64::from(zeros),
        }
    }

    /// The smallest k with `|x| < 2^k`.
    pub fn size(self) -> i64 {
        self.bits() + self.exponent
    }

    fn bits(self) -> i64 {
        i64::from(64 - self.mantissa.unsigned_abs().leading_zeros())
    }
}

/// Vectors over one common power of two.
#[derive(Clone, Debug)]
struct Grid<const N: usize> {
    vectors: [[Dyadic; 3]; N],
    /// Exponent of the unit: every coordinate is a whole number of `2^exponent`.
    exponent: i64,
    /// Every coordinate is below `2^width` in magnitude.
    width: i64,
}

impl<const N: usize> Grid<N> {
    fn of(vectors: [[f64; 3]; N]) -> Self {
        let vectors = vectors.map(|v| v.map(Dyadic::of));
        let parts = || vectors.iter().flatten().filter(|d| d.mantissa != 0);
        let exponent = parts().map(|d| d.exponent).min().unwrap_or(0);
        let width = parts().map(|d| d.size() - exponent).max().unwrap_or(0);
        Grid { vectors, exponent, width }
    }

    fn vector<I: Integer>(&self, index: usize) -> [I; 3] {
        self.vectors[index].map(|d| {
            // A zero has no exponent of its own to be shifted by.
            let shift = if d.mantissa == 0 { 0 } else { d.exponent - self.exponent };
            I::scaled(d.mantissa, u32::try_from(shift).unwrap_or(0))
        })
    }
}

/// What a query's direction is made of.
#[derive(Clone, Debug)]
enum Direction {
    Given(Grid<1>),
    /// Origin and end; the direction is their difference.
    Between(Grid<2>),
}

/// A query on two integer grids: one for the twelve coordinates of positions, one for the
/// direction (which scales independently of them).
#[derive(Clone, Debug)]
pub struct Aligned {
    positions: Grid<4>,
    direction: Direction,
}

impl Aligned {
    /// Decodes a finite query.
    pub fn of(query: &Query) -> Self {
        let [a, b, c] = query.triangle;
        Aligned {
            positions: Grid::of([query.origin, a, b, c]),
            direction: match query.end {
                None => Direction::Given(Grid::of([query.direction])),
                Some(end) => Direction::Between(Grid::of([query.origin, end])),
            },
        }
    }

    /// Whether every intermediate result of `numerators` fits into `i128`.
    ///
    /// With positions below `2^p` and the direction below `2^d`, differences are below `2^(p+1)`;
    /// a component of a cross product is at most two products, a dot product three of those: six
    /// products of three factors. So det, u, v are below `6 * 2^(d+2p+2) < 2^(d+2p+5)`, det - u - v
    /// below four times that, and t and the normal's products below `2^(3p+6)`.
    pub fn fits_i128(&self) -> bool {
        let p = self.positions.width;
        let d = match &self.direction {
            Direction::Given(grid) => grid.width,
            Direction::Between(grid) => grid.width + 1,
        };
        // i128 holds magnitudes below 2^127; a zero direction must not hide wide positions.
        (d + 2 * p + 7).max(3 * p + 6) <= 126
    }

    /// Exponent of the unit of t: a quotient of numerators times `2^this` is t.
    pub fn t_exponent(&self) -> i64 {
        self.positions.exponent - self.direction_exponent()
    }

    /// Exponent of the unit of the direction.
    pub fn direction_exponent(&self) -> i64 {
        match &self.direction {
            Direction::Given(grid) => grid.exponent,
            Direction::Between(grid) => grid.exponent,
        }
    }

    /// Exponent of the unit of positions.
    pub fn position_exponent(&self) -> i64 {
        self.positions.exponent
    }

    /// Origin, a, b, c as integers.
    pub fn positions<I: Integer>(&self) -> [[I; 3]; 4] {
        [0, 1, 2, 3].map(|i| self.positions.vector(i))
    }

    /// Direction as integers.
    pub fn direction<I: Integer>(&self) -> [I; 3] {
        match &self.direction {
            Direction::Given(grid) => grid.vector(0),
            Direction::Between(grid) => {
                super::numerators::difference(&grid.vector(1), &grid.vector(0))
            }
        }
    }
}

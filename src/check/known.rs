//! The exact answer of a case.

use super::segment::Segment;
use crate::number::Precision;
use crate::oracle::{Class, Exact, Query, solve};

/// Where the ray meets the triangle: the column `where`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// A coordinate is not finite, or a bound of t is NaN. A miss by rule.
    NotFinite,
    /// The class of finite input.
    Of(Class),
}

impl Place {
    /// The word that tables use.
    pub fn name(self) -> &'static str {
        match self {
            Place::NotFinite => "not-finite",
            Place::Of(class) => class.name(),
        }
    }

    /// Whether it is a hit.
    pub fn is_hit(self) -> bool {
        matches!(self, Place::Of(class) if class.is_hit())
    }
}

/// What was asked in one precision, and the exact answer to that.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// What was asked.
    pub query: Query,
    /// Where it is met.
    pub place: Place,
    /// Whose last place errors are counted in.
    pub precision: Precision,
    /// The oracle's values, t in units of the query.
    pub(super) exact: Exact,
    /// What t is multiplied by to be in units of the ray's direction: a power of two, 1 for rays.
    pub(super) unit: f64,
}

impl Known {
    /// Of a ray whose numbers are rounded to the precision.
    pub fn of_ray(query: Query, precision: Precision) -> Self {
        Self::solved(query, 1.0, precision)
    }

    /// Of the segment along the ray of `self` to an end beyond the triangle's plane, for kernels
    /// that are judged on (origin, end). The end is rounded to the precision, so that where the
    /// rounding turns the ray, its exact answer is another one.
    pub fn of_segment(&self) -> Self {
        if self.place == Place::NotFinite {
            return *self;
        }
        let segment = Segment::along(&self.query, self.exact.t, self.precision);
        Self::solved(segment.query, segment.unit, self.precision)
    }

    fn solved(query: Query, unit: f64, precision: Precision) -> Self {
        let exact = solve(&query);
        let finite = query.is_finite();
        let place = if finite { Place::Of(exact.class) } else { Place::NotFinite };
        Known { query, place, precision, exact, unit }
    }

    /// t, u and v of the point where line and plane meet, t in units of the direction, correctly
    /// rounded to f64; for misses, too. `None` where there is no such point, or a value is beyond
    /// the largest f64. (The t of a segment below 2^-1022 is rounded twice.)
    pub fn values(&self) -> [Option<f64>; 3] {
        let [t, u, v] = self.rounded();
        [t.0, u.0, v.0].map(|x| Some(x).filter(|x| x.is_finite()))
    }

    /// t, u, v, and what their rounding has left of each.
    pub(super) fn rounded(&self) -> [(f64, f64); 3] {
        let exact = &self.exact;
        // Adding 0 turns the -0 of a segment that goes backwards into 0.
        let t = (exact.t * self.unit + 0.0, exact.t_lo * self.unit);
        [t, (exact.u, exact.u_lo), (exact.v, exact.v_lo)]
    }
}

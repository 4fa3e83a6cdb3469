//! A ray as a segment, for kernels that are judged on (origin, end).

use crate::number::{Precision, exponent};
use crate::oracle::Query;

/// A segment along a ray; 1 along the segment is `unit` along the ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    /// From origin to end; the range of t is the ray's, within [0, 1] of the segment.
    pub query: Query,
    /// A power of two, negative for a segment that goes backwards.
    pub unit: f64,
}

/// The exponents of `unit` stay within this, so that neither it nor its inverse overflows.
const LARGEST_UNIT: i32 = 1000;

impl Segment {
    /// The segment of a finite ray whose line meets the plane at `t` (not finite if nowhere).
    ///
    /// Its end is `origin + unit direction`, rounded to the precision:
    /// - at least twice as far as the plane, so that it does not touch it: `unit > 2 |t|`;
    /// - at least as far from the origin as the origin is from 0, so that rounding the end turns
    ///   the direction by no more than about the unit roundoff;
    /// - nearer only where it would not be finite otherwise.
    ///
    /// `unit` is a power of two, so that t in units of the direction is exact. It is negative where
    /// the ray's range admits a negative t and the plane lies there.
    pub fn along(ray: &Query, t: f64, precision: Precision) -> Self {
        let largest = |v: [f64; 3]| exponent(v.iter().fold(0.0, |m: f64, x| m.max(x.abs())));
        let direction = largest(ray.direction);
        let beyond = if t.is_nan() || t == 0.0 { 0 } else { exponent(t) + 2 };
        let steady = largest(ray.origin) - direction;
        // With this the end is certainly beyond the largest number, wherever the origin is.
        let highest = (precision.largest_exponent() + 2 - direction).min(LARGEST_UNIT);
        let backwards = t < 0.0 && ray.t_min < 0.0;
        let mut power = beyond.max(steady).min(highest).max(-LARGEST_UNIT);
        loop {
            let unit = libm::scalbn(if backwards { -1.0 } else { 1.0 }, power);
            let end: [f64; 3] =
                std::array::from_fn(|i| precision.round(ray.origin[i] + unit * ray.direction[i]));
            if end.iter().all(|x| x.is_finite()) || power <= -LARGEST_UNIT {
                return Segment { query: segment(ray, end, unit, precision), unit };
            }
            power -= 1;
        }
    }
}

fn segment(ray: &Query, end: [f64; 3], unit: f64, precision: Precision) -> Query {
    let bounds = [ray.t_min / unit, ray.t_max / unit];
    let [first, last] = if unit < 0.0 { [bounds[1], bounds[0]] } else { bounds };
    // Exact, unless a bound that is that small beside the segment leaves the range: what is asked
    // is the rounded question.
    let (first, last) = (precision.round(first).max(0.0), precision.round(last).min(1.0));
    let exact = Query::segment(ray.origin, end, ray.triangle);
    let direction = exact.direction.map(|x| precision.round(x));
    Query { direction, t_min: first, t_max: last, ..exact }
}

//! How far the outputs of one hit are from the exact ones, by every measure.

use super::bits_lost::bits_lost;
use super::case::Case;
use super::reported::Reported;
use crate::job::Answer;
use crate::number::Precision;

/// Signed errors of a hit that is one. Those of outputs that are not reported mean nothing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Deviation {
    /// Of the distance, in units of the query's direction.
    pub t: f64,
    /// Of the weight of b.
    pub u: f64,
    /// Of the weight of c.
    pub v: f64,
}

impl Deviation {
    /// Formed as `(computed - high) - low`: where the first difference is small, it is exact, so
    /// nothing of the exact answer's own rounding is in the error.
    pub fn of(case: &Case<'_>, answer: &Answer) -> Self {
        let exact = case.exact;
        Deviation {
            t: (answer.t / case.t_scale - exact.t) - exact.t_lo,
            u: (answer.u - exact.u) - exact.u_lo,
            v: (answer.v - exact.v) - exact.v_lo,
        }
    }

    /// Whether every output that is reported is finite.
    pub fn is_finite(&self, reported: Reported) -> bool {
        (!reported.t || self.t.is_finite())
            && (!reported.uv || (self.u.is_finite() && self.v.is_finite()))
    }

    /// Of the weights of b, c and a. The third is 1 - u - v, for the exact ones as for a user of
    /// the computed ones.
    pub fn weights(&self) -> [f64; 3] {
        [self.u, self.v, self.u + self.v].map(f64::abs)
    }

    /// Largest error of a weight; absolute, since a weight near 0 is no harder to use than others.
    pub fn barycentric(&self) -> f64 {
        self.weights().into_iter().fold(0.0, f64::max)
    }

    /// Bits lost by t, by u and by v.
    pub fn bits_lost(case: &Case<'_>, answer: &Answer, precision: Precision) -> [f64; 3] {
        let exact = case.exact;
        let t = if case.t_scale == 1.0 {
            bits_lost(precision, answer.t, exact.t, exact.t_lo)
        } else {
            bits_lost(precision, answer.t, exact.t * case.t_scale, 0.0)
        };
        let u = bits_lost(precision, answer.u, exact.u, exact.u_lo);
        [t, u, bits_lost(precision, answer.v, exact.v, exact.v_lo)]
    }

    /// Error of t, and the largest of a weight, over what rounding the inputs alone may do
    /// (condition number times unit roundoff).
    pub fn excess(&self, case: &Case<'_>, unit_roundoff: f64) -> (f64, f64) {
        let kappa = &case.condition;
        let over = |error: f64, kappa: f64| {
            if error == 0.0 { 0.0 } else { error.abs() / (kappa * unit_roundoff) }
        };
        let kappas = [kappa.kappa_u, kappa.kappa_v, kappa.kappa_w];
        let weights = self.weights().into_iter().zip(kappas);
        let weights = weights.map(|(error, kappa)| over(error, kappa)).fold(0.0, f64::max);
        (over(self.t, kappa.kappa_t), weights)
    }

    /// Backward error, componentwise (Oettli and Prager 1964; Higham 2002, theorem 7.3): the
    /// smallest relative change of the inputs that makes the outputs exact, in unit roundoffs. With
    /// x^ the outputs, max over i of |O + t^D - w^A - u^B - v^C|_i / (|O| + |t^D| + |w^A| + |u^B| +
    /// |v^C|)_i.
    ///
    /// The exact outputs make the numerator 0, so it is tD - u(B - A) - v(C - A) of the *errors*.
    /// That spares the sum's cancelling terms; what is left of rounding is 2^-53 of the errors, so
    /// the result is off by 2^-53 times the condition number, in its own units.
    pub fn backward(&self, case: &Case<'_>, answer: &Answer, unit_roundoff: f64) -> f64 {
        let query = case.query;
        let [a, b, c] = query.triangle;
        let (t, u, v) = (answer.t / case.t_scale, answer.u, answer.v);
        let w = (1.0 - u) - v;
        let component = |i: usize| {
            let rest =
                self.t * query.direction[i] - self.u * (b[i] - a[i]) - self.v * (c[i] - a[i]);
            let size = query.origin[i].abs()
                + (t * query.direction[i]).abs()
                + (w * a[i]).abs()
                + (u * b[i]).abs()
                + (v * c[i]).abs();
            match rest.abs() / size {
                _ if rest == 0.0 => 0.0,
                // Beyond the range of f64: as wrong as can be.
                share if share.is_nan() => 1.0,
                share => share.min(1.0),
            }
        };
        (0..3).map(component).fold(0.0, f64::max) / unit_roundoff
    }
}

//! How much an answer may move when its inputs do, and which wrong answers that excuses.
//!
//! Perturb every input by a relative delta. To first order
//! `delta x = M^-1 (delta O + t delta D - w delta A - u delta B - v delta C)`, where M has the
//! columns -D, E1, E2 and x = (t, u, v). The rows of M^-1 are, but for the sign, N/det, (D x E2)/det
//! and (E1 x D)/det, and (D x (C - B))/det for w. With s the sum of the magnitudes in the bracket,
//! the condition number of t is `|N| . s / |det|`, and so on (componentwise magnitudes).

use super::aligned::{Aligned, Dyadic};
use super::exact::Exact;
use super::filter::{self, Bounded};
use super::numerators;
use super::query::Query;
use super::ratio::{approximate, times_power_of_two};
use dashu_int::IBig;

/// A decision is beyond excuse when its margin exceeds this many condition numbers of rounding.
const DECISION_ALLOWANCE: f64 = 16.0;
/// An output is wrong when its error exceeds this many.
const OUTPUT_ALLOWANCE: f64 = 64.0;
/// A f64 sum is good to about 1 % when it is at least this share of its permanent.
const TRUSTED_SHARE: f64 = 1.0 / (1u64 << 42) as f64;

/// *Absolute* condition numbers: an input error of relative size r moves the value by up to r times
/// this. All are infinite where line and plane do not meet in one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Of the distance, in units of t.
    pub kappa_t: f64,
    /// Of the weight of b.
    pub kappa_u: f64,
    /// Of the weight of c.
    pub kappa_v: f64,
    /// Of the weight of a.
    pub kappa_w: f64,
}

/// The condition numbers at the exact answer, good to about 2 %.
pub fn condition(query: &Query, exact: &Exact) -> Condition {
    let infinite = Condition {
        kappa_t: f64::INFINITY,
        kappa_u: f64::INFINITY,
        kappa_v: f64::INFINITY,
        kappa_w: f64::INFINITY,
    };
    // A t beyond the largest float is as far out of reach as one that does not exist.
    if !exact.t.is_finite() {
        return infinite;
    }
    let [a, b, c] = query.triangle;
    let (t, u, v, w) = (exact.t.abs(), exact.u.abs(), exact.v.abs(), exact.w.abs());
    let s: [f64; 3] = std::array::from_fn(|i| {
        query.origin[i].abs()
            + t * query.direction[i].abs()
            + w * a[i].abs()
            + u * b[i].abs()
            + v * c[i].abs()
    });
    // In integers both factors are scaled by the size of s, which keeps them off the ends of the
    // exponent range.
    let (rows, s) = Rows::in_f64(query, s).map(|rows| (rows, s)).unwrap_or_else(|| {
        let size = Dyadic::of(s[0].max(s[1]).max(s[2])).size();
        (Rows::in_integers(query, size), s.map(|x| times_power_of_two(x, -size)))
    });
    let over_det =
        |row: [f64; 3]| (0..3).map(|i| row[i].abs() / rows.det.abs() * s[i]).sum::<f64>();
    Condition {
        kappa_t: over_det(rows.t),
        kappa_u: over_det(rows.u),
        kappa_v: over_det(rows.v),
        kappa_w: over_det(rows.w),
    }
}

/// Largest errors of t, u, v that rounding can explain, for a kernel of that unit roundoff
/// (2^-24 or 2^-53): 64 condition numbers times it.
pub fn output_error_limit(condition: &Condition, unit_roundoff: f64) -> [f64; 3] {
    [condition.kappa_t, condition.kappa_u, condition.kappa_v]
        .map(|kappa| OUTPUT_ALLOWANCE * kappa * unit_roundoff)
}

/// Whether rounding can explain a decision. One that is right needs no excuse.
///
/// - A false hit needs an excuse for *every* quantity that is exactly out of bounds; a false miss
///   for *any* of u, v, w, t - t_min, t_max - t, since one wrong sign suffices to lose a hit. A
///   quantity is excused within 16 condition numbers times the unit roundoff of its bound.
/// - Where |det| is at most 16 roundings of its permanent, either answer is excused: the computed
///   sign of det carries no information. An exactly degenerate, coplanar or parallel case has
///   det = 0, which always is within that; such hits are counted, not called wrong.
/// - Input that is not finite has no excuse for a hit.
pub fn excusable(query: &Query, exact: &Exact, unit_roundoff: f64, accepted: bool) -> bool {
    if accepted == exact.class.is_hit() {
        return true;
    }
    if !query.is_finite() {
        return false;
    }
    if exact.t.is_nan() || det_is_doubtful(query, unit_roundoff) {
        return true;
    }
    let kappa = condition(query, exact);
    let margins = [
        (exact.u, kappa.kappa_u),
        (exact.v, kappa.kappa_v),
        (exact.w, kappa.kappa_w),
        ((exact.t - query.t_min) + exact.t_lo, kappa.kappa_t),
        ((query.t_max - exact.t) - exact.t_lo, kappa.kappa_t),
    ];
    let close =
        |(margin, kappa): &(f64, f64)| margin.abs() <= DECISION_ALLOWANCE * kappa * unit_roundoff;
    if accepted {
        margins.iter().filter(|(margin, _)| *margin < 0.0).all(close)
    } else {
        margins.iter().any(close)
    }
}

fn det_is_doubtful(query: &Query, unit_roundoff: f64) -> bool {
    let zero = [0.0; 3];
    let rows = Rows::in_f64(query, zero).unwrap_or_else(|| Rows::in_integers(query, 0));
    rows.det.abs() <= DECISION_ALLOWANCE * unit_roundoff * rows.det_permanent
}

/// The rows of M^-1 times det, det itself, and the sum of the magnitudes that det is summed from.
/// The absolute scale is left open; only quotients are used.
struct Rows {
    t: [f64; 3],
    u: [f64; 3],
    v: [f64; 3],
    w: [f64; 3],
    det: f64,
    det_permanent: f64,
}

impl Rows {
    /// In f64, where that is good to a percent: no factor out of range, nothing cancelled. `s`
    /// are the weights with which components will be summed.
    fn in_f64(query: &Query, s: [f64; 3]) -> Option<Self> {
        let [a, b, c] = query.triangle;
        let minus = |x: [f64; 3], y: [f64; 3]| [x[0] - y[0], x[1] - y[1], x[2] - y[2]];
        let (d, e1, e2, e3) = (query.direction, minus(b, a), minus(c, a), minus(c, b));
        let in_range = |x: f64| x == 0.0 || (1e-90..1e90).contains(&x.abs());
        if ![d, e1, e2, e3].iter().flatten().all(|x| in_range(*x)) {
            return None;
        }
        let [t, u, v, w] = [
            filter::cross(e1, e2),
            filter::cross(d, e2),
            filter::cross(e1, d),
            filter::cross(d, e3),
        ];
        let det: f64 = (0..3).map(|i| e1[i] * u[i].value).sum();
        let det_permanent: f64 = (0..3).map(|i| e1[i].abs() * u[i].permanent).sum();
        let trusted = |row: &[Bounded; 3]| {
            let sum: f64 = (0..3).map(|i| row[i].value.abs() * s[i]).sum();
            let permanent: f64 = (0..3).map(|i| row[i].permanent * s[i]).sum();
            sum >= TRUSTED_SHARE * permanent
        };
        let rows = [t, u, v, w];
        if det.abs() <= TRUSTED_SHARE * det_permanent || !rows.iter().all(trusted) {
            return None;
        }
        let [t, u, v, w] = rows.map(|row| row.map(|x| x.value));
        Some(Rows { t, u, v, w, det, det_permanent })
    }

    /// The same from integers, for everything else; the rows are times `2^size`.
    fn in_integers(query: &Query, size: i64) -> Self {
        let aligned = Aligned::of(query);
        let [_, a, b, c] = aligned.positions::<IBig>();
        let d = aligned.direction::<IBig>();
        let e1 = numerators::difference(&b, &a);
        let e2 = numerators::difference(&c, &a);
        let e3 = numerators::difference(&c, &b);
        let cross = |x, y| numerators::cross::<IBig>(x, y);
        let u = cross(&d, &e2);
        let det = numerators::dot(&e1, &u);
        let permanent = permanent(&e1, &d, &e2);
        // Units: positions 2^p, direction 2^q. All is divided by 2^(bits of det), so det is near 1.
        let (p, q) = (aligned.position_exponent(), aligned.direction_exponent());
        let unit = -super::integer::Integer::bits(&det);
        let floats = |row: [IBig; 3], exponent: i64| row.map(|x| approximate(&x, exponent + unit));
        Rows {
            // row / det has the unit 2^(2p - (q + 2p)) for t, 2^(q + p - (q + 2p)) for the others.
            t: floats(cross(&e1, &e2), size - q),
            v: floats(cross(&e1, &d), size - p),
            w: floats(cross(&d, &e3), size - p),
            u: floats(u, size - p),
            det: approximate(&det, unit),
            det_permanent: approximate(&permanent, unit),
        }
    }
}

/// Sum of the magnitudes of the products of the determinant of three vectors.
fn permanent(a: &[IBig; 3], b: &[IBig; 3], c: &[IBig; 3]) -> IBig {
    use dashu_int::ops::Abs;
    let size = |v: &[IBig; 3]| [v[0].clone().abs(), v[1].clone().abs(), v[2].clone().abs()];
    let (a, b, c) = (size(a), size(b), size(c));
    let minor = |i: usize, j: usize| &b[i] * &c[j] + &b[j] * &c[i];
    &a[0] * minor(1, 2) + &a[1] * minor(2, 0) + &a[2] * minor(0, 1)
}

#[cfg(test)]
#[path = "condition_tests.rs"]
mod tests;

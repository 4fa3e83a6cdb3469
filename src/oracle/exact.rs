//! The two questions: which class, and which values.

use super::aligned::Aligned;
use super::class::Class;
use super::filter::Filtered;
use super::numerators::Numerators;
use super::query::Query;
use super::ratio;
use dashu_int::IBig;

/// The exact answer: the class, and the point where the line meets the plane.
///
/// Each value is the exact rational rounded to nearest even; its `_lo` part is the rest, rounded,
/// so that the error of a computed x is `|(x - value) - value_lo|` to about 105 bits. All are NaN
/// where line and plane do not meet in one point. For other misses they are given, too.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// Where the ray meets the triangle.
    pub class: Class,
    /// Distance in units of the direction.
    pub t: f64,
    /// Weight of b.
    pub u: f64,
    /// Weight of c.
    pub v: f64,
    /// Weight of a.
    pub w: f64,
    /// Rest of t.
    pub t_lo: f64,
    /// Rest of u.
    pub u_lo: f64,
    /// Rest of v.
    pub v_lo: f64,
    /// Rest of w.
    pub w_lo: f64,
}

impl Exact {
    /// A class without values.
    pub fn undefined(class: Class) -> Self {
        let nan = f64::NAN;
        let (t, u, v, w) = (nan, nan, nan, nan);
        Exact { class, t, u, v, w, t_lo: nan, u_lo: nan, v_lo: nan, w_lo: nan }
    }
}

/// Who decides the class of a query.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// f64 with a bound on its error.
    Filter,
    /// Integers of 128 bits.
    SmallIntegers,
    /// Integers of any size.
    BigIntegers,
}

/// The stage at which [`classify`] is certain. Input that is not finite needs none of them, and
/// counts as filtered.
pub fn stage(query: &Query) -> Stage {
    let filtered = Filtered::of(query).and_then(|f| f.class(query.t_min, query.t_max)).is_some();
    if filtered || !query.is_finite() {
        Stage::Filter
    } else if Aligned::of(query).fits_i128() {
        Stage::SmallIntegers
    } else {
        Stage::BigIntegers
    }
}

/// The class of a query, by the cheapest stage that is certain of it.
pub fn classify(query: &Query) -> Class {
    match Filtered::of(query).and_then(|f| f.class(query.t_min, query.t_max)) {
        Some(class) => class,
        None => classify_in_integers(query),
    }
}

/// The class without the filter.
pub(super) fn classify_in_integers(query: &Query) -> Class {
    if !query.is_finite() {
        return Class::Outside;
    }
    let aligned = Aligned::of(query);
    if aligned.fits_i128() {
        Numerators::<i128>::of(&aligned).class(query.t_min, query.t_max)
    } else {
        Numerators::<IBig>::of(&aligned).class(query.t_min, query.t_max)
    }
}

/// The numerators by the cheapest integers that hold them. The query must be finite.
pub(super) fn numerators(query: &Query) -> Numerators<IBig> {
    let aligned = Aligned::of(query);
    if aligned.fits_i128() {
        Numerators::<i128>::of(&aligned).big()
    } else {
        Numerators::<IBig>::of(&aligned)
    }
}

/// Class and values of a query.
pub fn solve(query: &Query) -> Exact {
    if !query.is_finite() {
        return Exact::undefined(Class::Outside);
    }
    let n = numerators(query);
    let class = n.class(query.t_min, query.t_max);
    if n.det.is_zero() {
        return Exact::undefined(class);
    }
    let (t, t_lo) = ratio::rounded(&n.t, &n.det, n.t_exponent);
    let (u, u_lo) = ratio::rounded(&n.u, &n.det, 0);
    let (v, v_lo) = ratio::rounded(&n.v, &n.det, 0);
    let (w, w_lo) = ratio::rounded(&n.w, &n.det, 0);
    Exact { class, t, u, v, w, t_lo, u_lo, v_lo, w_lo }
}

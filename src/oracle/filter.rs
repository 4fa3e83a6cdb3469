//! The determinants in f64, with a bound on their error: certain, or undecided.

use super::class::Class;
use super::query::Query;

/// Bound of a determinant's rounding error, relative to its permanent (the sum of the magnitudes
/// of its products).
///
/// Each of the six products of three factors in det, u, v, t meets these roundings, u = 2^-53 each:
/// its (up to) three factors are differences (the direction of a segment is one, too): 3; two
/// multiplications: 2; the subtraction inside the cross product: 1; two additions: 2. Together 8,
/// two more for w = det - u - v, two for `t - bound * det`. The computed permanent is itself within
/// a few u. So 12 u would do; 16 leaves room for second-order terms and for underflow (below).
const BOUND: f64 = 16.0 * UNIT_ROUNDOFF;
const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// Factors up to 2^250 keep every product finite. An inner product that underflows errs by at most
/// 2^-1074, times an outer factor 2^-824, six of them below 2^-821. The slack of [`BOUND`], 4 u of
/// a permanent of at least 2^-760, is 2^-811: more than that.
const LARGEST_FACTOR: f64 = f64::from_bits((1023 + 250) << 52);
const SMALLEST_PERMANENT: f64 = f64::from_bits((1023 - 760) << 52);
/// Bounds of t beyond 2^200 are replaced by it, so that their product with det stays finite: a t
/// inside the nearer bound is inside the farther one, and one that is not stays undecided.
const LARGEST_BOUND: f64 = f64::from_bits((1023 + 200) << 52);

/// A number, and a permanent that bounds its error: at most `BOUND * permanent`.
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    /// The computed value.
    pub value: f64,
    /// Sum of the magnitudes that it was summed from.
    pub permanent: f64,
}

impl Bounded {
    /// Certainly above 0.
    pub fn is_positive(self) -> bool {
        self.permanent >= SMALLEST_PERMANENT && self.value > BOUND * self.permanent
    }

    /// Certainly below 0.
    pub fn is_negative(self) -> bool {
        self.negated().is_positive()
    }

    fn negated(self) -> Self {
        Bounded { value: -self.value, permanent: self.permanent }
    }

    fn minus(self, other: Self) -> Self {
        Bounded { value: self.value - other.value, permanent: self.permanent + other.permanent }
    }

    fn times(self, factor: f64) -> Self {
        Bounded { value: self.value * factor, permanent: self.permanent * factor.abs() }
    }

    /// Largest error that the value can have.
    pub fn error(self) -> f64 {
        BOUND * self.permanent
    }
}

/// The numerators of `Numerators` in f64, with bounds; det is certainly positive.
#[derive(Clone, Copy, Debug)]
pub struct Filtered {
    /// Common denominator.
    pub det: Bounded,
    /// Weight of b.
    pub u: Bounded,
    /// Weight of c.
    pub v: Bounded,
    /// Distance.
    pub t: Bounded,
}

impl Filtered {
    /// `None` where the sign of det is in doubt or a range is exceeded (NaN and infinity are).
    pub fn of(query: &Query) -> Option<Self> {
        let [a, b, c] = query.triangle;
        let d = query.direction;
        let (e1, e2, s) = (difference(b, a), difference(c, a), difference(query.origin, a));
        // A comparison that NaN fails.
        let small = |v: [f64; 3]| v.iter().all(|x| x.abs() <= LARGEST_FACTOR);
        if !(small(d) && small(e1) && small(e2) && small(s)) {
            return None;
        }
        let p = cross(d, e2);
        let q = cross(s, e1);
        let det = dot(e1, p);
        let flip = det.is_negative();
        if !flip && !det.is_positive() {
            return None;
        }
        let facing = |x: Bounded| if flip { x.negated() } else { x };
        Some(Filtered {
            det: facing(det),
            u: facing(dot(s, p)),
            v: facing(dot(d, q)),
            t: facing(dot(e2, q)),
        })
    }

    /// The class where it is certain. Exact zeros never are.
    pub fn class(&self, t_min: f64, t_max: f64) -> Option<Class> {
        let w = self.det.minus(self.u).minus(self.v);
        let inside = [self.u, self.v, w];
        if inside.iter().any(|x| x.is_negative()) {
            return Some(Class::Outside);
        }
        if !inside.iter().all(|x| x.is_positive()) {
            return None;
        }
        let (above, below) = (self.beyond(t_min), self.beyond(t_max).negated());
        let certain = |bound: f64| bound.abs() <= LARGEST_BOUND;
        if (above.is_negative() && certain(t_min)) || (below.is_negative() && certain(t_max)) {
            return Some(Class::Behind);
        }
        // A stand-in nearer than the bound is good for being inside; and no t is certainly above
        // 2^200 in place of a farther t_min and certainly below it in place of a farther t_max.
        (above.is_positive() && below.is_positive()).then_some(Class::Interior)
    }

    /// `t - bound`, times det.
    fn beyond(&self, bound: f64) -> Bounded {
        self.t.minus(self.det.times(bound.clamp(-LARGEST_BOUND, LARGEST_BOUND)))
    }

    /// t, and how far from the exact t it can be.
    pub fn distance(&self) -> (f64, f64) {
        let t = self.t.value / self.det.value;
        // det is at least half of its computed value only if its bound is at most half of it.
        if self.det.error() > 0.5 * self.det.value {
            return (t, f64::INFINITY);
        }
        let error = 2.0 * (self.t.error() + t.abs() * self.det.error()) / self.det.value;
        (t, error + 4.0 * UNIT_ROUNDOFF * t.abs() + f64::MIN_POSITIVE)
    }
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a x b`, each component with the magnitudes that it was summed from.
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [Bounded; 3] {
    let minor = |i: usize, j: usize| {
        let (x, y) = (a[i] * b[j], a[j] * b[i]);
        Bounded { value: x - y, permanent: x.abs() + y.abs() }
    };
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// `a . b`, with the sum of the magnitudes.
fn dot(a: [f64; 3], b: [Bounded; 3]) -> Bounded {
    Bounded {
        value: a[0] * b[0].value + a[1] * b[1].value + a[2] * b[2].value,
        permanent: a[0].abs() * b[0].permanent
            + a[1].abs() * b[1].permanent
            + a[2].abs() * b[2].permanent,
    }
}

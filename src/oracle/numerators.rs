//! The five determinants whose signs are the answer, in integers.

use super::aligned::{Aligned, Dyadic};
use super::class::Class;
use super::integer::{Integer, compare};
use dashu_int::IBig;
use std::cmp::Ordering;

/// Numerators over one determinant: `u = u/det`, `t = t/det * 2^t_exponent` and so on.
///
/// With e1 = b - a, e2 = c - a, s = origin - a (Cramer's rule, Moeller and Trumbore 1997):
/// det = e1 . (d x e2), u = s . (d x e2), v = d . (s x e1), t = e2 . (s x e1) = s . (e1 x e2).
#[derive(Clone, Debug)]
pub struct Numerators<I> {
    /// Never negative: where it was, all five have been negated.
    pub det: I,
    /// Weight of b times det.
    pub u: I,
    /// Weight of c times det.
    pub v: I,
    /// Weight of a times det.
    pub w: I,
    /// Distance times det, in units of `2^t_exponent`.
    pub t: I,
    /// Exponent of the unit of t.
    pub t_exponent: i64,
    /// Whether the triangle has no area. Only looked at where det is 0.
    pub degenerate: bool,
}

impl<I: Integer> Numerators<I> {
    /// Evaluates them; `I` must be wide enough (see [`Aligned::fits_i128`]).
    pub fn of(aligned: &Aligned) -> Self {
        let [origin, a, b, c] = aligned.positions::<I>();
        let d = aligned.direction::<I>();
        let (e1, e2, s) = (difference(&b, &a), difference(&c, &a), difference(&origin, &a));
        let p = cross(&d, &e2);
        let q = cross(&s, &e1);
        let (det, u, v, t) = (dot(&e1, &p), dot(&s, &p), dot(&d, &q), dot(&e2, &q));
        let w = det.minus(&u).minus(&v);
        let degenerate = det.sign() == Ordering::Equal
            && cross(&e1, &e2).iter().all(|n| n.sign() == Ordering::Equal);
        let flip = det.sign() == Ordering::Less;
        let facing = |x: I| if flip { x.negated() } else { x };
        Numerators {
            t_exponent: aligned.t_exponent(),
            degenerate,
            u: facing(u),
            v: facing(v),
            w: facing(w),
            t: facing(t),
            det: facing(det),
        }
    }

    /// The class for the closed range of t, which may be infinite but not NaN.
    pub fn class(&self, t_min: f64, t_max: f64) -> Class {
        if self.det.sign() == Ordering::Equal {
            return match (self.degenerate, self.t.sign()) {
                (true, _) => Class::Degenerate,
                // t's numerator is the height of the origin over the plane.
                (false, Ordering::Equal) => Class::Coplanar,
                (false, _) => Class::Outside,
            };
        }
        let signs = [self.u.sign(), self.v.sign(), self.w.sign()];
        if signs.contains(&Ordering::Less) {
            return Class::Outside;
        }
        if self.compare_t(t_min) == Ordering::Less || self.compare_t(t_max) == Ordering::Greater {
            return Class::Behind;
        }
        match signs.iter().filter(|sign| **sign == Ordering::Equal).count() {
            0 => Class::Interior,
            1 => Class::Edge,
            _ => Class::Vertex,
        }
    }

    /// Compares t with a bound, which may be infinite. Only for det > 0.
    fn compare_t(&self, bound: f64) -> Ordering {
        if bound.is_infinite() {
            return if bound > 0.0 { Ordering::Less } else { Ordering::Greater };
        }
        let bound = Dyadic::of(bound);
        compare(&self.t, self.t_exponent, &bound.mantissa(), &self.det, bound.exponent)
    }

    /// Compares the t of two rays that share origin and direction. Only for det > 0.
    pub fn compare_t_with<J: Integer>(&self, other: &Numerators<J>) -> Ordering {
        let left = self.t.big() * other.det.big();
        compare(&left, self.t_exponent, &other.t, &self.det, other.t_exponent)
    }

    /// The same numbers as big integers.
    pub fn big(&self) -> Numerators<IBig> {
        Numerators {
            det: self.det.big(),
            u: self.u.big(),
            v: self.v.big(),
            w: self.w.big(),
            t: self.t.big(),
            t_exponent: self.t_exponent,
            degenerate: self.degenerate,
        }
    }
}

impl Dyadic {
    fn mantissa(self) -> i128 {
        i128::from(self.mantissa)
    }
}

/// `a - b`.
pub fn difference<I: Integer>(a: &[I; 3], b: &[I; 3]) -> [I; 3] {
    [a[0].minus(&b[0]), a[1].minus(&b[1]), a[2].minus(&b[2])]
}

/// `a x b`.
pub fn cross<I: Integer>(a: &[I; 3], b: &[I; 3]) -> [I; 3] {
    let minor = |i: usize, j: usize| a[i].times(&b[j]).less(a[j].times(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// `a . b`.
pub fn dot<I: Integer>(a: &[I; 3], b: &[I; 3]) -> I {
    a[0].times(&b[0]).plus(a[1].times(&b[1])).plus(a[2].times(&b[2]))
}

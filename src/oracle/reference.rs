//! The same answers derived another way, for tests: Pluecker side products for the weights and
//! homogeneous 4 x 4 determinants for the plane, over integers that are every float times 2^1074.
//! Nothing is shared with the oracle, not even the decoding of floats. Slow, on purpose.

use super::{Class, Query};
use dashu_int::IBig;
use dashu_int::ops::Abs;
use std::cmp::Ordering;

/// A quotient with a positive denominator.
pub struct Quotient {
    pub numerator: IBig,
    pub denominator: IBig,
}

/// The answer; t, u, v, w where line and plane meet in one point.
pub struct Reference {
    pub class: Class,
    pub values: Option<[Quotient; 4]>,
}

/// x * 2^1074, a whole number for every finite float.
pub fn fixed(x: f64) -> IBig {
    // Doubling is exact, so the integer part of x is found by scaling in steps that cannot round.
    let (mut x, mut scale) = (x, 1074usize);
    while scale > 0 && x.abs() < 2f64.powi(60) {
        x *= 2.0;
        scale -= 1;
    }
    // Now x is whole: either all of the scale is used up, or x has no bits below 1.
    let (mut shift, mut y) = (scale, x);
    while y.abs() >= 2f64.powi(62) {
        y /= 2.0;
        shift += 1;
    }
    IBig::from(y as i64) << shift
}

type Vector = [IBig; 3];

fn vector(p: [f64; 3]) -> Vector {
    p.map(fixed)
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

fn dot(a: &Vector, b: &Vector) -> IBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// Permuted inner product of the ray's Pluecker coordinates with those of the edge from p to q.
fn side(direction: &Vector, moment: &Vector, p: &Vector, q: &Vector) -> IBig {
    let edge = [&q[0] - &p[0], &q[1] - &p[1], &q[2] - &p[2]];
    dot(direction, &cross(p, q)) + dot(&edge, moment)
}

/// Determinant of the rows (a 1), (b 1), (c 1), (x last), by expansion along the last column.
fn determinant(a: &Vector, b: &Vector, c: &Vector, x: &Vector, last: bool) -> IBig {
    let three = |p: &Vector, q: &Vector, r: &Vector| dot(p, &cross(q, r));
    let without_last = three(b, c, x) * IBig::from(-1) + three(a, c, x) - three(a, b, x);
    if last { without_last + three(a, b, c) } else { without_last }
}

fn has_no_area(a: &Vector, b: &Vector, c: &Vector) -> bool {
    let (ab, bc, ca) = (cross(a, b), cross(b, c), cross(c, a));
    (0..3).all(|i| (&ab[i] + &bc[i] + &ca[i]).is_zero())
}

pub fn reference(query: &Query) -> Reference {
    let [a, b, c] = query.triangle.map(vector);
    let origin = vector(query.origin);
    let direction = match query.end {
        None => vector(query.direction),
        Some(end) => {
            let end = vector(end);
            [&end[0] - &origin[0], &end[1] - &origin[1], &end[2] - &origin[2]]
        }
    };
    let height = determinant(&a, &b, &c, &origin, true);
    let slope = determinant(&a, &b, &c, &direction, false);
    if slope.is_zero() {
        let class = match (has_no_area(&a, &b, &c), height.is_zero()) {
            (true, _) => Class::Degenerate,
            (false, true) => Class::Coplanar,
            (false, false) => Class::Outside,
        };
        return Reference { class, values: None };
    }
    let moment = cross(&origin, &direction);
    let w = side(&direction, &moment, &b, &c);
    let u = side(&direction, &moment, &c, &a);
    let v = side(&direction, &moment, &a, &b);
    let sum = &u + &v + &w;
    let t = quotient(-height, slope);
    let [u, v, w] = [u, v, w].map(|x| quotient(x, sum.clone()));
    let class = class(query, &t, [&u, &v, &w]);
    Reference { class, values: Some([t, u, v, w]) }
}

fn class(query: &Query, t: &Quotient, weights: [&Quotient; 3]) -> Class {
    if weights.iter().any(|x| x.numerator < IBig::ZERO) {
        return Class::Outside;
    }
    let below = query.t_min.is_finite() && compare(t, query.t_min) == Ordering::Less;
    let above = query.t_max.is_finite() && compare(t, query.t_max) == Ordering::Greater;
    if below || above || query.t_min == f64::INFINITY || query.t_max == f64::NEG_INFINITY {
        return Class::Behind;
    }
    match weights.iter().filter(|x| x.numerator.is_zero()).count() {
        0 => Class::Interior,
        1 => Class::Edge,
        _ => Class::Vertex,
    }
}

fn quotient(numerator: IBig, denominator: IBig) -> Quotient {
    if denominator < IBig::ZERO {
        Quotient { numerator: -numerator, denominator: -denominator }
    } else {
        Quotient { numerator, denominator }
    }
}

fn compare(x: &Quotient, bound: f64) -> Ordering {
    (&x.numerator << 1074).cmp(&(fixed(bound) * &x.denominator))
}

/// Whether `rounded` is the float nearest to the quotient, the even one of two: no neighbour is
/// nearer, found by comparing distances exactly.
pub fn is_nearest(x: &Quotient, rounded: f64) -> bool {
    let distance = |to: &IBig| ((&x.numerator << 1074) - to * &x.denominator).abs();
    // Beyond the largest float a next one is imagined; infinity stands for it.
    let place = |f: f64| {
        if f.is_infinite() {
            fixed(f64::MAX.copysign(f)) + fixed(2f64.powi(970).copysign(f)) * 2
        } else {
            fixed(f)
        }
    };
    if rounded.is_infinite() {
        let limit = fixed(f64::MAX) + fixed(2f64.powi(970));
        return (&x.numerator << 1074).abs() >= limit * &x.denominator
            && (x.numerator > IBig::ZERO) == (rounded > 0.0);
    }
    let mine = distance(&place(rounded));
    [rounded.next_up(), rounded.next_down()].into_iter().all(|next| {
        match mine.cmp(&distance(&place(next))) {
            Ordering::Less => true,
            Ordering::Equal => rounded.to_bits() & 1 == 0,
            Ordering::Greater => false,
        }
    })
}

/// Whether `high + low` is the quotient to 2^-104 of its size, or to the smallest subnormal.
pub fn is_sum(x: &Quotient, high: f64, low: f64) -> bool {
    let sum = fixed(high) + fixed(low);
    let error = ((&x.numerator << 1074) - sum * &x.denominator).abs();
    let allowed = ((&x.numerator << 1074) >> 104).abs() + &x.denominator;
    error <= allowed
}

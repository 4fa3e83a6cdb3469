//! Edge functions of a triangle seen along an axis, and how their signs are kept right.
//!
//! The function of an edge from p to q is p_x q_y - p_y q_x: twice the signed area that the edge
//! spans with the origin. Rounding is monotone, so where both products are rounded before they are
//! subtracted the difference has the right sign or is 0, and the neighbour, who runs through the
//! edge the other way, finds exactly the opposite number. Rounding one product only (`fused`) breaks
//! both.
//!
//! Where the difference is 0 the products were rounded to the same number, and what they differ by
//! is the difference of their rounding errors, each of which is a number of the same precision:
//! Dekker's without the instruction, one fused multiplication and addition with it. This replaces
//! the recomputation in double precision and has the same sign, and it serves f64 as well. It is
//! exact as long as the products are above 2^-102 (f32; 2^-969 in f64), where their errors are
//! representable, and the coordinates, in `plain` forms, below 2^115 (2^996), where they can be
//! split; beyond that an error that is no number leaves the 0 as it is, which counts as inside.

use crate::number::Real;
use crate::policy::{Exit, Policy, Rounding};

/// The axis `edges`.
pub trait Edges: 'static {
    /// The column `edges`.
    const NAME: &'static str;
    /// The functions of the edges from c to b, a to c and b to a: the weights of a, b and c.
    fn functions<P: Policy, R: Real>(corners: [[R; 2]; 3]) -> [R; 3];
}

/// As published: computed plainly, and again where one of them is 0.
pub struct Fallback;
/// Computed plainly only: 0 counts as inside for both neighbours, and three of them are a miss.
pub struct NoFallback;
/// The difference of the rounded products or, where that is 0, of their errors, without asking
/// first; whatever the rounding of the form, no product is fused into the difference.
pub struct ExactSign;

impl Edges for NoFallback {
    const NAME: &'static str = "no-fallback";
    #[inline(always)]
    fn functions<P: Policy, R: Real>([a, b, c]: [[R; 2]; 3]) -> [R; 3] {
        [rounded::<P, R>(c, b), rounded::<P, R>(a, c), rounded::<P, R>(b, a)]
    }
}

impl Edges for Fallback {
    const NAME: &'static str = "fallback";
    #[inline(always)]
    fn functions<P: Policy, R: Real>([a, b, c]: [[R; 2]; 3]) -> [R; 3] {
        let [u, v, w] = NoFallback::functions::<P, R>([a, b, c]);
        let zero = u.zero();
        if P::Exit::corrects(!(u.ne(zero) & v.ne(zero) & w.ne(zero))) {
            let [a, b, c]: [Split<P::Rounding, R>; 3] = [Split::of(a), Split::of(b), Split::of(c)];
            [
                nonzero::<P, R>(u, c.errors(&b, c.products(&b))),
                nonzero::<P, R>(v, a.errors(&c, a.products(&c))),
                nonzero::<P, R>(w, b.errors(&a, b.products(&a))),
            ]
        } else {
            [u, v, w]
        }
    }
}

impl Edges for ExactSign {
    const NAME: &'static str = "exact-sign";
    #[inline(always)]
    fn functions<P: Policy, R: Real>([a, b, c]: [[R; 2]; 3]) -> [R; 3] {
        let [a, b, c] = [Split::of(a), Split::of(b), Split::of(c)];
        [exact_sign::<P, R>(c, b), exact_sign::<P, R>(a, c), exact_sign::<P, R>(b, a)]
    }
}

/// A corner, and its coordinates as the errors of their products want them.
#[derive(Clone, Copy)]
struct Split<A: Rounding, R: Real> {
    at: [R; 2],
    parts: [A::Parts<R>; 2],
}

impl<A: Rounding, R: Real> Split<A, R> {
    #[inline(always)]
    fn of(at: [R; 2]) -> Self {
        Split { at, parts: [A::parts(at[0]), A::parts(at[1])] }
    }
    /// p_x q_y and p_y q_x, rounded.
    #[inline(always)]
    fn products(&self, q: &Self) -> [R; 2] {
        [self.at[0] * q.at[1], self.at[1] * q.at[0]]
    }
    /// The difference of the rounding errors of these products.
    #[inline(always)]
    fn errors(&self, q: &Self, [left, right]: [R; 2]) -> R {
        A::product_error(self.parts[0], q.parts[1], left)
            - A::product_error(self.parts[1], q.parts[0], right)
    }
}

#[inline(always)]
fn exact_sign<P: Policy, R: Real>(p: Split<P::Rounding, R>, q: Split<P::Rounding, R>) -> R {
    let [left, right] = p.products(&q);
    nonzero::<P, R>(left - right, p.errors(&q, [left, right]))
}

/// p_x q_y - p_y q_x, by the form's rounding.
#[inline(always)]
fn rounded<P: Policy, R: Real>(p: [R; 2], q: [R; 2]) -> R {
    P::difference(p[0], q[1], p[1], q[0])
}

/// `exact` where what was rounded is 0 and `exact` a number.
#[inline(always)]
fn nonzero<P: Policy, R: Real>(rounded: R, exact: R) -> R {
    let stays = rounded.ne(rounded.zero()) | exact.ne(exact);
    let [value] = P::Exit::select(stays, [rounded], [exact]);
    value
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::policy::{Early, Form, Full, Fused, Last, Plain, Tuv};
    use crate::workload::Pcg;

    type Of<X, A> = Form<X, Last, A, Tuv>;

    /// Corners whose edge functions are near 0: b and c lie almost on a line through the origin.
    fn nearly_collinear(draw: &mut Pcg) -> [[f32; 2]; 3] {
        let mut unit = || draw.below(1 << 24) as f32 / 16_777_216.0 - 0.5;
        let (a, b, factor) = ([unit(), unit()], [unit(), unit()], unit());
        let near = |x: f32, steps: u64| (0..steps).fold(x * factor, |x, _| x.next_up());
        let c = [near(b[0], draw.below(3)), near(b[1], draw.below(3))];
        [a, b, c]
    }

    /// In f64 the products of f32 are exact, and so is the sign of their difference.
    fn exact([a, b, c]: [[f32; 2]; 3]) -> [f64; 3] {
        let edge = |p: [f32; 2], q: [f32; 2]| {
            f64::from(p[0]) * f64::from(q[1]) - f64::from(p[1]) * f64::from(q[0])
        };
        [edge(c, b), edge(a, c), edge(b, a)]
    }

    fn sign(x: f64) -> i32 {
        i32::from(x > 0.0) - i32::from(x < 0.0)
    }

    /// How many signs are wrong, and how many of the exact values are not 0 though rounded ones are.
    fn wrong<E: Edges, P: Policy>() -> [usize; 2] {
        let mut draw = Pcg::new(11);
        let mut counts = [0, 0];
        for _ in 0..20_000 {
            let corners = nearly_collinear(&mut draw);
            let found = E::functions::<P, f32>(corners);
            let rounded = NoFallback::functions::<Of<Early, Plain>, f32>(corners);
            for ((found, rounded), exact) in found.into_iter().zip(rounded).zip(exact(corners)) {
                counts[0] += usize::from(sign(f64::from(found)) != sign(exact));
                counts[1] += usize::from(rounded == 0.0 && exact != 0.0);
            }
        }
        counts
    }

    #[test]
    fn signs_are_exact_with_the_fallback_and_without_it_they_are_not() {
        let [lost, tests_something] = wrong::<NoFallback, Of<Early, Plain>>();
        assert!(lost == tests_something && lost > 1_000, "{lost} {tests_something}");
        assert_eq!(wrong::<Fallback, Of<Early, Plain>>()[0], 0);
        assert_eq!(wrong::<Fallback, Of<Full, Plain>>()[0], 0);
        assert_eq!(wrong::<ExactSign, Of<Early, Plain>>()[0], 0);
        assert_eq!(wrong::<ExactSign, Of<Full, Plain>>()[0], 0);
        assert_eq!(wrong::<ExactSign, Of<Early, Fused>>()[0], 0);
        assert!(wrong::<Fallback, Of<Early, Fused>>()[0] > 0, "fused edge functions are exact?");
    }

    #[test]
    fn both_neighbours_of_an_edge_find_opposite_numbers() {
        let mut draw = Pcg::new(12);
        for _ in 0..20_000 {
            let [a, b, c] = nearly_collinear(&mut draw);
            let [u, ..] = ExactSign::functions::<Of<Early, Fused>, f32>([a, b, c]);
            let [opposite, ..] = ExactSign::functions::<Of<Early, Fused>, f32>([a, c, b]);
            assert_eq!(u, -opposite);
            let [u, ..] = Fallback::functions::<Of<Early, Plain>, f32>([a, b, c]);
            let [opposite, ..] = Fallback::functions::<Of<Early, Plain>, f32>([a, c, b]);
            assert_eq!(u, -opposite);
        }
    }

    #[test]
    fn doubles_have_exact_signs_too() {
        // (1 + e)(1 - e) = 1 - e^2 and 1: rounded, they are the same.
        let e = f64::EPSILON;
        let corners = [[0.25, 0.5], [1.0, 1.0 - e], [1.0 + e, 1.0]];
        assert_eq!(NoFallback::functions::<Of<Early, Plain>, f64>(corners)[0], -0.0 + 0.0);
        assert_eq!(Fallback::functions::<Of<Early, Plain>, f64>(corners)[0], -e * e);
        assert_eq!(ExactSign::functions::<Of<Early, Fused>, f64>(corners)[0], -e * e);
    }

    #[test]
    fn what_cannot_be_split_stays_zero_and_nan_stays_nan() {
        let large = [[1.0f32, 2.0], [f32::MAX, 1.0e-30], [f32::MAX, 1.0e-30]];
        assert_eq!(Fallback::functions::<Of<Early, Plain>, f32>(large)[0], 0.0);
        let nan = [[1.0f32, 2.0], [f32::NAN, 1.0], [1.0, 1.0]];
        assert!(Fallback::functions::<Of<Early, Plain>, f32>(nan)[0].is_nan());
    }
}

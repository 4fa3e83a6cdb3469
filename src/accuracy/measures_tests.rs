//! Measures of answers whose errors are known.

use super::{Accuracy, Measures, Reported, Truth};
use crate::job::Answer;
use crate::oracle::{Class, Query};
use crate::workload::Pcg;

const U32: f64 = 1.0 / 16_777_216.0;
const F32: Reported =
    Reported { unit_roundoff: U32, t: true, uv: true, surface: false, culls: false };
const F64: Reported = Reported { unit_roundoff: U32 * U32 / 32.0, ..F32 };

/// A triangle of legs 4 at height 2 over the origin's plane, seen along z: u, v = x / 4, y / 4.
fn over(x: f64, y: f64) -> Query {
    Query {
        origin: [x, y, 0.0],
        direction: [0.0, 0.0, 4.0],
        end: None,
        triangle: [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0]],
        t_min: 0.0,
        t_max: 1.0,
    }
}

fn hit(t: f64, u: f64, v: f64) -> Answer {
    Answer { triangle: Some(0), t, u, v, ..Answer::default() }
}

fn of(reported: Reported, cases: &[(Query, Answer)]) -> Accuracy {
    let mut measures = Measures::new(reported);
    cases.iter().for_each(|(query, answer)| measures.add(&Truth::of_query(*query), answer));
    measures.finish()
}

#[test]
fn a_right_hit_has_no_error_and_a_miss_none_to_have() {
    let accuracy =
        of(F32, &[(over(1.0, 2.0), hit(0.5, 0.25, 0.5)), (over(9.0, 9.0), Answer::default())]);
    assert_eq!((accuracy.cases, accuracy.exact_hits, accuracy.compared), (2, 1, 1));
    let zero = Some(0.0);
    assert_eq!((accuracy.mean_relative, accuracy.max_relative), (zero, zero));
    assert_eq!((accuracy.t_bits_lost_max, accuracy.uv_bits_lost_max), (zero, zero));
    assert_eq!(
        (accuracy.t_ulp.max, accuracy.barycentric.p50, accuracy.backward.max),
        (zero, zero, zero)
    );
    assert_eq!((accuracy.t_excess_max, accuracy.barycentric_excess_max), (zero, zero));
    let none = of(F32, &[(over(9.0, 9.0), Answer::default())]);
    assert_eq!((none.t_mean_relative, none.t_ulp.max, none.backward.p50), (None, None, None));
}

#[test]
fn known_errors_are_found_by_every_measure() {
    // t is 3 f32 steps of 2^-24 beyond 1/2, u of 1/4 is 8 u too small, v of 1/2 is 4 u too large.
    let (t, u, v) = (0.5 + 6.0 * U32, 0.25 - 8.0 * U32, 0.5 + 4.0 * U32);
    let accuracy = of(F32, &[(over(1.0, 2.0), hit(t, u, v))]);
    assert_eq!(accuracy.t_mean_relative, Some(12.0 * U32));
    assert_eq!(accuracy.u_mean_relative, Some(32.0 * U32));
    assert_eq!(accuracy.v_mean_relative, Some(8.0 * U32));
    assert_eq!(accuracy.mean_relative, Some((12.0 + 32.0 + 8.0) * U32 / 3.0));
    assert_eq!(accuracy.max_relative, Some(32.0 * U32));
    // One step at 1/2 is 2^-24 = u.
    assert_eq!((accuracy.t_ulp.p50, accuracy.t_ulp.max), (Some(6.0), Some(6.0)));
    // log2(1 + 6); below 1/4 a step is u/4, so 8 u are 32 steps; above 1/2, 4 u are 4.
    let near = |found: Option<f64>, wanted: f64| (found.unwrap() - wanted).abs() < 1e-12;
    assert!(near(accuracy.t_bits_lost_mean, 7f64.log2()));
    assert!(near(accuracy.uv_bits_lost_max, 33f64.log2()));
    assert!(near(accuracy.uv_bits_lost_mean, (33f64.log2() + 5f64.log2()) / 2.0));
    // w is 4 u too large: the largest error is that of u.
    assert_eq!(accuracy.barycentric.max, Some(8.0 * U32));
    assert_eq!((accuracy.u_max, accuracy.v_max), (Some(8.0 * U32), Some(4.0 * U32)));
}

#[test]
fn the_backward_error_is_that_of_the_residual() {
    // Only u is off, by 8 u: the point moves along x by 32 u, and |x| sums up to 1 + |u^ 4|.
    let accuracy = of(F32, &[(over(1.0, 2.0), hit(0.5, 0.25 - 8.0 * U32, 0.5))]);
    let size = 1.0 + 4.0 * (0.25 - 8.0 * U32);
    assert!((accuracy.backward.max.unwrap() - 32.0 / size).abs() < 1e-9);
    // Errors along the kernel of the residual are free: t and the plane's height move together
    // where the direction lies in no edge, so only a residual of zero is 0.
    let skew = Query { direction: [4.0, 0.0, 4.0], ..over(1.0, 1.0) };
    // t + d, x + 4 d in the plane of height 2: the height is off by 4 d, x by nothing.
    let d = 64.0 * U32;
    let exact = Truth::of_query(skew).exact;
    assert_eq!((exact.t, exact.u, exact.v), (0.5, 0.75, 0.25));
    let skew = Query { triangle: [[0.0, 0.0, 2.0], [8.0, 0.0, 2.0], [0.0, 8.0, 2.0]], ..skew };
    let exact = Truth::of_query(skew).exact;
    let accuracy = of(F32, &[(skew, hit(exact.t + d, exact.u + d / 2.0, exact.v))]);
    // x: 4 d - 8 d / 2 = 0; z: 4 d against 0 + 4 t^ + 2 (w^ + u^ + v^) = 2 + 4 d + 2.
    assert!((accuracy.backward.max.unwrap() - 4.0 * 64.0 / (4.0 + 4.0 * d)).abs() < 1e-9);
}

#[test]
fn the_excess_is_the_error_over_what_the_condition_allows() {
    let query = over(1.0, 2.0);
    let kappa = Truth::of_query(query).condition;
    let accuracy = of(
        F32,
        &[(query, hit(0.5 + 5.0 * kappa.kappa_t * U32, 0.25, 0.5 - 3.0 * kappa.kappa_v * U32))],
    );
    assert!((accuracy.t_excess_max.unwrap() - 5.0).abs() < 1e-9);
    // The error of w is that of v; whichever is better conditioned exceeds by more.
    let factor = (kappa.kappa_v / kappa.kappa_w).max(1.0);
    assert!((accuracy.barycentric_excess_max.unwrap() - 3.0 * factor).abs() < 1e-9);
}

#[test]
fn wrong_decisions_are_told_apart_by_depth_and_excuse() {
    let miss = Answer::default();
    // u of -1/4, and of -0.001; inside by 0.25, and by 0.001.
    let cases = [
        (over(-1.0, 1.0), hit(0.5, 0.0, 0.25)),
        (over(-0.004, 1.0), hit(0.5, 0.0, 0.25)),
        (over(1.0, 1.0), miss),
        (over(0.004, 1.0), miss),
    ];
    let accuracy = of(F32, &cases);
    assert_eq!((accuracy.false_hits, accuracy.deep_false_hits), (2, 1));
    assert_eq!((accuracy.false_misses, accuracy.deep_false_misses), (2, 1));
    assert_eq!((accuracy.inexcusable, accuracy.compared), (4, 0));
    assert_eq!(accuracy.worst_depth, Some(0.25));
    // Beyond the long edge by 2^-24 of the triangle: rounding explains that, to f64 it does not. (Of
    // the edges through the origin it would not explain anything: there, x is its own error.)
    let grazed = [(over(2.0 + 4.0 * U32, 2.0), hit(0.5, 0.5, 0.5))];
    let excused = of(F32, &grazed);
    assert_eq!((excused.false_hits, excused.inexcusable, excused.deep_false_hits), (1, 0, 0));
    assert_eq!(excused.worst_depth, Some(U32));
    assert_eq!(of(F64, &grazed).inexcusable, 1);
}

#[test]
fn the_range_of_t_has_a_depth_of_its_own() {
    let with_range = |t_min: f64, t_max: f64| Query { t_min, t_max, ..over(1.0, 1.0) };
    let answer = hit(0.5, 0.25, 0.25);
    // The farthest vertex is 3 away along x, 4 along z is one unit of t: the range ends there.
    let reach = 0.75;
    for (t_min, deep) in [(0.5 + 2e-4 * reach, 1), (0.5 + 0.5e-4 * reach, 0)] {
        let accuracy = of(F32, &[(with_range(t_min, f64::INFINITY), answer)]);
        assert_eq!((accuracy.false_hits, accuracy.deep_false_hits), (1, deep), "{t_min}");
        let depth = accuracy.worst_depth.unwrap();
        assert!((depth - (t_min - 0.5) / reach).abs() < 1e-12, "{depth}");
    }
    for (t_min, deep) in [(0.5 - 2e-4 * reach, 1), (0.5 - 0.5e-4 * reach, 0)] {
        let missed = [(with_range(t_min, f64::INFINITY), Answer::default())];
        assert_eq!(of(F32, &missed).deep_false_misses, deep, "{t_min}");
    }
}

#[test]
fn cases_on_the_boundary_are_right_either_way() {
    let mut cases = Vec::new();
    for query in [over(0.0, 1.0), over(0.0, 0.0), Query { t_max: 0.5, ..over(1.0, 1.0) }] {
        assert!(Truth::of_query(query).exact.class.is_hit());
        cases.extend([(query, Answer::default()), (query, hit(0.7, 0.1, 0.1))]);
    }
    let accuracy = of(F32, &cases);
    assert_eq!((accuracy.cases, accuracy.boundary_cases, accuracy.exact_hits), (6, 6, 6));
    assert_eq!((accuracy.false_misses, accuracy.compared, accuracy.inexcusable), (0, 0, 0));
    assert_eq!(accuracy.t_mean_relative, None);
}

#[test]
fn hits_where_nothing_is_and_outputs_that_are_nothing_are_counted() {
    let flat = Query { triangle: [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], ..over(1.0, 0.0) };
    assert_eq!(Truth::of_query(flat).exact.class, Class::Degenerate);
    let bad = Query { origin: [f64::NAN, 0.0, 0.0], ..over(1.0, 1.0) };
    let accuracy = of(
        F32,
        &[
            (flat, hit(0.5, 0.5, 0.5)),
            (bad, hit(f64::NAN, 0.5, f64::INFINITY)),
            (over(1.0, 1.0), hit(f64::NAN, 0.25, 0.25)),
        ],
    );
    assert_eq!((accuracy.false_hits, accuracy.deep_false_hits, accuracy.non_finite), (2, 0, 2));
    // Degenerate is excused, input that is not finite is not.
    assert_eq!((accuracy.inexcusable, accuracy.worst_depth), (1, None));
    assert_eq!((accuracy.compared, accuracy.t_bits_lost_max), (1, Some(24.0)));
    assert_eq!((accuracy.t_ulp.max, accuracy.barycentric.max), (None, Some(0.0)));
}

#[test]
fn outputs_that_are_not_reported_have_no_errors() {
    let silent = Reported { t: false, uv: false, ..F32 };
    let accuracy = of(silent, &[(over(1.0, 1.0), hit(f64::NAN, f64::NAN, 7.0))]);
    assert_eq!((accuracy.compared, accuracy.non_finite), (1, 0));
    assert_eq!((accuracy.t_mean_relative, accuracy.uv_bits_lost_mean), (None, None));
    let only_t = of(Reported { uv: false, ..F32 }, &[(over(1.0, 1.0), hit(0.5, 9.0, 9.0))]);
    assert_eq!(
        (only_t.t_ulp.max, only_t.mean_relative, only_t.backward.max),
        (Some(0.0), None, None)
    );
}

#[test]
fn it_does_not_matter_how_cases_are_split() {
    let mut pcg = Pcg::new(3);
    let mut share = || pcg.below(1 << 20) as f64 / f64::from(1 << 20);
    let cases: Vec<(Query, Answer)> = (0..999)
        .map(|_| {
            let (x, y) = (4.0 * share(), 2.0 * share());
            let found = hit(0.5 * (1.0 + 1e-6 * share()), x / 4.0 + 1e-7 * share(), y / 4.0);
            (over(x, y), if share() < 0.9 { found } else { Answer::default() })
        })
        .collect();
    let whole = of(F32, &cases);
    assert!(whole.compared > 500 && whole.false_misses > 10 && whole.false_hits > 100, "{whole:?}");
    for parts in [2, 3, 7] {
        let mut merged = Measures::new(F32);
        // Merged last part first.
        for part in cases.chunks(cases.len().div_ceil(parts)).rev() {
            let mut own = Measures::new(F32);
            part.iter().for_each(|(query, answer)| own.add(&Truth::of_query(*query), answer));
            merged.merge(own);
        }
        assert_eq!(merged.finish(), whole, "{parts}");
    }
}

use super::*;
use crate::oracle::{Class, classify, solve};
use crate::workload::Pcg;

const F32: f64 = f32::EPSILON as f64 / 2.0;
const F64: f64 = f64::EPSILON / 2.0;

/// A random query in the cube of side 2, aimed at a triangle that is not too thin.
fn cube(pcg: &mut Pcg) -> Query {
    let mut point = || -> [f64; 3] { std::array::from_fn(|_| 2.0 * pcg.unit_f64() - 1.0) };
    let (origin, direction, triangle) = (point(), point(), [point(), point(), point()]);
    Query { origin, direction, end: None, triangle, t_min: 0.0, t_max: f64::INFINITY }
}

/// The fifteen coordinates of a query.
fn inputs(query: &mut Query) -> Vec<&mut f64> {
    let points = query.triangle.iter_mut().flatten();
    query.origin.iter_mut().chain(&mut query.direction).chain(points).collect()
}

/// The sum of what t, u, v, w move by when each input alone is moved by a small relative amount:
/// the condition numbers by their definition, without the formulas.
fn by_differences(query: &Query) -> [f64; 4] {
    let step = 2f64.powi(-36);
    let base = solve(query);
    let mut sums = [0.0; 4];
    for index in 0..15 {
        let mut moved = *query;
        *inputs(&mut moved)[index] *= 1.0 + step;
        let moved = solve(&moved);
        let changes = [
            (moved.t - base.t) + (moved.t_lo - base.t_lo),
            (moved.u - base.u) + (moved.u_lo - base.u_lo),
            (moved.v - base.v) + (moved.v_lo - base.v_lo),
            (moved.w - base.w) + (moved.w_lo - base.w_lo),
        ];
        for (sum, change) in sums.iter_mut().zip(changes) {
            *sum += change.abs() / step;
        }
    }
    sums
}

fn kappas(query: &Query) -> [f64; 4] {
    let kappa = condition(query, &solve(query));
    [kappa.kappa_t, kappa.kappa_u, kappa.kappa_v, kappa.kappa_w]
}

fn assert_close(found: [f64; 4], expected: [f64; 4], what: &Query) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected} {what:?}");
    }
}

#[test]
fn condition_numbers_are_what_inputs_do_to_outputs() {
    let mut pcg = Pcg::new(1);
    let mut compared = 0;
    for _ in 0..2000 {
        let query = cube(&mut pcg);
        let found = kappas(&query);
        // Beyond this the step is no longer small.
        if found.iter().all(|kappa| *kappa < 1e6) {
            assert_close(found, by_differences(&query), &query);
            compared += 1;
        }
    }
    assert!(compared > 1900, "{compared}");
}

#[test]
fn condition_numbers_do_not_depend_on_scale() {
    let mut pcg = Pcg::new(2);
    for _ in 0..300 {
        let query = cube(&mut pcg);
        let expected = kappas(&query);
        // Far enough that integers take over from f64, and down to subnormals.
        for (positions, direction) in [(-980, 0), (980, 0), (0, 900), (-500, 500), (-980, -980)] {
            let mut scaled = query;
            for (index, x) in inputs(&mut scaled).into_iter().enumerate() {
                let power = if (3..6).contains(&index) { direction } else { positions };
                *x *= 2f64.powi(power);
            }
            let mut found = kappas(&scaled);
            // t is in units of the direction.
            found[0] *= 2f64.powi((direction - positions) / 2);
            found[0] *= 2f64.powi((direction - positions) - (direction - positions) / 2);
            assert_close(found, expected, &scaled);
        }
    }
}

#[test]
fn condition_numbers_survive_cancellation() {
    // A sliver whose normal is lost in f64: in integers it is not.
    let tiny = 2f64.powi(-52);
    let query = Query {
        origin: [0.25, 0.25, 1.0],
        direction: [tiny / 4.0, 0.0, -1.0],
        end: None,
        triangle: [[0.0; 3], [1.0, 1.0, 0.0], [1.0 + tiny, 1.0 - tiny, 0.0]],
        t_min: 0.0,
        t_max: 2.0,
    };
    assert!(Rows::in_f64(&query, [1.0; 3]).is_none());
    let exact = solve(&query);
    let kappa = condition(&query, &exact);
    // The height of b over the opposite edge is about 2^-52, and the point lies a quarter along.
    assert!((2f64.powi(50)..2f64.powi(54)).contains(&kappa.kappa_u), "{kappa:?}");
    assert!((0.5..8.0).contains(&kappa.kappa_t), "{kappa:?}");
}

/// A ray down onto the right triangle of legs 1 in the plane z = 0, at (x, y): u = x, v = y.
fn down(x: f64, y: f64) -> Query {
    Query {
        origin: [x, y, 1.0],
        direction: [0.0, 0.0, -1.0],
        end: None,
        triangle: [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        t_min: 0.0,
        t_max: 2.0,
    }
}

fn excused(query: &Query, unit_roundoff: f64, accepted: bool) -> bool {
    excusable(query, &solve(query), unit_roundoff, accepted)
}

/// The same with everything 8 farther along x, so that rounding x matters: kappa_u is about 16,
/// where at 0 it would be 2u.
fn shifted(x: f64, y: f64) -> Query {
    let mut query = down(x, y);
    query.origin[0] += 8.0;
    for vertex in &mut query.triangle {
        vertex[0] += 8.0;
    }
    query
}

#[test]
fn margins_within_sixteen_condition_numbers_are_excused() {
    // 16 condition numbers of 16 are 2^8: times 2^-24 that is 2^-16, times 2^-53 2^-45.
    for (x, accepted) in [(1.0, false), (-1.0, true)] {
        let at = |power: i32| shifted(x * 2f64.powi(power), 0.25);
        assert!(excused(&at(-17), F32, accepted) && !excused(&at(-15), F32, accepted));
        assert!(excused(&at(-46), F64, accepted) && !excused(&at(-44), F64, accepted));
        assert!(excused(&at(-3), F32, !accepted), "what is right needs no excuse");
    }
}

#[test]
fn a_false_hit_needs_an_excuse_for_everything_that_is_out_of_bounds() {
    let query = shifted(-1e-9, 0.5);
    assert_eq!(classify(&query), Class::Outside);
    assert!(excused(&query, F32, true), "only u is out, by next to nothing");
    let far = Query { t_max: 0.5, ..query };
    assert!(!excused(&far, F32, true), "t is out by half");
}

#[test]
fn the_range_of_t_is_judged_by_its_own_condition() {
    let near = |t_max: f64| Query { t_max, ..down(0.25, 0.25) };
    // kappa_t is 2 here: 32 roundings are excused.
    assert!(excused(&near(1.0 - 31.0 * F32), F32, true));
    assert!(!excused(&near(1.0 - 34.0 * F32), F32, true));
    assert!(excused(&near(1.0 + 31.0 * F32), F32, false));
    assert!(!excused(&near(1.0 + 34.0 * F32), F32, false));
    assert!(!excused(&near(f64::INFINITY), F32, false));
}

#[test]
fn a_determinant_within_rounding_excuses_either_answer() {
    let mut parallel = down(0.25, 0.25);
    parallel.direction = [1.0, 0.5, 0.0];
    assert!(excused(&parallel, F64, true), "exactly parallel");
    // In a level plane the small component would be det *and* its permanent: tilt it.
    parallel.triangle = [[0.0; 3], [1.0, 0.0, 1.0], [0.0, 1.0, -2.0]];
    parallel.direction = [1.0, 0.5, 1e-12];
    assert!(!classify(&parallel).is_hit());
    assert!(excused(&parallel, F32, true) && !excused(&parallel, F64, true));
    let degenerate = Query { triangle: [[0.0; 3], [1.0; 3], [2.0; 3]], ..parallel };
    assert_eq!(classify(&degenerate), Class::Degenerate);
    assert!(excused(&degenerate, F64, true));
}

#[test]
fn decisions_that_rounded_inputs_change_are_always_excused() {
    let mut pcg = Pcg::new(3);
    let mut changed = [0, 0];
    for _ in 0..40_000 {
        // Near an edge: the weight of b, of c, or of a is of the size of the rounding.
        let mut query = cube(&mut pcg);
        let [a, b, c] = query.triangle;
        let small = (pcg.unit_f64() - 0.5) * 2e-6;
        let v = pcg.unit_f64();
        query.origin = std::array::from_fn(|i| {
            a[i] + small * (b[i] - a[i]) + v * (c[i] - a[i]) - query.direction[i]
        });
        let mut rounded = query;
        for x in inputs(&mut rounded) {
            *x = f64::from(*x as f32);
        }
        let (hit, other) = (classify(&query).is_hit(), classify(&rounded).is_hit());
        if hit != other {
            assert!(excused(&query, F32, other), "{query:?}");
            changed[usize::from(hit)] += 1;
        }
    }
    assert!(changed.iter().all(|n| *n > 500), "{changed:?}");
}

#[test]
fn output_limits_are_64_condition_numbers() {
    let kappa = Condition { kappa_t: 1.0, kappa_u: 2.0, kappa_v: 4.0, kappa_w: 8.0 };
    assert_eq!(
        output_error_limit(&kappa, 2f64.powi(-24)),
        [2f64.powi(-18), 2f64.powi(-17), 2f64.powi(-16)]
    );
    let parallel = Query { direction: [1.0, 0.0, 0.0], ..down(0.25, 0.25) };
    assert_eq!(kappas(&parallel), [f64::INFINITY; 4]);
}

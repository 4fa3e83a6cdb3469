//! What the generators drew.

use super::*;
use crate::oracle::Class;
use crate::stability::draw::{Draw, normal_of};
use crate::stability::family::Case;
use glam::DVec3;

const COUNT: usize = 400;

fn cases(id: &str, knob: f64, precision: Precision) -> Vec<Case> {
    let family = find(id).expect(id);
    let mut draw = Draw::new(7, id, knob, precision);
    family.cases(&mut draw, knob, COUNT, false)
}

fn share(cases: &[Case], is: impl Fn(&Case) -> bool) -> f64 {
    cases.iter().filter(|case| is(case)).count() as f64 / cases.len() as f64
}

fn hits(cases: &[Case]) -> f64 {
    share(cases, |case| case.truth.exact.class.is_hit())
}

fn corners(case: &Case) -> [DVec3; 3] {
    case.truth.query.triangle.map(DVec3::from_array)
}

/// Median of a figure of the cases.
fn median(cases: &[Case], of: impl Fn(&Case) -> f64) -> f64 {
    let mut values: Vec<f64> = cases.iter().map(of).collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The longest edge over the height on it.
fn aspect(case: &Case) -> f64 {
    let [a, b, c] = corners(case);
    let longest = [b - a, c - a, c - b].map(DVec3::length_squared).into_iter().fold(0.0, f64::max);
    longest / (b - a).cross(c - a).length()
}

fn cosine(case: &Case) -> f64 {
    let direction = DVec3::from_array(case.truth.query.direction);
    (normal_of(&corners(case)).dot(direction) / direction.length()).abs()
}

fn is_near(measured: f64, wanted: f64) -> bool {
    (wanted / 4.0..wanted * 4.0).contains(&measured)
}

#[test]
fn ids_are_unique_and_every_knob_has_settings() {
    let all = families();
    for (index, family) in all.iter().enumerate() {
        assert!(all[..index].iter().all(|other| other.id != family.id), "{}", family.id);
        for precision in Precision::ALL {
            assert!(!(family.knobs)(precision).is_empty(), "{}", family.id);
        }
    }
}

#[test]
fn the_same_seed_draws_the_same_cases() {
    for family in families() {
        let knob = (family.knobs)(Precision::F32)[0];
        let draw = |seed: u64| {
            let mut draw = Draw::new(seed, family.id, knob, Precision::F32);
            let cases = family.cases(&mut draw, knob, 20, true);
            // As text: a NaN is not equal to itself.
            cases.iter().map(|case| format!("{:?}", case.truth.query)).collect::<String>()
        };
        let is_of_cases = matches!(family.work, Work::Aimed(_) | Work::Free(_));
        assert_eq!(draw(1), draw(1));
        assert_eq!(draw(1) != draw(2), is_of_cases, "{}", family.id);
    }
}

#[test]
fn inputs_are_rounded_to_the_precision() {
    for family in families() {
        for knob in (family.knobs)(Precision::F32) {
            let mut draw = Draw::new(3, family.id, knob, Precision::F32);
            for case in family.cases(&mut draw, knob, 5, true) {
                for query in [Some(case.truth.query), case.segment.map(|truth| truth.query)] {
                    let Some(query) = query else { continue };
                    let triangle = query.triangle.into_iter().flatten();
                    let mut all: Vec<f64> = triangle.chain(query.origin).collect();
                    all.extend(query.end.unwrap_or(query.direction));
                    let rounded = |x: &f64| x.is_nan() || f64::from(*x as f32) == *x;
                    assert!(all.iter().all(rounded), "{} {knob} {query:?}", family.id);
                }
            }
        }
    }
}

#[test]
fn half_of_the_cases_hit_where_that_can_be_had() {
    for precision in Precision::ALL {
        for (id, knob) in [
            ("benign", 0.0),
            ("needle", 4.0),
            ("cap", 4.0),
            ("mixed-scale", 4.0),
            ("tiny", 14.0),
            ("huge", 14.0),
            ("far", 3.0),
            ("gis", 3.0),
            ("far-origin", 4.0),
            ("grazing", 3.0),
            ("grazing-axis", 4.0),
            ("short-direction", 28.0),
            ("near-edge", 3.0),
            ("t-range", 3.0),
            ("random-exponents", 4.0),
        ] {
            let cases = cases(id, knob, precision);
            assert!((0.4..0.6).contains(&hits(&cases)), "{id} {precision:?} {}", hits(&cases));
            let attained = share(&cases, |case| case.attained);
            assert!(attained > 0.95, "{id} {precision:?} {attained}");
        }
    }
}

#[test]
fn knobs_are_attained() {
    let precision = Precision::F32;
    for (id, knob) in [("needle", 3.0), ("cap", 3.0), ("sliver", 3.0)] {
        assert!(is_near(median(&cases(id, knob, precision), aspect), 1e3), "{id}");
    }
    for (id, knob) in [("grazing", 3.0), ("grazing-axis", 3.0)] {
        assert!(is_near(median(&cases(id, knob, precision), cosine), 1e-3), "{id}");
    }
    let size = |case: &Case| corners(case)[0].length();
    for (id, knob, wanted) in [("tiny", 10.0, 1e-10), ("huge", 10.0, 1e10), ("far", 4.0, 1e4)] {
        assert!(is_near(median(&cases(id, knob, precision), size), wanted), "{id}");
    }
    let direction = |case: &Case| DVec3::from_array(case.truth.query.direction).length();
    assert!(is_near(median(&cases("long-direction", 12.0, precision), direction), 1e12));
    assert!(is_near(median(&cases("short-direction", 12.0, precision), direction), 1e-12));
    let near_plane = cases("near-plane", 3.0, precision);
    let t = |case: &Case| case.truth.exact.t.abs();
    assert!(is_near(median(&near_plane, t), 2e-3));
    let behind = share(&near_plane, |case| case.truth.exact.class == Class::Behind);
    assert!((0.1..0.3).contains(&behind), "{behind}");
    let near_edge = cases("near-edge", 3.0, precision);
    let least = |case: &Case| {
        let exact = &case.truth.exact;
        exact.u.abs().min(exact.v.abs()).min(exact.w.abs())
    };
    assert!(is_near(median(&near_edge, least), 1e-3 / 3.0));
    let subnormal = cases("subnormal", 42.0, precision);
    let largest = |case: &Case| corners(case)[0].abs().max_element();
    assert!(median(&subnormal, largest) < f64::from(f32::MIN_POSITIVE));
}

#[test]
fn special_cases_are_what_they_are_called() {
    for precision in Precision::ALL {
        let class = |id: &str, knob: f64, class: Class| {
            share(&cases(id, knob, precision), |case| case.truth.exact.class == class)
        };
        assert!((0.4..0.6).contains(&class("coplanar", 0.0, Class::Coplanar)));
        assert!((0.4..0.6).contains(&class("coplanar", 0.0, Class::Outside)));
        for kind in 1..=4 {
            assert_eq!(class("degenerate", f64::from(kind), Class::Degenerate), 1.0, "{kind}");
        }
        assert!(class("degenerate", 5.0, Class::Degenerate) < 0.5);
        let t_zero = cases("t-zero", 0.0, precision);
        let at_zero = |case: &Case| case.truth.exact.t == 0.0 && case.truth.exact.class.is_hit();
        assert_eq!(share(&t_zero, at_zero), 1.0);
        for kind in 1..=3 {
            let cases = cases("not-finite", f64::from(kind), precision);
            assert_eq!(share(&cases, |case| !case.truth.query.is_finite()), 1.0);
        }
        assert_eq!(
            share(&cases("not-finite", 4.0, precision), |case| case.truth.query.is_finite()),
            1.0
        );
        let aligned = cases("axis-aligned", 0.0, precision);
        let zeros = |sign: bool| {
            share(&aligned, |case| {
                let is = |x: &f64| *x == 0.0 && x.is_sign_negative() == sign;
                case.truth.query.direction.iter().any(is)
            })
        };
        assert!(zeros(true) > 0.6 && zeros(false) > 0.6);
        assert!((0.05..0.16).contains(&share(&aligned, |case| case.truth.exact.t == 0.0)));
    }
}

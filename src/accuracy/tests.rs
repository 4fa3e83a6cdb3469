//! The judge on answers that are right, wrong by a known amount, and none.

use super::{NearestTruth, Reported, Truth, judge, judge_nearest};
use crate::job::Answer;
use crate::oracle::output_error_limit;
use crate::workload::{Kind, NearestSet, NearestSpec, PairSpec, Pairs};

const F32: Reported =
    Reported { unit_roundoff: 1.0 / 16_777_216.0, t: true, uv: true, surface: false, culls: false };

fn truths() -> Vec<Truth> {
    let pairs = Pairs::draw(PairSpec::new(200, 0.5, 3)).expect("a plain specification");
    pairs.rays.iter().zip(&pairs.triangles).map(|(ray, tri)| Truth::of(ray, tri)).collect()
}

fn exact_answers(truths: &[Truth]) -> Vec<Answer> {
    let answer = |(place, truth): (usize, &Truth)| {
        let exact = &truth.exact;
        let triangle = exact.class.is_hit().then_some(place);
        Answer { triangle, t: exact.t, u: exact.u, v: exact.v, ..Answer::default() }
    };
    truths.iter().enumerate().map(answer).collect()
}

fn first(truths: &[Truth], hit: bool) -> usize {
    truths.iter().position(|truth| truth.exact.class.is_hit() == hit).expect("half of them hit")
}

#[test]
fn exact_answers_are_right() {
    let truths = truths();
    let judgement = judge(&exact_answers(&truths), &truths, F32);
    assert_eq!(
        (
            judgement.accuracy.false_hits,
            judgement.accuracy.false_misses,
            judgement.accuracy.non_finite
        ),
        (0, 0, 0)
    );
    assert_eq!(judgement.wrong, None);
    assert!(judgement.accuracy.t_mean_relative.is_some_and(|mean| mean < 1e-15));
}

#[test]
fn a_decision_that_rounding_cannot_explain_is_wrong() {
    let truths = truths();
    for hit in [true, false] {
        let place = first(&truths, hit);
        let mut answers = exact_answers(&truths);
        answers[place].triangle = (!hit).then_some(place);
        let judgement = judge(&answers, &truths, F32);
        let counts = (judgement.accuracy.false_hits, judgement.accuracy.false_misses);
        assert_eq!(counts, if hit { (0, 1) } else { (1, 0) });
        let reason = judgement.wrong.expect("pairs are clear of their boundaries");
        assert!(reason.contains(&format!("item {place}:")), "{reason}");
    }
}

#[test]
fn outputs_are_wrong_beyond_their_limit_and_only_there() {
    let truths = truths();
    let place = first(&truths, true);
    let limit = output_error_limit(&truths[place].condition, F32.unit_roundoff)[1];
    for (factor, is_wrong) in [(0.99, false), (1.01, true)] {
        let mut answers = exact_answers(&truths);
        answers[place].u += factor * limit;
        let judgement = judge(&answers, &truths, F32);
        assert_eq!(judgement.wrong.is_some(), is_wrong, "{factor}");
        // A form that does not report u is not judged by it.
        let silent = Reported { uv: false, ..F32 };
        assert_eq!(judge(&answers, &truths, silent).wrong, None);
    }
}

#[test]
fn an_output_that_is_no_number_is_wrong() {
    let truths = truths();
    let place = first(&truths, true);
    for bad in [f64::NAN, f64::INFINITY] {
        let mut answers = exact_answers(&truths);
        answers[place].t = bad;
        let judgement = judge(&answers, &truths, F32);
        assert_eq!(judgement.accuracy.non_finite, 1);
        assert!(judgement.wrong.is_some());
    }
}

#[test]
fn a_point_or_normal_that_is_off_is_wrong() {
    let truths = truths();
    let surface = Reported { surface: true, ..F32 };
    let of = |truth: &Truth| {
        let [o, d] = [truth.query.origin, truth.query.direction].map(glam::DVec3::from_array);
        let [a, b, c] = truth.query.triangle.map(glam::DVec3::from_array);
        (o + d * truth.exact.t, (b - a).cross(c - a))
    };
    let mut answers = exact_answers(&truths);
    for (answer, truth) in answers.iter_mut().zip(&truths) {
        let (point, normal) = of(truth);
        (answer.point, answer.normal) = (point.to_array(), (normal * 3.0).to_array());
    }
    assert_eq!(judge(&answers, &truths, surface).wrong, None);
    let place = first(&truths, true);
    let (point, normal) = of(&truths[place]);
    for (point, normal) in [(point + 0.01, normal), (point, -normal), (point, normal * f64::NAN)] {
        let mut answers = answers.clone();
        (answers[place].point, answers[place].normal) = (point.to_array(), normal.to_array());
        assert!(judge(&answers, &truths, surface).wrong.is_some());
        assert_eq!(judge(&answers, &truths, F32).wrong, None);
    }
}

#[test]
fn culling_wants_only_front_faces() {
    let truths = truths();
    let culls = Reported { culls: true, ..F32 };
    let backs = truths.iter().filter(|t| t.exact.class.is_hit() && !t.front).count() as u64;
    assert!(backs >= 20, "{backs} of 100 hits see the back");
    let judgement = judge(&exact_answers(&truths), &truths, culls);
    assert_eq!(judgement.accuracy.false_hits, backs);
    assert!(judgement.wrong.is_some());
}

#[test]
fn nearest_hits_are_told_apart_by_their_triangle() {
    let spec = NearestSpec { triangles: 64, rays: 16, kind: Kind::Random, spread: 0.0, seed: 5 };
    let set = NearestSet::draw(spec).expect("a plain specification");
    let truth = NearestTruth::of(&set.rays, &set.triangles);
    let answer = |found: &Option<(usize, crate::oracle::Exact)>| match found {
        Some((index, e)) => {
            Answer { triangle: Some(*index), t: e.t, u: e.u, v: e.v, ..Answer::default() }
        }
        None => Answer::default(),
    };
    let mut answers: Vec<Answer> = truth.any.iter().map(answer).collect();
    let scene = (set.rays.as_slice(), set.triangles.as_slice());
    assert_eq!(judge_nearest(&answers, &truth.any, scene, F32).wrong, None);
    let place = answers.iter().position(|a| a.triangle.is_some()).expect("some ray hits");
    answers[place].triangle = answers[place].triangle.map(|index| (index + 1) % 64);
    let judgement = judge_nearest(&answers, &truth.any, scene, F32);
    assert_eq!(judgement.accuracy.false_hits, 1);
    assert!(judgement.wrong.is_some_and(|reason| reason.contains(&format!("ray {place}:"))));
}

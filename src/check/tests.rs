//! Numbers, judgements and segments, each expectation worked out by hand.

use super::segment::Segment;
use super::*;
use crate::number::Precision::{self, F32, F64};
use crate::oracle::{Class, Query};

/// 2^power.
fn two(power: i32) -> f64 {
    libm::scalbn(1.0, power)
}

/// Hits the triangle (0,0,0), (1,0,0), (0,1,0) from above at t = 1/2, u = 1/4, v = 1/2.
const HIT: Query = Query {
    origin: [0.25, 0.5, 1.0],
    direction: [0.0, 0.0, -2.0],
    end: None,
    triangle: [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    t_min: 0.0,
    t_max: f64::INFINITY,
};

fn reply(t: f64, u: f64, v: f64) -> Reply {
    Reply { hit: true, t: Some(t), u: Some(u), v: Some(v) }
}

fn judged(reply: Reply, query: Query, precision: Precision) -> Judged {
    Judged::of(&reply, &Known::of_ray(query, precision))
}

#[test]
fn the_last_place_is_that_of_the_exact_value() {
    assert_eq!(F32.ulp(1.0, 0.0), two(-23));
    assert_eq!(F32.ulp(1.999, 0.0), two(-23));
    assert_eq!(F64.ulp(-1.0, 0.0), two(-52));
    // A little less than 1 is in the binade below, on either side of 0.
    assert_eq!(F32.ulp(1.0, -two(-60)), two(-24));
    assert_eq!(F32.ulp(-1.0, two(-60)), two(-24));
    assert_eq!(F32.ulp(1.0, two(-60)), two(-23));
    // Subnormal numbers and 0 have the place of the smallest normal one.
    assert_eq!(F32.ulp(two(-126), 0.0), two(-149));
    assert_eq!(F32.ulp(two(-140), 0.0), two(-149));
    assert_eq!(F32.ulp(0.0, 0.0), two(-149));
    assert_eq!(F64.ulp(two(-1030), 0.0), two(-1074));
    assert_eq!(F64.ulp(0.0, 0.0), two(-1074));
}

#[test]
fn a_decimal_is_rounded_once() {
    // 1 + 2^-24 and a little more: the nearest f32 is 1 + 2^-23, the nearest f64 is 1 + 2^-24
    // itself, from which a second rounding would go to 1.
    let number = Number::read("1.0000000596046447753906251").expect("a number");
    assert_eq!(number.get(F32), 1.0 + two(-23));
    assert_eq!(number.get(F64), 1.0 + two(-24));
}

#[test]
fn words_that_are_no_numbers_are_not_read_as_some() {
    for word in ["", "abc", "1,5", "0x10", "1 2", "--1"] {
        assert_eq!(Number::read(word), None, "{word}");
    }
    for (word, value) in [("1e400", f64::INFINITY), ("-inf", f64::NEG_INFINITY), ("-0.0", 0.0)] {
        assert_eq!(Number::read(word).map(|x| x.get(F64)), Some(value), "{word}");
    }
    assert!(Number::read("NaN").is_some_and(|x| x.get(F32).is_nan()));
    assert_eq!(Number::read("1e39").map(|x| x.get(F32)), Some(f64::INFINITY));
}

#[test]
fn errors_are_counted_in_the_last_place_of_the_precision() {
    // Last places in f32: of the t 1/2 2^-24, of 1 2^-23.
    let off = reply(0.5 + 3.0 * two(-24), 0.25 - two(-25), 0.5 - 2.0 * two(-24));
    let single = judged(off, HIT, F32);
    assert_eq!(single.errors_ulp, [Some(3.0), Some(0.25), Some(1.0)]);
    // 29 bits lie between the two precisions.
    let double = judged(off, HIT, F64);
    assert_eq!(double.errors_ulp, [3.0, 0.25, 1.0].map(|x| Some(x * two(29))));
    // u is off by -2^-25 and v by -2^-23, so the weight of a by their sum.
    assert_eq!(single.barycentric_error, Some(two(-25) + two(-23)));
    assert_eq!(single.verdict, Verdict::Agree);
}

#[test]
fn what_an_exact_value_has_beyond_f64_counts() {
    // t = 1/3. In f32 that is 11184811 / 2^25, which is 1 / (3 2^25) more; its last place is 2^-25.
    let third = Query { direction: [0.0, 0.0, -3.0], ..HIT };
    let single = judged(reply(f64::from(1.0_f32 / 3.0), 0.25, 0.5), third, F32);
    let error = single.errors_ulp[0].expect("both are hits");
    assert!((error - 1.0 / 3.0).abs() < two(-50), "{error}");
    // In f64 it is 1 / (3 2^54) less, with a last place of 2^-54.
    let double = judged(reply(1.0 / 3.0, 0.25, 0.5), third, F64);
    let error = double.errors_ulp[0].expect("both are hits");
    assert!((error - 1.0 / 3.0).abs() < two(-50), "{error}");
}

#[test]
fn decisions_are_held_against_the_closed_triangle() {
    let miss = Reply::default();
    let hit = reply(0.5, 0.25, 0.5);
    let edge = Query { origin: [0.5, 0.5, 1.0], ..HIT };
    let outside = Query { origin: [0.6, 0.5, 1.0], ..HIT };
    assert_eq!(judged(hit, edge, F64).verdict, Verdict::Agree);
    assert_eq!(judged(miss, edge, F64).verdict, Verdict::FalseMiss);
    assert_eq!(judged(hit, outside, F64).verdict, Verdict::FalseHit);
    assert_eq!(judged(miss, outside, F64).verdict, Verdict::Agree);
    // Without two hits there is nothing to be off by, and a miss has no outputs.
    assert_eq!(judged(hit, outside, F64).errors_ulp, [None; 3]);
    let missed = judged(Reply { hit: false, ..hit }, HIT, F64);
    assert_eq!((missed.values, missed.errors_ulp), ([None; 3], [None; 3]));
}

#[test]
fn outputs_that_are_not_finite_are_named_and_nowhere_else() {
    let nan = judged(reply(f64::NAN, 0.25, f64::INFINITY), HIT, F32);
    assert_eq!(nan.non_finite_names(), "t v");
    assert_eq!(nan.values, [None, Some(0.25), None]);
    assert_eq!(nan.errors_ulp, [None, Some(0.0), None]);
    assert_eq!((nan.barycentric_error, nan.verdict), (None, Verdict::Agree));
    // What is not reported is not NaN.
    let silent = judged(Reply { hit: true, ..Reply::default() }, HIT, F32);
    assert_eq!((silent.non_finite_names(), silent.values), ("", [None; 3]));
}

#[test]
fn input_that_is_not_finite_is_undefined_whatever_is_said() {
    for bad in [
        Query { origin: [f64::NAN, 0.5, 1.0], ..HIT },
        Query { direction: [0.0, 0.0, f64::NEG_INFINITY], ..HIT },
        Query { t_max: f64::NAN, ..HIT },
    ] {
        let known = Known::of_ray(bad, F32);
        assert_eq!((known.place, known.values()), (Place::NotFinite, [None; 3]));
        for reply in [Reply::default(), reply(1.0, 0.5, 0.5)] {
            let judged = Judged::of(&reply, &known);
            assert_eq!(judged.verdict, Verdict::Undefined);
            assert_eq!(judged.errors_ulp, [None; 3]);
        }
        assert_eq!(known.of_segment().place, Place::NotFinite);
    }
}

#[test]
fn a_segment_ends_behind_the_plane_and_counts_back_exactly() {
    let known = Known::of_ray(HIT, F32);
    // 2 is the power of two above 2 t = 1; half of the way would not reach as far as the origin is.
    let segment = Segment::along(&HIT, 0.5, F32);
    assert_eq!((segment.unit, segment.query.end), (2.0, Some([0.25, 0.5, -3.0])));
    assert_eq!(segment.query.direction, [0.0, 0.0, -4.0]);
    assert_eq!((segment.query.t_min, segment.query.t_max), (0.0, 1.0));
    let exact = known.of_segment();
    assert_eq!((exact.place, exact.values()), (known.place, known.values()));
    // The range of t is the ray's: 1/2 is outside [0, 3/8].
    let short = Known::of_ray(Query { t_max: 0.375, ..HIT }, F32);
    assert_eq!(short.of_segment().query.t_max, 0.1875);
    assert_eq!(short.of_segment().place, Place::Of(Class::Behind));
}

#[test]
fn a_segment_goes_backwards_where_a_negative_t_counts() {
    let back = Query { direction: [0.0, 0.0, 2.0], t_min: -1.0, ..HIT };
    let known = Known::of_ray(back, F64);
    assert_eq!(known.place, Place::Of(Class::Interior));
    let segment = known.of_segment();
    assert_eq!(segment.query.end, Some([0.25, 0.5, -3.0]));
    assert_eq!((segment.query.t_min, segment.query.t_max), (0.0, 0.5));
    assert_eq!((segment.place, segment.values()), (known.place, known.values()));
    let forward = Known::of_ray(Query { t_min: 0.0, ..back }, F64).of_segment();
    assert_eq!(forward.place, Place::Of(Class::Behind));
    assert_eq!(forward.values()[0], Some(-0.5));
}

#[test]
fn a_segment_does_not_leave_the_range_of_the_precision() {
    // Eight times the direction, 4 t, would end at -7e38; four times is behind the plane as well.
    let [far, large] = [1e38, 3e38].map(|x| F32.round(x));
    let query = Query {
        origin: [far * 0.25, far * 0.25, far],
        direction: [0.0, 0.0, -far],
        triangle: [[0.0, 0.0, -far], [large, 0.0, -far], [0.0, large, -far]],
        ..HIT
    };
    let segment = Segment::along(&query, 2.0, F32);
    assert_eq!(segment.unit, 4.0);
    assert_eq!(Known::of_ray(query, F32).of_segment().place, Place::Of(Class::Interior));
    // A line that meets the plane beyond all numbers, and one without a direction.
    let grazing = Query { direction: [1e30, 0.0, -1e-38], ..HIT };
    assert_eq!(Known::of_ray(grazing, F32).of_segment().place, Place::Of(Class::Outside));
    let still = Query { direction: [0.0; 3], ..HIT };
    assert_eq!(Known::of_ray(still, F32).of_segment().place, Place::Of(Class::Outside));
}

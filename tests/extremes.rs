//! Inputs from the whole range of the floating-point numbers: no kernel reports a hit that is not
//! finite, and a number that is none is a miss. Forms kept as published are exempt: what they do is
//! a finding.

use ray_test::oracle::Query;
use ray_test::registry::{Asked, asked};
use ray_test::workload::Pcg;

const CASES: usize = 6_000;

/// How an extreme case is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Family {
    /// Every coordinate of an exponent of its own.
    Exponents,
    /// One exponent for the triangle, one for the direction's length: hits are common.
    Scales,
    /// Coordinates around the smallest and below it.
    Subnormal,
    /// The largest numbers.
    Huge,
    /// Any of them with a zero, an infinity or the largest number here and there.
    Special,
}

const FAMILIES: [Family; 5] =
    [Family::Exponents, Family::Scales, Family::Subnormal, Family::Huge, Family::Special];

/// The exponents of the smallest subnormal and of the largest number, and that of the smallest
/// normal one.
struct Range {
    lowest: i64,
    normal: i64,
    highest: i64,
}

fn range(precision: &str) -> Range {
    if precision == "f32" {
        Range { lowest: -149, normal: -126, highest: 127 }
    } else {
        Range { lowest: -1074, normal: -1022, highest: 1023 }
    }
}

/// 2^exponent, subnormal ones included: two factors, since 2^-1074 is not the reciprocal of a
/// finite number.
fn power(exponent: i64) -> f64 {
    let half = exponent / 2;
    2.0f64.powi(half as i32) * 2.0f64.powi((exponent - half) as i32)
}

fn between(draw: &mut Pcg, low: i64, high: i64) -> i64 {
    low + draw.below((high - low + 1) as u64) as i64
}

/// In [-1, 1), 24 digits.
fn unit(draw: &mut Pcg) -> f64 {
    draw.below(1 << 24) as f64 / 8_388_608.0 - 1.0
}

fn number(draw: &mut Pcg, family: Family, scale: i64, range: &Range) -> f64 {
    let special = draw.below(12);
    match family {
        Family::Special if special < 5 => {
            let largest = (2.0 - power(-23)) * power(range.highest);
            [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, largest][special as usize]
        }
        Family::Exponents | Family::Special => {
            unit(draw) * power(between(draw, range.lowest, range.highest))
        }
        _ => unit(draw) * power(scale),
    }
}

/// A ray, every second one aimed at the triangle as well as its numbers allow.
fn case(draw: &mut Pcg, family: Family, range: &Range) -> Query {
    let (low, high) = match family {
        Family::Subnormal => (range.lowest, range.normal + 3),
        Family::Huge => (range.highest - 3, range.highest),
        _ => (range.lowest, range.highest),
    };
    let scale = between(draw, low, high);
    let mut point =
        |scale| -> [f64; 3] { std::array::from_fn(|_| number(draw, family, scale, range)) };
    let triangle = [point(scale), point(scale), point(scale)];
    let (origin, free) = (point(scale), point(scale));
    let aimed = draw.below(2) == 0;
    let (u, v) = (draw.below(9) as f64 / 16.0, draw.below(9) as f64 / 16.0);
    let stretch = power(between(draw, -40, 40));
    let direction = std::array::from_fn(|i| {
        let [a, b, c] = triangle.map(|corner| corner[i]);
        // In parts, so that the largest numbers do not overflow before they are rounded.
        let target = a * (1.0 - u - v) + b * u + c * v;
        if aimed { (target * 0.25 - origin[i] * 0.25) * stretch } else { free[i] }
    });
    let t_min = [0.0, 0.0, 0.5, f64::NEG_INFINITY][draw.below(4) as usize];
    let t_max = [1.0, f64::INFINITY, f64::INFINITY, 1e30][draw.below(4) as usize];
    Query { origin, direction, end: None, triangle, t_min, t_max }
}

fn is_published(asked: &Asked) -> bool {
    let listings = ["moller0", "moller1", "moller2", "moller3", "badouel", "chirkov-line"];
    listings.contains(&asked.axes.kernel) || ["sign-bits", "products"].contains(&asked.axes.tests)
}

/// Hits of a form over all families; the first that is not finite ends the test.
fn hits(asked: &Asked) -> [usize; FAMILIES.len()] {
    let range = range(asked.axes.precision);
    let mut draw = Pcg::new(21);
    FAMILIES.map(|family| {
        let mut hits = 0;
        for _ in 0..CASES {
            let query = case(&mut draw, family, &range);
            let answer = (asked.ask)(&query);
            let finite = [answer.t, answer.u, answer.v].iter().all(|x| x.is_finite());
            assert!(
                answer.triangle.is_none() || finite,
                "{} reports t {} u {} v {} of {family:?} {query:?}",
                asked.id(),
                answer.t,
                answer.u,
                answer.v,
            );
            hits += usize::from(answer.triangle.is_some());
        }
        hits
    })
}

#[test]
fn a_hit_is_finite_whatever_the_input() {
    let mut sums = [0; FAMILIES.len()];
    let mut forms = 0;
    for asked in asked().iter().filter(|asked| !is_published(asked)) {
        let hits = hits(asked);
        assert!(hits[1] > 100, "{}: {hits:?} hits", asked.id());
        sums.iter_mut().zip(hits).for_each(|(sum, hits)| *sum += hits);
        forms += 1;
    }
    println!("{forms} forms, hits by family: {sums:?}");
    assert!(sums.iter().all(|sum| *sum > 100), "{sums:?}");
}

#[test]
fn a_nan_anywhere_is_a_miss() {
    const HIT: Query = Query {
        origin: [0.9, 0.8, 0.1],
        direction: [0.1, 0.2, 4.0],
        end: None,
        triangle: [[0.0, 0.0, 2.0], [4.0, 0.5, 2.5], [0.5, 4.0, 3.0]],
        t_min: 0.25,
        t_max: 100.0,
    };
    // Every cyclic order of the axes, and every rotation of the corners.
    let turned = |turn: usize, rotation: usize| {
        let mut query = HIT;
        for vector in
            [&mut query.origin, &mut query.direction].into_iter().chain(&mut query.triangle)
        {
            vector.rotate_left(turn);
        }
        query.triangle.rotate_left(rotation);
        query
    };
    for asked in asked().iter().filter(|asked| !is_published(asked)) {
        for (turn, rotation) in (0..9).map(|i| (i / 3, i % 3)) {
            let query = turned(turn, rotation);
            assert!((asked.ask)(&query).triangle.is_some(), "{}", asked.id());
            for place in 0..17 {
                let mut query = query;
                match place {
                    0..3 => query.origin[place] = f64::NAN,
                    3..6 => query.direction[place - 3] = f64::NAN,
                    6..15 => query.triangle[place / 3 - 2][place % 3] = f64::NAN,
                    15 => query.t_min = f64::NAN,
                    _ => query.t_max = f64::NAN,
                }
                let answer = (asked.ask)(&query);
                assert_eq!(answer.triangle, None, "{}: place {place} of {query:?}", asked.id());
            }
        }
    }
}

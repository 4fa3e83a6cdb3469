//! What the techniques promise that no law covers: sign bits decide as comparisons do, estimated
//! reciprocals are as exact as their levels say, and neither lets a number that is not finite out.

use std::collections::BTreeMap;

use glam::Vec3;
use ray_test::job::{Answer, Block};
use ray_test::policy::{Between, Compare, FromZero, SignBitsSafe, Tests};
use ray_test::registry::{Axes, Variant, find, variants};
use ray_test::workload::{Kind, NearestSet, NearestSpec, Pcg, Ray, Triangle};

/// Numbers at which a comparison can go wrong.
const SPECIAL: [f32; 19] = [
    0.0,
    -0.0,
    1e-45,
    -1e-45,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    0.5,
    -0.5,
    0.99999994,
    1.0,
    -1.0,
    1.0000001,
    2.0,
    f32::MAX,
    -f32::MAX,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
    -f32::NAN,
];

/// What can stand for 1, or bound a range: finite.
fn bounds() -> impl Iterator<Item = f32> {
    SPECIAL.into_iter().filter(|x| x.is_finite())
}

/// NaN is refused where all tests are over; see the tests of whole forms below.
#[test]
fn safe_sign_bits_decide_as_comparisons_do() {
    let mut hits = [0; 4];
    let numbers: Vec<f32> = SPECIAL.into_iter().filter(|x| !x.is_nan()).collect();
    for one in bounds().filter(|one| *one > 0.0) {
        for (u, v) in numbers.iter().flat_map(|u| numbers.iter().map(move |v| (*u, *v))) {
            for mask in [false, true] {
                let inside = Compare::inside(mask, u, v, one);
                let safe = SignBitsSafe::inside(mask, u, v, one);
                assert_eq!(safe, inside, "inside {u} {v} {one} where {mask}");
                let both = Compare::beside(Compare::share(mask, u, one), u, v, one);
                let share = SignBitsSafe::share(mask, u, one);
                let safe = SignBitsSafe::beside(share, u, v, one);
                assert_eq!(safe, both, "share and beside {u} {v} {one} where {mask}");
                // A form that asks at the end leaves it to the sum that u is at most 1.
                let sum = Compare::beside(Compare::ahead(mask, u), u, v, one);
                let safe = SignBitsSafe::beside(SignBitsSafe::ahead(mask, u), u, v, one);
                assert_eq!([sum, safe], [both; 2], "ahead and beside {u} {v} {one} where {mask}");
                hits[0] += usize::from(inside);
                hits[1] += usize::from(both);
            }
        }
    }
    for (lower, upper) in bounds().flat_map(|lower| bounds().map(move |upper| (lower, upper))) {
        for t in numbers.iter().copied() {
            let from_zero = Compare::range::<FromZero, f32>(t, 0.0, upper);
            let safe = SignBitsSafe::range::<FromZero, f32>(t, 0.0, upper);
            assert_eq!(safe, from_zero, "{t} up to {upper}");
            let between = Compare::range::<Between, f32>(t, lower, upper);
            let safe = SignBitsSafe::range::<Between, f32>(t, lower, upper);
            assert_eq!(safe, between, "{t} in {lower} {upper}");
            for mask in [true, false] {
                let (bits, compared) = (SignBitsSafe::ahead(mask, t), Compare::ahead(mask, t));
                assert_eq!(bits, compared, "{t} ahead where {mask}");
            }
            hits[2] += usize::from(from_zero);
            hits[3] += usize::from(between);
        }
    }
    assert!(hits.iter().all(|hits| *hits > 100), "{hits:?}");
}

/// Variants whose tests are not comparisons, each with its own form that compares; where there is none
/// in the same order of the tests, in the kernel's own.
fn tested() -> impl Iterator<Item = [&'static Variant; 2]> {
    let others = variants().iter().filter(|variant| {
        let axes = &variant.axes;
        axes.tests != "compare" && axes.query == "ray" && (variant.available)()
    });
    others.map(|variant| {
        let id = Axes { tests: "compare", ..variant.axes.clone() }.id();
        let compares = find(&id).or_else(|| find(&id.replace("/leading=inside", "")));
        [variant, compares.unwrap_or_else(|| panic!("{}: no {id}", variant.id()))]
    })
}

#[test]
fn clear_of_boundaries_all_tests_find_the_same() {
    let mut hits = 0;
    for kind in [Kind::Random, Kind::Coherent] {
        let set =
            NearestSet::draw(NearestSpec { triangles: 45, rays: 128, kind, spread: 0.0, seed: 3 })
                .expect("a plain specification");
        for [variant, comparing] in tested() {
            let found = answers(variant, &set.rays, &set.triangles);
            let expected = answers(comparing, &set.rays, &set.triangles);
            for (found, expected) in found.iter().zip(&expected) {
                assert_eq!(found.triangle, expected.triangle, "{}", variant.id());
                hits += usize::from(found.triangle.is_some());
            }
        }
    }
    assert!(hits > 50 * tested().count(), "{hits} hits");
}

#[test]
fn safe_sign_bits_find_what_comparisons_find_bit_for_bit() {
    let (mut draw, mut hits, mut forms) = (Pcg::new(12), 0, 0);
    for (rays, triangle) in extremes(&mut draw) {
        for [variant, comparing] in tested() {
            if variant.axes.tests != "sign-bits-safe" {
                continue;
            }
            let found = answers(variant, &rays, &[triangle]);
            let expected = answers(comparing, &rays, &[triangle]);
            for (found, expected) in found.iter().zip(&expected) {
                assert_eq!(bits(found), bits(expected), "{} {triangle:?}", variant.id());
                hits += usize::from(found.triangle.is_some());
            }
            forms += 1;
        }
    }
    assert!(hits > forms, "{hits} hits in {forms} runs");
}

/// Rays in and beside the plane of a triangle, along it: every determinant is 0, numerators are 0 or have
/// either sign.
fn parallel_to_a_triangle() -> (Vec<Ray>, Triangle) {
    let triangle = Triangle { a: Vec3::ZERO, b: Vec3::X, c: Vec3::Y };
    let (places, mut rays) = ([-1.0, -0.0, 0.0, 0.25, 0.5, 1.0], Vec::new());
    for (x, y) in places.iter().flat_map(|x| places.iter().map(move |y| (*x, *y))) {
        for z in [-1.0, 0.0, 1.0] {
            let origin = Vec3::new(x, y, z);
            for direction in [Vec3::X, -Vec3::X, Vec3::Y, Vec3::new(1.0, -1.0, 0.0)] {
                let end = origin + direction;
                rays.push(Ray { origin, direction, end, t_min: 0.0, t_max: f32::MAX });
            }
        }
    }
    (rays, triangle)
}

#[test]
fn a_determinant_of_zero_is_refused_by_tests_that_do_not_ask_for_it() {
    let (rays, triangle) = parallel_to_a_triangle();
    let triangles = vec![triangle; rays.len()];
    let mut forms = 0;
    for [variant, _] in tested().filter(|[variant, _]| variant.axes.tests == "sign-bits-safe") {
        let found = answers(variant, &rays, &[triangle]);
        let hit = found.iter().position(|answer| answer.triangle.is_some());
        assert_eq!(hit.map(|place| rays[place]), None, "{}", variant.id());
        if let Some(bind) = &variant.pairs {
            let mut job = bind(&rays, &triangles);
            assert_eq!(job.run(Block::whole(job.as_ref())).hits, 0, "{}", variant.id());
        }
        forms += 1;
    }
    assert!(forms > 0);
}

/// The triangle of a hit, and the bits of t, u and v.
fn bits(answer: &Answer) -> Option<(usize, [u64; 3])> {
    let Answer { t, u, v, triangle, .. } = answer;
    triangle.map(|triangle| (triangle, [t, u, v].map(|x| x.to_bits())))
}

/// Variants with estimated reciprocals, each with its own form that divides; and how many this
/// processor has not got.
fn estimated() -> (Vec<[&'static Variant; 2]>, usize) {
    let all: Vec<&Variant> =
        variants().iter().filter(|variant| variant.axes.reciprocal != "divide").collect();
    let here = all.iter().filter(|variant| (variant.available)());
    let pairs: Vec<[&Variant; 2]> = here
        .map(|variant| {
            let id = Axes { reciprocal: "divide", ..variant.axes.clone() }.id();
            [*variant, find(&id).unwrap_or_else(|| panic!("{}: no {id}", variant.id()))]
        })
        .collect();
    let missing = all.len() - pairs.len();
    (pairs, missing)
}

fn answers(variant: &Variant, rays: &[Ray], triangles: &[Triangle]) -> Vec<Answer> {
    let bind = variant.nearest.as_ref().expect("it runs on all triangles");
    bind(rays, triangles).answers()
}

/// Largest relative error of a reciprocal: of the estimate, as the makers of the levels say, squared
/// by each step; then the roundings of t, which are those of the reciprocal, of what it is multiplied
/// by, and of both for the division that it is compared with. Products of these are below one more.
fn bound(axes: &Axes) -> f64 {
    let estimate = match axes.level {
        "avx512" => 2f64.powi(-14),
        "neon" => 2f64.powi(-8),
        _ => 1.5 * 2f64.powi(-12),
    };
    let steps = ["estimate", "newton", "newton-2"].iter().position(|name| *name == axes.reciprocal);
    let squared = (0..steps.expect("one of three")).fold(estimate, |error, _| error * error);
    squared + 5.0 * 2f64.powi(-24)
}

#[test]
fn distances_are_as_exact_as_the_estimate_and_its_steps() {
    let (pairs, missing) = estimated();
    let (mut compared, mut worst) = (0, BTreeMap::new());
    for seed in 0..24 {
        // One triangle, so that a distance decides nothing.
        let spec = NearestSpec { triangles: 1, rays: 128, kind: Kind::Random, spread: 0.0, seed };
        let set = NearestSet::draw(spec).expect("a plain specification");
        for [variant, dividing] in &pairs {
            let found = answers(variant, &set.rays, &set.triangles);
            let expected = answers(dividing, &set.rays, &set.triangles);
            for (found, expected) in found.iter().zip(&expected) {
                if variant.axes.division == "last" {
                    assert_eq!(found.triangle, expected.triangle, "{}", variant.id());
                }
                if found.triangle.is_none() || expected.triangle.is_none() {
                    continue;
                }
                let error = ((found.t - expected.t) / expected.t).abs();
                assert!(error <= bound(&variant.axes), "{}: {error:e}", variant.id());
                let key = (variant.axes.level, variant.axes.reciprocal);
                let most = worst.entry(key).or_insert(0.0f64);
                *most = most.max(error);
                compared += 1;
            }
        }
    }
    println!("{compared} distances, {missing} forms of missing levels; largest errors {worst:?}");
    assert!(compared > 100 * pairs.len(), "{compared} distances of {} forms", pairs.len());
    // They are estimates: what divides in their place would be as exact as a division.
    let coarse = |((_, name), error): (&(&str, &str), &f64)| *name != "estimate" || *error > 1e-6;
    assert!(worst.iter().all(coarse), "{worst:?}");
}

/// A number of any size, or none at all.
fn number(draw: &mut Pcg, scale: f32) -> f32 {
    let unit = (draw.below(1 << 24) as f32 - 8_388_608.0) / 8_388_608.0;
    match draw.below(40) {
        0 => SPECIAL[draw.below(SPECIAL.len() as u64) as usize],
        1..4 => unit * f32::MAX,
        4..7 => unit * 1e-40,
        _ => unit * scale,
    }
}

fn vector(draw: &mut Pcg, scale: f32) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| number(draw, scale)))
}

/// Rays and a triangle of all sizes. Determinants are of the second to the sixth power of a size, over
/// the range of f32 and beyond.
fn extremes(draw: &mut Pcg) -> Vec<(Vec<Ray>, Triangle)> {
    let exponents = [-30, -19, -13, -7, 0, 6, 12, 18, 30].into_iter().flat_map(|e| [e; 24]);
    let scene = exponents.map(|exponent| {
        let scale = 10f32.powi(exponent);
        let [a, b, c] = [(); 3].map(|()| vector(draw, scale));
        let rays = (0..32).map(|i| {
            let origin = vector(draw, scale);
            let aimed = (a + b + c) / 3.0 - origin;
            let direction = if i % 2 == 0 { aimed } else { vector(draw, scale) };
            Ray { origin, direction, end: origin + direction, t_min: 0.0, t_max: f32::MAX }
        });
        (rays.collect(), Triangle { a, b, c })
    });
    scene.collect()
}

#[test]
fn nothing_that_is_not_finite_is_reported() {
    let (pairs, missing) = estimated();
    let mut hits = 0;
    for (rays, triangle) in extremes(&mut Pcg::new(11)) {
        for [variant, _] in &pairs {
            for answer in answers(variant, &rays, &[triangle]) {
                let Answer { t, u, v, triangle: hit, .. } = answer;
                let finite = [t, u, v].iter().all(|x| x.is_finite());
                assert!(
                    hit.is_none() || finite && t >= 0.0,
                    "{}: t {t} u {u} v {v} of {triangle:?}",
                    variant.id()
                );
                hits += usize::from(hit.is_some());
            }
        }
    }
    println!("{hits} hits; {missing} forms of missing levels");
    assert!(hits > 100 * pairs.len(), "{hits} hits of {} forms", pairs.len());
}

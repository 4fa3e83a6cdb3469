//! Sets of rays and triangles at any density, number and seed.

use super::unit;
use ray_test::oracle::{Query, classify};
use ray_test::workload::{
    Generator, Kind, NearestSet, NearestSpec, PairSpec, Pairs, Pcg, PointSet, PointSpec, QueryKind,
    Ray, Triangle, Winding,
};

fn hits(rays: &[Ray], triangles: &[Triangle]) -> usize {
    let queries = rays.iter().zip(triangles).map(|(ray, triangle)| Query::of(ray, triangle));
    queries.filter(|query| classify(query).is_hit()).count()
}

/// Any density, its ends and what rounds to them more often than chance has it.
fn density(pcg: &mut Pcg) -> f64 {
    match pcg.below(6) {
        0 => 0.0,
        1 => 1.0,
        2 => 1e-300,
        3 => 1.0 - f64::EPSILON,
        _ => unit(pcg),
    }
}

#[test]
fn pairs_have_exactly_the_hits_that_were_asked_for_and_are_the_same_again() {
    let mut pcg = Pcg::new(31);
    for _ in 0..150 {
        let count = 1 + pcg.below(400) as usize;
        let generator = [Generator::Pcg, Generator::Msvc][pcg.below(2) as usize];
        let most = if generator == Generator::Msvc { 1 << 31 } else { u64::MAX };
        let spec = PairSpec {
            count,
            density: density(&mut pcg),
            query: [QueryKind::Line, QueryKind::Ray, QueryKind::Segment][pcg.below(3) as usize],
            winding: [Winding::Natural, Winding::Facing][pcg.below(2) as usize],
            generator,
            seed: pcg.bits() % most,
        };
        let pairs = Pairs::draw(spec).unwrap_or_else(|error| panic!("{spec:?}: {error}"));
        assert_eq!((pairs.rays.len(), pairs.triangles.len()), (count, count), "{spec:?}");
        let wanted = (spec.density * count as f64 + 0.5).floor() as usize;
        assert_eq!((pairs.hits, hits(&pairs.rays, &pairs.triangles)), (wanted, wanted), "{spec:?}");
        spread_out(&pairs);
        let again = Pairs::draw(spec).expect("the same again");
        assert_eq!(
            (again.hash, &again.rays, &again.triangles),
            (pairs.hash, &pairs.rays, &pairs.triangles)
        );
        let other = Pairs::draw(PairSpec { seed: spec.seed ^ 1, ..spec }).expect("another");
        assert_ne!(other.hash, pairs.hash, "{spec:?}");
    }
}

/// Any run of pairs has its share of hits, rounded down or up.
fn spread_out(pairs: &Pairs) {
    let one = |place: usize| {
        usize::from(hits(&pairs.rays[place..=place], &pairs.triangles[place..=place]) == 1)
    };
    let is_hit: Vec<usize> = (0..pairs.rays.len()).map(one).collect();
    for length in [1, 7, 32] {
        for run in is_hit.windows(length) {
            let share = length as f64 * pairs.density();
            let found = run.iter().sum::<usize>() as f64;
            assert!((found - share).abs() < 1.0, "{found} of {length} in {:?}", pairs.spec);
        }
    }
}

#[test]
fn points_have_exactly_the_hits_that_were_asked_for_and_are_the_same_again() {
    let mut pcg = Pcg::new(32);
    for _ in 0..100 {
        let count = 1 + pcg.below(300) as usize;
        let spec = PointSpec { count, density: density(&mut pcg), seed: pcg.bits() };
        let points = PointSet::draw(spec).unwrap_or_else(|error| panic!("{spec:?}: {error}"));
        let wanted = (spec.density * count as f64 + 0.5).floor() as usize;
        assert_eq!(
            (points.hits, hits(&points.rays, &points.triangles)),
            (wanted, wanted),
            "{spec:?}"
        );
        let again = PointSet::draw(spec).expect("the same again");
        assert_eq!((again.hash, again.rays), (points.hash, points.rays));
    }
}

#[test]
fn nearest_sets_are_the_same_again_and_of_the_size_that_was_asked_for() {
    let mut pcg = Pcg::new(33);
    for turn in 0..40 {
        let kind =
            [Kind::Random, Kind::Coherent, Kind::Terrain, Kind::Bunches, Kind::Parallel][turn % 5];
        let spread = if kind == Kind::Bunches { 0.001 + unit(&mut pcg) as f32 } else { 0.0 };
        let rays = 16 * (1 + pcg.below(6) as usize);
        let triangles = 1 + pcg.below(100) as usize;
        let spec = NearestSpec { triangles, rays, kind, spread, seed: pcg.bits() };
        let set = NearestSet::draw(spec).unwrap_or_else(|error| panic!("{spec:?}: {error}"));
        assert_eq!((set.rays.len(), set.triangles.len()), (rays, triangles));
        assert!(
            set.rays.iter().all(|ray| ray.origin.is_finite()
                && ray.direction.is_finite()
                && ray.end.is_finite())
        );
        assert_eq!(NearestSet::draw(spec).expect("the same again").hash, set.hash, "{spec:?}");
    }
}

#[test]
fn what_no_set_can_be_is_refused_with_what_may_be() {
    let spec = PairSpec::new(10, 0.5, 1);
    for (count, density) in
        [(0, 0.5), (usize::MAX, 0.5), (10, f64::NAN), (10, -0.1), (10, 1.1), (10, f64::INFINITY)]
    {
        let error = Pairs::draw(PairSpec { count, density, ..spec }).expect_err("no such set");
        assert!(error.to_string().contains("allowed"), "{error}");
        let error = PointSet::draw(PointSpec { count, density, seed: 1 }).expect_err("no such set");
        assert!(error.to_string().contains("allowed"), "{error}");
    }
}

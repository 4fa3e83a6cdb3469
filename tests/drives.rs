//! However a kernel is driven, it is the same kernel: groups of triangles, bundles, memory layouts,
//! vectors in registers, packets longer than a register and packets that share an origin or a
//! direction give what single rays of the same form give, bit for bit.

use ray_test::job::{Answer, Block};
use ray_test::registry::{Axes, REFERENCE, Variant, find, variants};
use ray_test::workload::{Kind, NearestSet, NearestSpec, Ray, Triangle};

/// The single ray of the same form. Fused forms are single at AVX2 only, of f32 and with u and v; long
/// packets of fused f64 are held to those of one register, which `tests/lanes` holds to single rays.
fn yardstick(variant: &Variant) -> &'static Variant {
    let axes = &variant.axes;
    if (axes.precision, axes.rounding) == ("f64", "fused") {
        let drive = if axes.level == "avx512" { "packet8" } else { "packet2" };
        let id = Axes { drive: drive.into(), ..axes.clone() }.id();
        return find(&id).unwrap_or_else(|| panic!("{}: no {id}", variant.id()));
    }
    let projection = if axes.projection.is_empty() { "" } else { "one-index" };
    let level = match (axes.level, axes.rounding) {
        ("neon", _) => "neon",
        (_, "fused") => "avx2",
        _ => "sse2",
    };
    let output = if axes.rounding == "fused" { "tuv" } else { axes.output };
    let single = Axes { drive: "single".into(), level, layout: "aos", ..axes.clone() };
    let single = Axes { projection, dot: "", output, ..single };
    // Safe signs decide as comparisons do, and in any order.
    let id = Axes { tests: "compare", leading_is_native: true, ..single }.id();
    find(&id).unwrap_or_else(|| panic!("{}: no {id}", variant.id()))
}

/// Rays of a packet or a bundle, by the name of the drive.
fn together(drive: &str) -> usize {
    let digits: String = drive.chars().filter(char::is_ascii_digit).collect();
    digits.parse().unwrap_or(1)
}

/// A packet that is longer than a register of its level.
fn is_long(axes: &Axes) -> bool {
    let register = match (axes.level, axes.precision) {
        ("avx512", "f32") => 16,
        ("avx2", "f32") | ("avx512", _) => 8,
        ("avx2", _) | (_, "f32") => 4,
        _ => 2,
    };
    axes.drive.starts_with("packet") && together(&axes.drive) > register
}

/// Groups, bundles, vectors in registers, long packets, other layouts and other ways to project: those
/// that this processor has, and the number of the others.
fn driven() -> (Vec<&'static Variant>, usize) {
    let driven = variants().iter().filter(|variant| {
        let axes = &variant.axes;
        let projects = !["", "one-index"].contains(&axes.projection);
        let apart = axes.drive.starts_with("bundle") || axes.drive == "single-vector";
        axes.layout != "aos" || apart || is_long(axes) || projects
    });
    let (here, missing): (Vec<_>, Vec<_>) = driven.partition(|variant| (variant.available)());
    (here, missing.len())
}

/// Triangle, or none, and the bits of t, u and v of a hit, of those that the output `t` or `tuv` has.
fn bits(answer: &Answer, output: &str) -> (Option<usize>, [u64; 3]) {
    let [u, v] = if output == "t" { [0.0; 2] } else { [answer.u, answer.v] };
    let numbers = [answer.t, u, v];
    (answer.triangle, numbers.map(|x| if answer.triangle.is_some() { x.to_bits() } else { 0 }))
}

/// Whether a set has what the rays of a variant's packets must have in common.
fn suits(variant: &Variant, kind: Kind) -> bool {
    match variant.axes.drive.split_once('-') {
        Some((_, "common-origin")) => kind == Kind::Coherent,
        Some((_, "parallel")) => kind == Kind::Parallel,
        _ if variant.axes.projection == "fixed" => kind == Kind::Terrain,
        _ => true,
    }
}

/// 45 triangles, of which one has no area and one lies along the first ray: no group, block or line of
/// a layout comes out even.
fn set(kind: Kind, seed: u64) -> NearestSet {
    let spec = NearestSpec { triangles: 45, rays: 128, kind, spread: 0.0, seed };
    let mut set = NearestSet::draw(spec).expect("a plain specification");
    let Triangle { a, b, c } = set.triangles[0];
    set.triangles[43] = Triangle { a, b, c: b };
    set.triangles[44] = Triangle { a, b: a + set.rays[0].direction, c };
    set
}

#[test]
fn every_drive_gives_what_single_rays_give() {
    let (mut compared, mut hits) = (0, 0);
    let sets = [(Kind::Random, 3), (Kind::Coherent, 4), (Kind::Parallel, 5), (Kind::Terrain, 6)];
    let sets = sets.map(|(kind, seed)| (kind, set(kind, seed)));
    let (driven, missing) = driven();
    for variant in driven {
        for (_, set) in sets.iter().filter(|(kind, _)| suits(variant, *kind)) {
            let answers = |variant: &Variant| {
                let bind = variant.nearest.as_ref().expect("it runs on all triangles");
                bind(&set.rays, &set.triangles).answers()
            };
            let (found, expected) = (answers(variant), answers(yardstick(variant)));
            assert_eq!(found.len(), expected.len());
            for (ray, (found, expected)) in found.iter().zip(&expected).enumerate() {
                let [found_bits, expected] =
                    [found, expected].map(|of| bits(of, variant.axes.output));
                assert_eq!(found_bits, expected, "{}, ray {ray}", variant.id());
                hits += usize::from(found.triangle.is_some());
            }
            compared += 1;
        }
    }
    println!("{compared} comparisons, {hits} hits; skipped: {missing} forms of missing levels");
    assert!(compared >= 30 && hits > 20 * compared, "{compared} comparisons, {hits} hits");
}

/// Pairs of which some hit: each ray with what it hits among all triangles, and with another triangle.
fn pairs(set: &NearestSet) -> (Vec<Ray>, Vec<Triangle>) {
    let all = find(REFERENCE).and_then(|reference| reference.nearest.as_ref());
    let answers = all.expect("it runs on all triangles")(&set.rays, &set.triangles).answers();
    let others = (0..set.rays.len()).map(|ray| (ray, ray % set.triangles.len()));
    let hits = answers.iter().enumerate().filter_map(|(ray, answer)| Some((ray, answer.triangle?)));
    hits.chain(others).map(|(ray, triangle)| (set.rays[ray], set.triangles[triangle])).unzip()
}

#[test]
fn vectors_in_registers_give_what_single_rays_give_on_pairs() {
    let (mut compared, mut hits) = (0, 0);
    let (rays, triangles) = pairs(&set(Kind::Random, 3));
    let (driven, missing) = driven();
    for variant in driven.into_iter().filter(|variant| variant.axes.drive == "single-vector") {
        let answers = |variant: &Variant| {
            let bind = variant.pairs.as_ref().expect("single rays run on pairs");
            let mut job = bind(&rays, &triangles);
            (job.answers(), job.run(Block::whole(job.as_ref())).hits)
        };
        let ((found, tally), (expected, _)) = (answers(variant), answers(yardstick(variant)));
        let mut found_hits = 0;
        for (pair, (found, expected)) in found.iter().zip(&expected).enumerate() {
            let [of, expected] = [found, expected].map(|answer| bits(answer, "tuv"));
            assert_eq!(of, expected, "{}, pair {pair}", variant.id());
            found_hits += u64::from(found.triangle.is_some());
        }
        assert_eq!(tally, found_hits, "{}", variant.id());
        (compared, hits) = (compared + 1, hits + found_hits);
    }
    println!("{compared} forms, {hits} hits; skipped: {missing} forms of missing levels");
    // NEON has no such forms.
    assert!(compared > 0 || cfg!(target_arch = "aarch64"));
    assert!(hits >= 20 * compared, "{compared} forms, {hits} hits");
}

/// Rays that all drives can take, per variant.
fn suitable(variant: &Variant, seed: u64) -> NearestSet {
    let kinds = [Kind::Random, Kind::Coherent, Kind::Parallel, Kind::Terrain];
    let kind = kinds.into_iter().find(|kind| suits(variant, *kind));
    set(kind.expect("one of them suits"), seed)
}

#[test]
fn of_two_triangles_at_one_distance_the_first_is_hit() {
    let (driven, _) = driven();
    for variant in driven {
        let mut set = suitable(variant, 6);
        // Every triangle twice, 45 apart: in another lane, and in another group.
        set.triangles.extend_from_within(..);
        let bind = variant.nearest.as_ref().expect("it runs on all triangles");
        let triangles = bind(&set.rays, &set.triangles).answers();
        let hit: Vec<usize> = triangles.iter().filter_map(|answer| answer.triangle).collect();
        assert!(!hit.is_empty() && hit.iter().all(|triangle| *triangle < 45), "{}", variant.id());
    }
}

#[test]
fn triangles_in_another_order_give_the_same_tallies_and_answers() {
    let backwards: Vec<u32> = (0..45).rev().collect();
    let (driven, _) = driven();
    for variant in driven {
        let set = suitable(variant, 7);
        let bind = variant.nearest.as_ref().expect("it runs on all triangles");
        let mut job = bind(&set.rays, &set.triangles);
        let (answers, tally) = (job.answers(), job.run(Block::whole(job.as_ref())));
        job.permute_shared(&backwards);
        assert_eq!(job.run(Block::whole(job.as_ref())), tally, "{}", variant.id());
        assert_eq!(job.answers(), answers, "{}", variant.id());
    }
}

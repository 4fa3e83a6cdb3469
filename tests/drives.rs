//! However a kernel is driven, it is the same kernel: groups of triangles, bundles and memory layouts
//! give what single rays of the same form give, bit for bit.

use ray_test::job::{Answer, Block};
use ray_test::registry::{Axes, Variant, find, variants};
use ray_test::workload::{Kind, NearestSet, NearestSpec};

/// The single ray of the same form. Fused forms are single at AVX2 only.
fn yardstick(variant: &Variant) -> &'static Variant {
    let axes = &variant.axes;
    let level = match (axes.level, axes.rounding) {
        ("neon", _) => "neon",
        (_, "fused") => "avx2",
        _ => "sse2",
    };
    let id = Axes { drive: "single".into(), level, layout: "aos", ..axes.clone() }.id();
    find(&id).unwrap_or_else(|| panic!("{}: no {id}", variant.id()))
}

/// Groups, bundles and other layouts, with those that this processor has and the number of the others.
fn driven() -> (Vec<&'static Variant>, usize) {
    let driven = variants()
        .iter()
        .filter(|variant| variant.axes.layout != "aos" || variant.axes.drive.starts_with("bundle"));
    let (here, missing): (Vec<_>, Vec<_>) = driven.partition(|variant| (variant.available)());
    (here, missing.len())
}

/// Triangle, or none, and the bits of t, u and v of a hit.
fn bits(answer: &Answer) -> (Option<usize>, [u64; 3]) {
    let numbers = [answer.t, answer.u, answer.v];
    (answer.triangle, numbers.map(|x| if answer.triangle.is_some() { x.to_bits() } else { 0 }))
}

/// 45 triangles: no group, block or line of a layout comes out even.
fn set(kind: Kind, seed: u64) -> NearestSet {
    let spec = NearestSpec { triangles: 45, rays: 128, kind, seed };
    NearestSet::draw(spec).expect("a plain specification")
}

#[test]
fn every_drive_gives_what_single_rays_give() {
    let (mut compared, mut hits) = (0, 0);
    let sets = [set(Kind::Random, 3), set(Kind::Coherent, 4)];
    let (driven, missing) = driven();
    for variant in driven {
        for set in &sets {
            let answers = |variant: &Variant| {
                let bind = variant.nearest.as_ref().expect("it runs on all triangles");
                bind(&set.rays, &set.triangles).answers()
            };
            let (found, expected) = (answers(variant), answers(yardstick(variant)));
            assert_eq!(found.len(), expected.len());
            for (ray, (found, expected)) in found.iter().zip(&expected).enumerate() {
                assert_eq!(bits(found), bits(expected), "{}, ray {ray}", variant.id());
                hits += usize::from(found.triangle.is_some());
            }
            compared += 1;
        }
    }
    println!("{compared} comparisons, {hits} hits; skipped: {missing} forms of missing levels");
    assert!(compared >= 30 && hits > 20 * compared, "{compared} comparisons, {hits} hits");
}

#[test]
fn of_two_triangles_at_one_distance_the_first_is_hit() {
    let mut set = set(Kind::Random, 6);
    // Every triangle twice, 45 apart: in another lane, and in another group.
    set.triangles.extend_from_within(..);
    let (driven, _) = driven();
    for variant in driven {
        let bind = variant.nearest.as_ref().expect("it runs on all triangles");
        let triangles = bind(&set.rays, &set.triangles).answers();
        let hit: Vec<usize> = triangles.iter().filter_map(|answer| answer.triangle).collect();
        assert!(!hit.is_empty() && hit.iter().all(|triangle| *triangle < 45), "{}", variant.id());
    }
}

#[test]
fn triangles_in_another_order_give_the_same_tallies_and_answers() {
    let set = set(Kind::Random, 7);
    let backwards: Vec<u32> = (0..45).rev().collect();
    let (driven, _) = driven();
    for variant in driven {
        let bind = variant.nearest.as_ref().expect("it runs on all triangles");
        let mut job = bind(&set.rays, &set.triangles);
        let (answers, tally) = (job.answers(), job.run(Block::whole(job.as_ref())));
        job.permute_shared(&backwards);
        assert_eq!(job.run(Block::whole(job.as_ref())), tally, "{}", variant.id());
        assert_eq!(job.answers(), answers, "{}", variant.id());
    }
}

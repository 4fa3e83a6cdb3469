//! What is built: how many variants, their ids, and copies of the references. (That copies lie at
//! other addresses with equal code is for the check of the generated code to see.)

use std::collections::BTreeSet;

use ray_test::job::Block;
use ray_test::registry::{REFERENCE, Variant, find, kernels, placebos, streams, variants};
use ray_test::workload::{Kind, NearestSet, NearestSpec};

/// Growth is a decision: 2 000 with the stiff cases, 2 400 with groups and layouts.
const BUDGET: usize = 2_400;

#[test]
fn the_number_of_variants_is_within_its_budget() {
    let count = variants().len();
    assert!(count <= BUDGET, "{count} variants, budget {BUDGET}");
}

#[test]
fn no_two_variants_share_an_id() {
    let ids: BTreeSet<String> = variants().iter().map(Variant::id).collect();
    assert_eq!(ids.len(), variants().len());
    assert!(ids.contains(REFERENCE));
    assert!(find(REFERENCE).is_some());
}

#[test]
fn every_kernel_is_there() {
    let ids: Vec<&str> = kernels().iter().map(|variant| variant.about.id).collect();
    for id in [
        "moller-trumbore",
        "moller0",
        "moller1",
        "moller2",
        "moller3",
        "kensler-shirley",
        "shevtsov",
        "badouel",
        "badouel-cramer",
        "wald",
        "keidy",
        "perpendicular-planes",
        "chirkov",
        "chirkov-line",
        "plucker",
        "half-spaces",
        "signed-areas",
        "angle-sum",
        "woop-watertight",
        "embree-plucker",
        "baldwin-weber",
        "woop-affine",
        "moller-trumbore-in-f64",
    ] {
        assert!(ids.contains(&id), "{id} is missing");
    }
}

#[test]
fn records_have_the_published_sizes() {
    let bytes = |id: &str| find(id).map(|variant| variant.bytes_per_triangle);
    for (id, wanted) in [
        ("moller-trumbore/f32/single/sse2/early/last/plain/tuv", 36),
        ("kensler-shirley/f32/single/sse2/early/last/plain/tuv", 36),
        ("kensler-shirley/f32/single/sse2/early/last/plain/tuv/stored=normal", 48),
        ("kensler-shirley/f32/single/sse2/early/last/plain/tuv/stored=precomputed", 48),
        ("shevtsov/f32/single/sse2/early/last/plain/tuv", 48),
        ("wald/f32/single/sse2/early/last/plain/tuv", 48),
        ("perpendicular-planes/f32/single/sse2/early/last/plain/tuv", 48),
        ("woop-watertight/f32/single/sse2/early/last/plain/tuv", 36),
        ("woop-watertight/f32/single/sse2/early/last/plain/tuv/edges=exact-sign", 36),
        ("embree-plucker/f32/single/sse2/early/first/plain/tuv", 36),
        ("baldwin-weber/f32/single/sse2/early/last/plain/tuv", 48),
        ("baldwin-weber/f32/single/sse2/early/last/plain/tuv/stored=row-offsets", 48),
        ("woop-affine/f32/single/sse2/early/last/plain/tuv", 48),
        ("moller-trumbore-in-f64/f32/single/sse2/early/last/plain/tuv", 36),
        ("badouel/f32/single/sse2/early/first/plain/t", 64),
        ("chirkov-line/f32/single/sse2/early/last/plain/t", 64),
    ] {
        assert_eq!(bytes(id), Some(wanted), "{id}");
    }
}

#[test]
fn there_are_several_placebos_of_the_reference() {
    for reference in [REFERENCE, "moller1/f32/single/sse2/early/last/plain/t"] {
        let reference = find(reference).expect("it is a variant");
        let copies = placebos().iter().filter(|copy| copy.is_copy_of(reference)).count();
        assert_eq!(copies, 3, "{}", reference.id());
        assert!(!reference.is_copy_of(reference));
    }
}

#[test]
fn triangles_in_another_order_give_the_same_tallies_and_answers() {
    let spec = NearestSpec { triangles: 40, rays: 32, kind: Kind::Random, spread: 0.0, seed: 3 };
    let set = NearestSet::draw(spec).expect("a plain specification");
    let backwards: Vec<u32> = (0..40).rev().collect();
    for id in [REFERENCE, "wald/f64/packet2/sse2/full/first/plain/tuv"] {
        let variant = find(id).filter(|variant| (variant.available)());
        let Some(bind) = variant.and_then(|variant| variant.nearest.as_ref()) else { continue };
        let mut job = bind(&set.rays, &set.triangles);
        assert_eq!(job.shared_records(), 40);
        let (answers, tally) = (job.answers(), job.run(Block::whole(job.as_ref())));
        assert!(tally.hits > 0 && answers.iter().any(|answer| answer.triangle > Some(20)));
        job.permute_shared(&backwards);
        assert_eq!(job.run(Block::whole(job.as_ref())), tally, "{id}");
        assert_eq!(job.answers(), answers, "{id}");
    }
}

#[test]
fn every_stream_of_operations_finds_the_same_however_long_it_runs() {
    for stream in streams().iter().filter(|stream| (stream.available)()) {
        let mut job = (stream.job)();
        let block = |items| Block { first: 0, items, repeats: 1, literal: false };
        let (one, seven) = (job.run(block(1)), job.run(block(7)));
        assert_eq!(one.times(7), seven, "{}", stream.id());
        assert!(one.bits[0] != 0, "{}", stream.id());
    }
}

#[test]
fn stored_forms_and_levels_are_named() {
    let call = |id: &str| find(id).map(Variant::call).unwrap_or_default();
    let stored = call("kensler-shirley/f32/single/sse2/full/first/plain/tuv/stored=precomputed");
    assert!(stored.contains("type Usual = Form<Full, First, Plain, Tuv>;"), "{stored}");
    assert!(stored.contains("type Test = KenslerShirley<Precomputed>;"), "{stored}");
    let crossed = call("kensler-shirley/f32/single/sse2/early/last/plain/tuv/cross=edges");
    assert!(crossed.contains("type Test = KenslerShirley<Vertices, WithEdges>;"), "{crossed}");
    let wald = call("wald/f32/single/avx2/early/last/fused/tuv");
    assert!(wald.starts_with("// Timed as code for avx2"), "{wald}");
    assert!(wald.contains("type Test = Wald;"), "{wald}");
    let packet = call("wald/f32/packet4/sse2/early/last/plain/tuv");
    assert!(packet.contains("find(\"wald/f32/packet4/sse2/early/last/plain/tuv\")"), "{packet}");
}

#[test]
fn every_variant_has_lines_and_no_path_is_left_in_a_name() {
    for variant in variants() {
        let call = variant.call();
        assert!(!call.is_empty() && !call.contains("ray_test::kernels"), "{call}");
    }
}

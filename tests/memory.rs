//! Large sets made of tiles: what they hold, and that walking over them finds what is found without.
#![cfg(feature = "cli")]

mod support;

use ray_test::batch::{Extent, TILE};
use ray_test::experiment::{Outcome, Plan};
use ray_test::job::Block;
use ray_test::registry::variants;
use ray_test::workload::{Kind, NearestSet, NearestSpec};

fn text(triangles: &str) -> String {
    format!(
        "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
         variants = ['^wald/f32/(single|packet4)/sse2/early/last/plain/tuv$']\n[workload]\n\
         kind = 'memory'\ntriangles = {triangles}\n"
    )
}

fn experiment(triangles: &str) -> Result<Plan, String> {
    support::plan(&text(triangles))
}

fn outcome(triangles: &str) -> Outcome {
    support::run_all(&text(triangles), 32)
}

fn tile() -> NearestSet {
    let spec = NearestSpec { triangles: TILE, rays: 16, kind: Kind::Random, spread: 0.0, seed: 1 };
    NearestSet::draw(spec).expect("a plain specification")
}

#[test]
fn a_set_is_the_same_in_every_version() {
    assert_eq!(format!("{:016x}", tile().hash), "24da3b05ef841a1e");
    let rows = outcome("[256, 5120]").rows;
    let hashes: Vec<&str> = rows.iter().map(|row| row.workload_hash.as_str()).collect();
    assert_eq!(
        hashes,
        ["3747c9f46590805d", "3747c9f46590805d", "b1d318e5e9aa8fc6", "b1d318e5e9aa8fc6"]
    );
}

#[test]
fn a_row_for_every_set_and_variant() {
    let outcome = outcome("[256, 5120]");
    assert!(outcome.wrong.is_empty() && !outcome.interrupted);
    let found: Vec<_> =
        outcome.rows.iter().map(|row| (row.triangles, row.set_bytes, row.tests)).collect();
    // 16 rays over one tile, or one to four of them over each of 20.
    let wanted = [(256, 16 * 256), (256, 16 * 256), (5120, 5120), (5120, 4 * 5120)];
    let wanted = wanted.map(|(count, tests)| (Some(count), Some(48 * count), Some(tests)));
    assert_eq!(found, wanted);
    for row in &outcome.rows {
        assert_eq!((row.status.as_str(), row.rounds), ("ok", Some(8)), "{row:?}");
        assert!(row.ns_per_test.is_some() && row.false_hits == Some(0));
    }
    // Of one tile every ray has its turn, whoever takes it.
    assert_eq!(outcome.rows[0].hits, outcome.rows[1].hits);
}

#[test]
fn walked_or_not_the_answers_are_the_same() {
    let set = tile();
    let (mut compared, mut missing) = (0, 0);
    for variant in variants() {
        let (Some(nearest), Some(tiles)) = (&variant.nearest, &variant.tiles) else { continue };
        let in_memory = variant.axes.output == "tuv" && !variant.axes.drive.contains('-');
        if !in_memory || variant.rays > 16 || !variant.claims_exactness() {
            continue;
        }
        if !(variant.available)() {
            missing += 1;
            continue;
        }
        let mut small = nearest(&set.rays, &set.triangles);
        let mut large =
            tiles(&set.rays, &set.triangles, Extent { tiles: 21, cache_bytes: 1 << 20 });
        assert_eq!(large.answers(), small.answers(), "{}", variant.id());
        let turns = small.items();
        for item in 0..large.items() {
            let block = |first| Block { first, items: 1, repeats: 1, literal: false };
            let (found, wanted) = (large.run(block(item)), small.run(block(item % turns)));
            assert_eq!(found, wanted, "{}, item {item}", variant.id());
        }
        compared += 1;
    }
    println!("{compared} forms; skipped: {missing} of missing levels");
    assert!(compared > 100, "{compared}");
}

#[test]
fn sizes_that_are_not_whole_tiles_are_refused() {
    for (triangles, parts) in [
        ("[]", ["workload.triangles", "at least one"]),
        ("[256, 1000]", ["1000 is not allowed", "multiples of 256"]),
        ("[0]", ["0 is not allowed", "from 256 to"]),
        ("[33554432]", ["33554432", "16777216"]),
    ] {
        let message = experiment(triangles).err().expect("it is wrong");
        assert!(parts.iter().all(|part| message.contains(part)), "{message}");
    }
}

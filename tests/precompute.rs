//! What is prepared of triangles, timed: the loop makes what the tests are run on, and rows tell what it
//! costs in all.
#![cfg(feature = "cli")]

mod support;

use ray_test::job::{Block, Job, Tally};
use ray_test::registry::variants;
use ray_test::table::Row;
use ray_test::workload::{Kind, NearestSet, NearestSpec};
use support::{Memory, run_until};

const TEXT: &str = "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
    variants = ['^(moller-trumbore|wald|kensler-shirley)/f32/single/sse2/early/last/plain/tuv\
    (/stored=(normal|precomputed))?$']\n[workload]\nkind = 'precompute'\n\
    rays_per_triangle = [1, 10]\n";

#[test]
fn preparing_stands_beside_the_tests_and_in_the_sums() {
    let rows = run_until(TEXT, usize::MAX, &mut Memory::default()).rows;
    let (sums, tests): (Vec<Row>, Vec<Row>) =
        rows.into_iter().partition(|row| row.rays_per_triangle.is_some());
    assert_eq!((tests.len(), sums.len()), (5, 2 * 5));
    for row in &tests {
        assert_eq!(row.status, "ok", "{row:?}");
        assert!(row.prepare_cycles_per_triangle.is_some_and(|cycles| cycles > 0.0));
        // The forms that prepare nothing are compared with, and are not compared.
        let against = match (row.kernel.as_str(), row.stored.as_str()) {
            (_, "vertices") => "",
            ("kensler-shirley", _) => "kensler-shirley",
            _ => "moller-trumbore",
        };
        assert_eq!(row.pays_against, against, "{}", row.id);
        let own: Vec<&Row> = sums.iter().filter(|sum| sum.id == row.id).collect();
        assert_eq!(own.len(), 2);
        for sum in own {
            let rays = sum.rays_per_triangle.map_or(0.0, |rays| rays as f64);
            let once = if against.is_empty() { Some(0.0) } else { row.prepare_cycles_per_triangle };
            let wanted = once.zip(row.cycles_per_test).map(|(once, test)| once + rays * test);
            assert_eq!(sum.total_cycles_per_triangle, wanted);
            assert_eq!(sum.total_cycles_per_ray, wanted.map(|wanted| wanted / rays));
            assert_eq!((sum.cycles_per_test, sum.prepare_cycles_per_triangle), (None, None));
        }
    }
}

#[test]
fn an_interrupted_run_is_measured_again_and_a_whole_one_is_taken_back() {
    let mut whole = Memory::default();
    let undisturbed = run_until(TEXT, usize::MAX, &mut whole);
    assert_eq!(whole.0.len(), 1);
    for blocks in [1, 200] {
        let mut memory = Memory::default();
        let interrupted = run_until(TEXT, blocks, &mut memory);
        assert!(interrupted.interrupted && memory.0.is_empty());
        assert!(run_until(TEXT, usize::MAX, &mut memory).rows == undisturbed.rows);
        assert!(memory.0 == whole.0);
    }
    assert!(run_until(TEXT, usize::MAX, &mut whole).rows == undisturbed.rows);
}

fn tally(job: &mut dyn Job, first: usize, items: usize, repeats: usize) -> Tally {
    job.run(Block { first, items, repeats, literal: false })
}

#[test]
fn every_kernels_loop_makes_the_records_that_its_tests_are_run_on() {
    let spec = NearestSpec { triangles: 45, rays: 16, kind: Kind::Random, spread: 0.0, seed: 9 };
    let set = NearestSet::draw(spec).expect("a plain specification");
    let mut stores: Vec<(String, Tally)> = Vec::new();
    for variant in variants() {
        let Some(bind) = variant.preparing else { continue };
        let axes = &variant.axes;
        let store = format!("{} {} {}", axes.kernel, axes.stored, axes.precision);
        if stores.iter().any(|(other, _)| *other == store) {
            continue;
        }
        let mut job = bind(&set.triangles);
        let answers = job.answers();
        assert_eq!(answers.len(), 45);
        for (item, answer) in answers.iter().enumerate() {
            assert_eq!(answer.triangle, Some(item), "{store}");
        }
        let job = job.as_mut();
        let all = tally(job, 0, 45, 1);
        assert_eq!(tally(job, 0, 20, 3).plus(tally(job, 20, 25, 3)), all.times(3), "{store}");
        assert_eq!(job.run(Block { repeats: 2, literal: true, ..Block::whole(job) }), all.times(2));
        // In another order it is still the same triangles.
        job.permute(&(0..45).rev().collect::<Vec<u32>>());
        assert_eq!(tally(job, 0, 45, 1), all, "{store}");
        assert_ne!(tally(job, 0, 1, 1), tally(job, 1, 1, 1), "{store}");
        stores.push((store, all));
    }
    assert!(stores.len() > 30, "{}", stores.len());
    // Those that store the same numbers find the same sums, those that do not do not.
    let of = |name: &str| stores.iter().find(|(store, _)| store == name).map(|(_, tally)| *tally);
    let vertices = of("moller-trumbore vertices f32");
    assert!(vertices.is_some());
    assert_eq!(of("kensler-shirley vertices f32"), vertices);
    assert_ne!(of("kensler-shirley normal f32"), of("kensler-shirley precomputed f32"));
}

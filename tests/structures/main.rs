//! Every structure with every kernel at its leaves: the answers of the list, ties included.
#![cfg(feature = "cli")]

mod scenes;
mod small;

use ray_test::oracle::nearest;
use ray_test::registry::{LeafForm, find, leaves, wide_forms};
use ray_test::structure::{Excuse, Hit, KINDS, Kind, List, SLACK, Search, excuse};
use ray_test::workload::{Kind as Rays, NearestSet, NearestSpec, Ray, Triangle};

use scenes::Scene;

/// The list's answers.
fn listed(form: &LeafForm, scene: &Scene) -> Vec<Option<Hit>> {
    let list = List::new(scene.triangles.len() as u32);
    let mut search = Search::new((form.prepare)(&scene.triangles));
    scene.rays.iter().map(|ray| search.nearest(&list, ray)).collect()
}

/// A difference between the list and a structure, which is the list's hit alone: a structure tests no
/// triangle that the list does not.
fn excused(form: &LeafForm, kind: &Kind, scene: &Scene, ray: &Ray, hit: Option<Hit>) -> Excuse {
    let hit = hit.expect("a structure tests no more than the list");
    let why = excuse(ray, &scene.triangles, &hit, form.is_segment);
    why.unwrap_or_else(|| panic!("{} {}: {hit:?} is lost of {ray:?}", form.axes.id(), kind.id))
}

#[test]
fn structures_answer_as_the_list_does_with_every_kernel() {
    let (mut hits, mut false_hits, mut too_near) = (0, 0, 0);
    for scene in scenes::all() {
        let built: Vec<_> = KINDS.iter().map(|kind| (kind.build)(&scene.triangles)).collect();
        for form in leaves() {
            let listed = listed(&form, &scene);
            hits += listed.iter().flatten().count();
            let mut search = Search::new((form.prepare)(&scene.triangles));
            for (kind, structure) in KINDS.iter().zip(&built) {
                for (ray, expected) in scene.rays.iter().zip(&listed) {
                    if search.nearest(structure.as_ref(), ray) != *expected {
                        match excused(&form, kind, &scene, ray, *expected) {
                            Excuse::FalseHit => false_hits += 1,
                            Excuse::TooNear => too_near += 1,
                        }
                    }
                }
            }
        }
    }
    println!("{hits} hits of lists; {false_hits} false ones and {too_near} too near are not found");
    assert!(hits > 5_000, "{hits}");
}

#[test]
fn where_the_list_is_exact_so_is_every_structure() {
    let mut exact_hits = 0;
    for scene in scenes::all() {
        let built: Vec<_> = KINDS.iter().map(|kind| (kind.build)(&scene.triangles)).collect();
        let truth: Vec<_> = scene.rays.iter().map(|ray| nearest(ray, &scene.triangles)).collect();
        for form in leaves().iter().filter(|form| !form.is_segment) {
            let listed = listed(form, &scene);
            let mut search = Search::new((form.prepare)(&scene.triangles));
            let answers = scene.rays.iter().zip(&listed).zip(&truth);
            for ((ray, expected), truth) in answers {
                let is_exact = match (expected, truth) {
                    (Some(hit), Some((index, exact))) => {
                        let error = (f64::from(hit.t) - exact.t).abs();
                        hit.triangle as usize == *index && error <= 0.5 * SLACK * exact.t
                    }
                    (None, None) => true,
                    _ => false,
                };
                if !is_exact {
                    continue;
                }
                exact_hits += usize::from(expected.is_some());
                for (kind, structure) in KINDS.iter().zip(&built) {
                    let found = search.nearest(structure.as_ref(), ray);
                    assert_eq!(found, *expected, "{} {} {ray:?}", form.axes.id(), kind.id);
                }
            }
        }
    }
    assert!(exact_hits > 5_000, "{exact_hits}");
}

/// Rays whose nearest hit is beyond the doubt of rounding.
fn beyond_doubt(kind: Rays) -> (Vec<Triangle>, Vec<Ray>, Vec<Option<usize>>) {
    let spec = NearestSpec { triangles: 200, rays: 96, kind, spread: 0.0, seed: 3 };
    let NearestSet { rays, triangles, .. } = NearestSet::draw(spec).expect("a small set");
    let truth = rays.iter().map(|ray| nearest(ray, &triangles).map(|(index, _)| index)).collect();
    (triangles, rays, truth)
}

#[test]
fn beyond_doubt_every_kernel_in_every_structure_is_right() {
    for kind in [Rays::Random, Rays::Coherent] {
        let (triangles, rays, truth) = beyond_doubt(kind);
        assert!(truth.iter().flatten().count() > 48);
        let built: Vec<_> = KINDS.iter().map(|kind| (kind.build)(&triangles)).collect();
        // The sum of angles claims no exactness.
        for form in leaves().iter().filter(|form| form.about.id != "angle-sum" && !form.is_segment)
        {
            let mut search = Search::new((form.prepare)(&triangles));
            for (kind, structure) in KINDS.iter().zip(&built) {
                for (ray, truth) in rays.iter().zip(&truth) {
                    let found = search.nearest(structure.as_ref(), ray);
                    let found = found.map(|hit| hit.triangle as usize);
                    assert_eq!(found, *truth, "{} {}", form.axes.id(), kind.id);
                    assert_eq!(search.any(structure.as_ref(), ray), truth.is_some());
                }
            }
        }
    }
}

#[test]
fn beyond_doubt_the_fast_path_is_right() {
    let (mut seen, scenes) = (0, [Rays::Random, Rays::Coherent, Rays::Terrain].map(beyond_doubt));
    for form in wide_forms().iter().filter(|form| (form.available)()) {
        for (triangles, rays, truth) in &scenes {
            let mut job = (form.bind)(triangles, rays, false);
            let found: Vec<_> = job.answers().iter().map(|answer| answer.triangle).collect();
            assert_eq!(found, *truth, "{}", form.axes.id());
            let mut job = (form.bind)(triangles, rays, true);
            let found =
                job.answers().iter().map(|answer| answer.triangle.is_some()).collect::<Vec<_>>();
            assert!(found.iter().copied().eq(truth.iter().map(Option::is_some)));
            let [tree, records] = job.bytes();
            assert!(tree > 0 && records >= 36 * triangles.len());
            seen += 1;
        }
    }
    assert!(seen > 0);
}

#[test]
fn leaves_are_named_as_the_timed_forms_are() {
    let mut ids: Vec<String> = leaves().iter().map(|form| form.axes.id()).collect();
    let count = ids.len();
    ids.sort();
    ids.dedup();
    assert_eq!(ids.len(), count);
    for form in leaves() {
        assert_eq!(form.about.id, form.axes.kernel);
        assert!(find(&form.axes.id()).is_some(), "{}", form.axes.id());
        assert!((form.prepare)(&[]).triangles() == 0);
    }
}

/// The hierarchies of other crates find what is there; that of `bvh` sees front faces only.
#[cfg(feature = "peers")]
#[test]
fn beyond_doubt_the_trees_of_other_crates_are_right() {
    use ray_test::peers::trees::TREES;

    let (triangles, rays, truth) = beyond_doubt(Rays::Random);
    for form in TREES {
        let mut job = (form.bind)(&triangles, &rays);
        let found: Vec<_> = job.answers().iter().map(|answer| answer.triangle).collect();
        if form.id == "peer-bvh" {
            assert!(found.iter().flatten().count() > 10);
        } else {
            assert_eq!(found, truth, "{}", form.id);
        }
    }
}

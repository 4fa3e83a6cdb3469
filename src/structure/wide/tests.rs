//! The fast path against the list, by the same tests: in `plain`, lanes compute what scalars do.

#![cfg(any(target_arch = "x86", target_arch = "x86_64"))]

use fearless_simd::{f32x4, f32x8};

use super::{Batches, Through, Wide, WideJob};
use crate::job::Job;
use crate::kernels::{Fallback, Kernel, MollerTrumbore, WoopWatertight};
use crate::level::{Avx2, Level, On, Sse2, available};
use crate::number::{Extremes, Lanes};
use crate::policy::Inside;
use crate::structure::tests::{Of, cube, leaf, odd, rays, soup};
use crate::structure::{Excuse, List, Search, excuse, from_obvhs};
use crate::workload::{Ray, Triangle};
use glam::Vec3;

type Four = Lanes<<Sse2 as Level>::Token, f32x4<<Sse2 as Level>::Token>>;
type Eight = Lanes<<Avx2 as Level>::Token, f32x8<<Avx2 as Level>::Token>>;

/// The hits of the list, and how many answers are excused.
fn compared<K, L, R, const W: usize>(triangles: &[Triangle], rays: &[Ray]) -> [usize; 2]
where
    K: Kernel,
    L: Level,
    R: Extremes<Element = f32> + On<L>,
{
    assert_eq!(R::LANES, W);
    if !available::<L>() {
        return [usize::MAX, 0];
    }
    let run = L::enter::<Through<K, Of<Inside>, R, W>, 0> as fn(Batches<'_, W>);
    let answers = WideJob::<W>::new::<K>(triangles, rays, false, run).answers();
    let any = WideJob::<W>::new::<K>(triangles, rays, true, run).answers();
    let (list, mut search) =
        (List::new(triangles.len() as u32), Search::new(leaf::<K, Inside>(triangles)));
    let [mut hits, mut excused] = [0; 2];
    for ((ray, answer), any) in rays.iter().zip(answers).zip(any) {
        let expected = search.nearest(&list, ray);
        let found = answer.triangle.map(|index| (index as u32, answer.t as f32));
        hits += usize::from(expected.is_some());
        if found != expected.map(|hit| (hit.triangle, hit.t)) {
            let hit = expected.unwrap();
            let why: Option<Excuse> = excuse(ray, triangles, &hit, false);
            assert!(why.is_some(), "{found:?} {expected:?} {ray:?}");
            excused += 1;
        } else {
            assert_eq!(any.triangle.is_some(), expected.is_some());
        }
    }
    [hits, excused]
}

fn all(triangles: &[Triangle], rays: &[Ray], least: usize) {
    for [hits, excused] in [
        compared::<MollerTrumbore, Sse2, Four, 4>(triangles, rays),
        compared::<MollerTrumbore, Avx2, Eight, 8>(triangles, rays),
        compared::<WoopWatertight<Fallback>, Avx2, Eight, 8>(triangles, rays),
    ] {
        // Most answers are there to be compared.
        assert!(hits > least && excused < hits / 4, "{hits} {excused}");
    }
}

#[test]
fn the_fast_path_answers_as_the_list_does() {
    for (triangles, least) in [
        (soup(400, 0.1), 400),
        (soup(120, 1.0), 600),
        (cube(4), 600),
        (odd(), 400),
        (soup(3, 1.0), 50),
    ] {
        all(&triangles, &rays(&triangles, 900), least);
    }
}

#[test]
fn scenes_far_away_and_of_all_sizes_are_walked() {
    let (cube, rays) = (cube(3), rays(&cube(3), 180));
    for (by, scale) in [(1000.0, 1.0), (65_536.0, 1.0), (0.0, 1e-9), (0.0, 1e9)] {
        let moved = |p: Vec3| (p + Vec3::splat(by)) * scale;
        let one = |one: &Triangle| Triangle { a: moved(one.a), b: moved(one.b), c: moved(one.c) };
        let triangles: Vec<Triangle> = cube.iter().map(one).collect();
        let one = |ray: &Ray| Ray { origin: moved(ray.origin), end: moved(ray.end), ..*ray };
        let rays: Vec<Ray> = rays.iter().map(one).collect();
        all(&triangles, &rays, 80);
    }
}

#[test]
fn trees_hold_every_triangle_once_and_fill_their_leaves() {
    let triangles = cube(8);
    let tree = Wide::<8>::new(&triangles, &from_obvhs(&triangles));
    let mut held: Vec<u32> = tree.groups.iter().flatten().copied().collect();
    held.retain(|index| *index != u32::MAX);
    held.sort_unstable();
    assert!(held.iter().copied().eq(0..triangles.len() as u32));
    assert!(tree.triangles_per_leaf() > 3.0, "{}", tree.triangles_per_leaf());
}

#[test]
fn the_tree_of_nothing_hits_nothing() {
    let run = Sse2::enter::<Through<MollerTrumbore, Of<Inside>, Four, 4>, 0>;
    let rays = rays(&cube(1), 9);
    let mut job = WideJob::<4>::new::<MollerTrumbore>(&[], &rays, false, run);
    assert!(job.answers().iter().all(|answer| answer.triangle.is_none()));
}

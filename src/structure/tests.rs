//! Every structure against the list, on what is hard for structures.

use super::*;
use crate::kernels::{Chirkov, Fallback, Kernel, MollerTrumbore, OneIndex, Wald, WoopWatertight};
use crate::policy::{
    Between, Compare, Distance, Early, Form, Inside, Last, Leading, Plain, Tuv, TwoSided,
};
use crate::workload::{Pcg, Ray, Triangle};
use glam::Vec3;

pub type Of<L> = Form<Early, Last, Plain, Tuv, TwoSided, Compare, L, Between>;

pub fn leaf<K: Kernel, L: Leading>(triangles: &[Triangle]) -> Box<dyn Leaf> {
    Box::new(KernelLeaf::<K, Of<L>>::new(triangles, K::ABOUT.id == "chirkov"))
}

type MakeLeaf = fn(&[Triangle]) -> Box<dyn Leaf>;

const LEAVES: [MakeLeaf; 4] = [
    leaf::<MollerTrumbore, Inside>,
    leaf::<Wald<OneIndex>, Distance>,
    leaf::<WoopWatertight<Fallback>, Inside>,
    leaf::<Chirkov, Inside>,
];

fn number(pcg: &mut Pcg) -> f32 {
    (pcg.unit_f64() * 2.0 - 1.0) as f32
}

fn point(pcg: &mut Pcg) -> Vec3 {
    Vec3::new(number(pcg), number(pcg), number(pcg))
}

/// Triangles of that size anywhere.
pub fn soup(count: usize, size: f32) -> Vec<Triangle> {
    let mut pcg = Pcg::new(5);
    let mut one = || {
        let place = point(&mut pcg);
        let [a, b, c] = [(); 3].map(|()| place + point(&mut pcg) * size);
        Triangle { a, b, c }
    };
    (0..count).map(|_| one()).collect()
}

/// The surface of a cube of whole numbers, two triangles to a square: shared edges and vertices, flat
/// sides, and planes of cells that hold whole faces.
pub fn cube(side: i32) -> Vec<Triangle> {
    let mut triangles = Vec::new();
    for axis in 0..3 {
        for height in [-side, side] {
            for x in -side..side {
                for y in -side..side {
                    let at = |x: i32, y: i32| {
                        let mut place = [0.0; 3];
                        place[axis] = height as f32;
                        place[(axis + 1) % 3] = x as f32;
                        place[(axis + 2) % 3] = y as f32;
                        Vec3::from(place)
                    };
                    let corners = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
                    let [a, b, c, d] = corners;
                    triangles.extend([Triangle { a, b, c }, Triangle { a, b: c, c: d }]);
                }
            }
        }
    }
    triangles
}

/// Points, lines, needles, copies, and what is not finite.
pub fn odd() -> Vec<Triangle> {
    let mut triangles = soup(60, 0.5);
    let mut pcg = Pcg::new(6);
    for index in 0..40 {
        let Triangle { a, b, c } = triangles[index];
        triangles.push(match index % 5 {
            0 => Triangle { a, b: a, c: a },
            1 => Triangle { a, b, c: a + (b - a) * 0.5 },
            2 => Triangle { a, b, c: b + point(&mut pcg) * 1e-5 },
            3 => Triangle { a, b, c },
            _ => Triangle { a: Vec3::NAN, b, c: Vec3::INFINITY },
        });
    }
    triangles
}

/// Rays at corners, edges and insides from everywhere; along axes; in planes; from inside; from far away;
/// with directions of all lengths.
pub fn rays(triangles: &[Triangle], count: usize) -> Vec<Ray> {
    let mut pcg = Pcg::new(7);
    let size =
        triangles.iter().filter(|one| one.a.is_finite()).map(|one| one.a.abs().max_element());
    let size = size.fold(1.0, f32::max);
    let mut one = |kind: usize| {
        let chosen = triangles[pcg.below(triangles.len() as u64) as usize];
        let target = match pcg.below(3) {
            0 => chosen.a,
            1 => (chosen.a + chosen.b) * 0.5,
            _ => (chosen.a + chosen.b + chosen.c) / 3.0,
        };
        let target = if target.is_finite() { target } else { Vec3::ZERO };
        let axis = [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::Z, -Vec3::Z];
        let axis = axis[pcg.below(6) as usize];
        let (origin, direction) = match kind {
            0 => (target + axis * size * 3.0, -axis),
            1 => (target - axis * size * 0.25, axis * Vec3::new(1.0, -1.0, 1.0)),
            2 => (point(&mut pcg).round() * size * 2.0, point(&mut pcg).round()),
            3 => (point(&mut pcg) * size * 500.0, Vec3::ZERO),
            4 => (point(&mut pcg) * size * 0.5, Vec3::ZERO),
            5 => (target, point(&mut pcg)),
            _ => (point(&mut pcg) * size * 3.0, Vec3::ZERO),
        };
        let direction = if direction == Vec3::ZERO { target - origin } else { direction };
        let direction = direction * [1.0, 1e-25, 1e9][pcg.below(3) as usize];
        let end = target + (target - origin);
        let t_max = if pcg.below(4) == 0 { 2.0 } else { f32::MAX };
        Ray { origin, direction, end, t_min: 0.0, t_max }
    };
    (0..count).map(|index| one(index % 9)).collect()
}

/// What a comparison with the list came to.
#[derive(Debug, Default)]
struct Seen {
    hits: usize,
    ties: usize,
    too_near: usize,
}

/// Of each kernel and structure: the answers of the list, but for what is excused.
fn agree(triangles: &[Triangle], rays: &[Ray]) -> Seen {
    let mut seen = Seen::default();
    let list = List::new(triangles.len() as u32);
    let built: Vec<_> = KINDS.iter().map(|kind| (kind.build)(triangles)).collect();
    for make in LEAVES {
        let mut plain = Search::new(make(triangles));
        let is_segment = plain.leaf().is_segment();
        let expected: Vec<Option<Hit>> = rays.iter().map(|ray| plain.nearest(&list, ray)).collect();
        seen.hits += expected.iter().flatten().count();
        seen.ties += ties(triangles, rays, &expected, make);
        for (kind, structure) in KINDS.iter().zip(&built) {
            let mut search = Search::new(make(triangles));
            for (ray, expected) in rays.iter().zip(&expected) {
                let found = search.nearest(structure.as_ref(), ray);
                if found != *expected {
                    let hit = expected.expect("a structure tests no more than the list");
                    let why = excuse(ray, triangles, &hit, is_segment);
                    assert!(why.is_some(), "{} {found:?} {expected:?} {ray:?}", kind.id);
                    seen.too_near += usize::from(why == Some(Excuse::TooNear));
                } else {
                    assert_eq!(
                        search.any(structure.as_ref(), ray),
                        expected.is_some(),
                        "{}",
                        kind.id
                    );
                }
            }
        }
    }
    seen
}

/// Rays whose nearest hit is shared by triangles.
fn ties(triangles: &[Triangle], rays: &[Ray], expected: &[Option<Hit>], make: MakeLeaf) -> usize {
    let mut backward: Vec<Triangle> = triangles.to_vec();
    backward.reverse();
    let mut search = Search::new(make(&backward));
    let list = List::new(triangles.len() as u32);
    let mirrored = |hit: Hit| triangles.len() as u32 - 1 - hit.triangle;
    let is_tie = |(ray, expected): (&Ray, &Option<Hit>)| {
        let found = search.nearest(&list, ray);
        found.map(|hit| hit.t) == expected.map(|hit| hit.t)
            && found.map(mirrored) != expected.map(|hit| hit.triangle)
    };
    rays.iter().zip(expected).map(is_tie).filter(|tie| *tie).count()
}

#[test]
fn structures_answer_as_the_list_does_on_small_triangles() {
    let triangles = soup(300, 0.12);
    let seen = agree(&triangles, &rays(&triangles, 360));
    assert!(seen.hits > 700, "{seen:?}");
}

#[test]
fn structures_answer_as_the_list_does_on_large_triangles() {
    let triangles = soup(120, 1.0);
    let seen = agree(&triangles, &rays(&triangles, 360));
    assert!(seen.hits > 1000, "{seen:?}");
}

#[test]
fn structures_answer_as_the_list_does_on_a_closed_mesh() {
    let triangles = cube(3);
    let seen = agree(&triangles, &rays(&triangles, 360));
    assert!(seen.hits > 800 && seen.ties > 150, "{seen:?}");
    // No kernel is off by as much as a structure allows for.
    assert_eq!(seen.too_near, 0);
}

#[test]
fn structures_answer_as_the_list_does_on_odd_triangles() {
    let triangles = odd();
    let seen = agree(&triangles, &rays(&triangles, 360));
    assert!(seen.hits > 700 && seen.ties > 50, "{seen:?}");
}

#[test]
fn structures_of_nothing_and_of_one_hit_what_is_there() {
    let ray = Ray {
        origin: Vec3::ZERO,
        direction: Vec3::Z,
        end: Vec3::Z * 9.0,
        t_min: 0.0,
        t_max: f32::MAX,
    };
    let at = |z: f32| {
        let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z * z];
        Triangle { a: z - x - y, b: z + x + x - y, c: z + y + y - x }
    };
    for kind in &KINDS {
        let mut search = Search::new(LEAVES[0](&[]));
        assert_eq!(search.nearest((kind.build)(&[]).as_ref(), &ray), None, "{}", kind.id);
        let triangles = [at(4.0), at(3.0), at(3.0)];
        for count in 1..=3 {
            let triangles = &triangles[..count];
            let mut search = Search::new(LEAVES[0](triangles));
            let hit = search.nearest((kind.build)(triangles).as_ref(), &ray).unwrap();
            assert_eq!(
                (hit.triangle, hit.t),
                [(0, 4.0), (1, 3.0), (1, 3.0)][count - 1],
                "{}",
                kind.id
            );
        }
    }
}

#[test]
fn a_job_tells_what_searches_tell() {
    use crate::job::{Block, Job};

    let triangles = cube(2);
    let rays = rays(&triangles, 45);
    let structure = |id: &str| (kind(id).unwrap().build)(&triangles);
    let mut search = Search::new(LEAVES[0](&triangles));
    let surface = structure("surface");
    let expected: Vec<_> = rays.iter().map(|ray| search.nearest(surface.as_ref(), ray)).collect();
    let hits = expected.iter().flatten().count() as u64;
    for any in [false, true] {
        let mut job = StructureJob::new(structure("surface"), LEAVES[0](&triangles), &rays, any);
        let whole = Block::whole(&job);
        let once = job.run(whole);
        assert_eq!(once.hits, hits);
        assert_eq!(job.run(Block { repeats: 3, ..whole }), once.times(3));
        assert_eq!(job.run(Block { repeats: 3, literal: true, ..whole }), once.times(3));
        job.permute(&Pcg::new(1).permutation(45));
        assert_eq!(job.run(whole), once);
        assert_eq!((job.counts().rays, job.counts().hits), (45, hits));
        let found = job.answers();
        assert!(
            found.iter().map(|one| one.triangle.is_some()).eq(expected.iter().map(Option::is_some))
        );
        assert!(job.bytes().iter().all(|bytes| *bytes > 0));
    }
}

#[test]
fn structures_take_scenes_of_any_size_and_many_copies() {
    let soup = soup(60, 0.5);
    let scaled = |scale: f32| -> Vec<Triangle> {
        let one =
            |one: &Triangle| Triangle { a: one.a * scale, b: one.b * scale, c: one.c * scale };
        soup.iter().map(one).collect()
    };
    let copies = vec![soup[0]; 2000];
    let point = Triangle { a: Vec3::ONE, b: Vec3::ONE, c: Vec3::ONE };
    let points = vec![point; 2000];
    let mut hits = 0;
    for triangles in [scaled(1e-36), scaled(1e-18), scaled(1e18), scaled(1e36), copies, points] {
        hits += agree(&triangles, &rays(&triangles, 18)).hits;
    }
    // Kernels in f32 find little there; what counts is that every structure is built and walked.
    assert!(hits > 0);
}

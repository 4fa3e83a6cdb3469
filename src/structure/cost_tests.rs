//! What structures cost, counted: the lecture's findings, without a clock.

use super::tests::{cube, leaf, soup};
use super::volume::Bounds;
use super::*;
use crate::job::Block;
use crate::kernels::MollerTrumbore;
use crate::policy::Inside;
use crate::workload::{Pcg, Ray, Triangle};
use glam::Vec3;

/// Lines through the ball of that radius, each as likely as any other, from outside of it.
fn lines(count: usize, radius: f32) -> Vec<Ray> {
    let mut pcg = Pcg::new(8);
    let mut ball = || loop {
        let [x, y, z] = [(); 3].map(|()| (pcg.unit_f64() * 2.0 - 1.0) as f32);
        let point = Vec3::new(x, y, z);
        if point.length_squared() <= 1.0 && point.length_squared() > 1e-4 {
            return point;
        }
    };
    let mut line = || {
        let direction = ball().normalize();
        // A point of the disc across the direction: projected from a ball it would be denser inside.
        let (right, up) = direction.any_orthonormal_pair();
        let place = loop {
            let point = ball();
            if point.z.abs() < 0.5 && point.truncate().length_squared() <= 0.75 {
                break point.truncate() / 0.75f32.sqrt();
            }
        };
        let middle = (right * place.x + up * place.y) * radius;
        let origin = middle - direction * 4.0 * radius;
        Ray { origin, direction, end: middle, t_min: 0.0, t_max: f32::MAX }
    };
    (0..count).map(|_| line()).collect()
}

fn counts(triangles: &[Triangle], structure: &dyn Structure, rays: &[Ray]) -> Counts {
    let mut search = Search::new(leaf::<MollerTrumbore, Inside>(triangles));
    for ray in rays {
        search.nearest(structure, ray);
    }
    search.counts()
}

fn counts_of(id: &str, triangles: &[Triangle], rays: &[Ray]) -> Counts {
    let kind = kind(id).expect("a name of the list");
    counts(triangles, (kind.build)(triangles).as_ref(), rays)
}

#[test]
fn a_volume_leaves_a_share_and_lists_stay_linear() {
    let (triangles, rays) = (soup(300, 0.05), lines(400, 3.0));
    let list = counts_of("list", &triangles, &rays);
    assert_eq!((list.rays, list.triangles, list.share_passed()), (400, 400 * 300, None));
    for id in &BOUNDED[1..] {
        let bounded = counts_of(id, &triangles, &rays);
        assert_eq!((bounded.volumes, bounded.hits), (400, list.hits));
        assert_eq!(bounded.triangles, bounded.passed * 300);
        let share = bounded.share_passed().expect("volumes were tested");
        assert!(share > 0.05 && share < 0.9, "{id} {share}");
        assert!(pays(1.0, share, 300.0) && !pays(300.0 * (1.0 - share), share, 300.0));
    }
    for volume in VOLUMES {
        let mut job = (volume.bind)(&triangles, &rays);
        let whole = Block::whole(job.as_ref());
        let passed = counts_of(volume.id, &triangles, &rays).passed;
        assert_eq!(job.run(whole).hits, passed, "{}", volume.id);
        assert_eq!(
            job.answers().iter().filter(|one| one.triangle.is_some()).count() as u64,
            passed
        );
    }
    let passed = |id: &str| counts_of(id, &triangles, &rays).passed;
    assert!(passed("slabs") < passed("box") && passed("box") < passed("sphere"));
    assert!(passed("sphere-and-box") <= passed("box"));
}

#[test]
fn what_is_sorted_by_distance_ends_early() {
    let (triangles, rays) = (cube(6), lines(300, 6.0));
    let sorted = counts_of("sorted-boxes", &triangles, &rays);
    let all = counts_of("box", &triangles, &rays);
    assert_eq!(sorted.hits, all.hits);
    assert!(sorted.triangles * 8 < all.triangles, "{sorted:?} {all:?}");
}

#[test]
fn what_is_near_is_looked_at_first() {
    // Squares behind each other, seen from both ends.
    let square = |layer: u32| {
        let at = |x: f32, y: f32| Vec3::new(x, y, layer as f32);
        let (a, b, c, d) = (at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0));
        [Triangle { a, b, c }, Triangle { a, b: c, c: d }]
    };
    let triangles: Vec<Triangle> = (0..256).flat_map(square).collect();
    let ray = |z: f32, direction: Vec3| {
        let origin = Vec3::new(0.7, 0.3, z);
        Ray { origin, direction, end: origin + direction, t_min: 0.0, t_max: f32::MAX }
    };
    let rays = [ray(-9.0, Vec3::Z), ray(300.0, -Vec3::Z)];
    for kind in KINDS.iter().filter(|kind| !BOUNDED.contains(&kind.id)) {
        let counts = counts_of(kind.id, &triangles, &rays);
        assert_eq!(counts.hits, 2, "{}", kind.id);
        // Of 512 each; an object of the list of volumes has up to 16.
        assert!(counts.triangles <= 2 * 16, "{} {counts:?}", kind.id);
    }
}

/// Those that test everything or nothing.
const BOUNDED: [&str; 5] = ["list", "sphere", "box", "slabs", "sphere-and-box"];

#[test]
fn cells_are_most_in_a_grid_and_fewest_in_a_kd_tree() {
    let (triangles, rays) = (soup(4000, 0.02), lines(300, 1.5));
    let [grid, octree, kd_tree] =
        ["grid", "octree", "kd-tree"].map(|id| counts_of(id, &triangles, &rays));
    assert!(
        grid.cells > octree.cells && octree.cells > kd_tree.cells,
        "{grid:?} {octree:?} {kd_tree:?}"
    );
    assert!(grid.mailed > 0 && octree.mailed > 0 && kd_tree.mailed > 0);
    assert!(grid.hits == octree.hits && octree.hits == kd_tree.hits);
}

#[test]
fn tests_grow_with_the_list_and_much_less_in_a_hierarchy() {
    let rays = lines(200, 1.5);
    // As many triangles again and again, of a size that leaves the share of lines with a hit alike.
    let work = |id: &str, count: usize| {
        let triangles = soup(count, 1.5 / (count as f32).sqrt());
        let counts = counts_of(id, &triangles, &rays);
        (counts.triangles + counts.volumes + counts.cells) as f64
    };
    let growth = |id: &str| work(id, 8192) / work(id, 128);
    assert_eq!(growth("list"), 64.0);
    for id in ["kd-tree", "inserted", "surface", "surface-slabs", "obvhs", "compressed"] {
        // log2 of 8192 over log2 of 128 is 1.9; a list's square root would be 8.
        let growth = growth(id);
        assert!(growth > 1.0 && growth < 6.0, "{id} {growth}");
    }
}

#[test]
fn insertion_depends_on_the_order() {
    let (triangles, rays) = (soup(1000, 0.05), lines(300, 1.5));
    let mut along: Vec<u32> = (0..1000).collect();
    along.sort_by(|a, b| triangles[*a as usize].a.x.total_cmp(&triangles[*b as usize].a.x));
    let mut shuffled = along.clone();
    Pcg::new(4).shuffle(&mut shuffled);
    let [along, shuffled] = [along, shuffled].map(|order| {
        let tree = Hierarchy::<Bounds>::new(&triangles, &inserted(&triangles, &order));
        counts(&triangles, &tree, &rays)
    });
    assert_eq!(along.hits, shuffled.hits);
    let ratio = along.volumes as f64 / shuffled.volumes as f64;
    assert!((ratio - 1.0).abs() > 0.05, "{along:?} {shuffled:?}");
}

/// Of each pair of boxes that enough lines meet: how far the share of hits is from the ratio of surfaces,
/// in standard deviations of a share drawn so often.
fn deviations() -> Vec<f64> {
    let triangles = soup(200, 0.2);
    let tree = Hierarchy::<Bounds>::new(&triangles, &by_surface_area(&triangles));
    let beams: Vec<Beam> = lines(20_000, 2.2).iter().filter_map(Beam::of_ray).collect();
    let enough = |chance: &&Chance<Bounds>| {
        chance.parent_met >= 1000 && chance.child.area() < chance.parent.area()
    };
    let deviation = |chance: &Chance<Bounds>| {
        let share = chance.child.area() / chance.parent.area();
        let expected = share * chance.parent_met as f64;
        (chance.child_met as f64 - expected) / (expected * (1.0 - share)).sqrt()
    };
    tree.chances(&beams).iter().filter(enough).map(deviation).collect()
}

#[test]
fn the_chance_to_hit_a_child_is_the_ratio_of_surfaces() {
    let boxes = deviations();
    assert!(boxes.len() > 20, "{}", boxes.len());
    // Five standard deviations happen by chance once in two million draws.
    assert!(boxes.iter().all(|deviation| deviation.abs() < 5.0), "{boxes:?}");
}

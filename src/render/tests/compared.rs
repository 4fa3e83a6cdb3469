//! Kernels that are wrong in a known way, and what is counted of them.

use super::*;
use crate::oracle::Query;
use crate::structure::List;
use glam::DVec3;

/// The picture of a kernel with its differences by kind, and the first that is not excused.
fn compared(stage: &Stage, ask: Ask) -> ([Count; 6], Option<(usize, Way)>, Picture) {
    let structure = structure(&stage.triangles);
    let leaf = AskingLeaf::new(ask, &stage.triangles, false);
    // In a list, so that it may hit triangles that the ray is far from.
    let list = List::new(stage.triangles.len() as u32);
    let mut kernel = Searcher::new(&list, Box::new(leaf));
    let exactly = Exactly::new(&stage.triangles, structure.as_ref(), false);
    let [columns, rows] = stage.size();
    let mut compared = Compared::new(&mut kernel, exactly, (columns * rows) as usize);
    let frame = frame(stage, &mut compared, FULL, &mut |_| true).expect("nobody interrupts");
    let counts = Way::ALL.map(|way| compared.count(way));
    (counts, compared.first_wrong(), compared.painted(&frame.picture))
}

/// A near triangle, and a far one that is seen around it and through it.
fn two() -> Stage {
    let mut stage = Stage::new(&mesh(&[facing(0.0, 0.5), facing(-1.0, 3.0)]), [16, 16]);
    // No shadow rays: only what is seen is counted.
    stage.lights.clear();
    stage
}

/// Primary rays of [`two`] that hit the near one, and those that hit any.
fn hits(stage: &Stage) -> [u64; 2] {
    let structure = structure(&stage.triangles);
    let mut exactly = Exactly::new(&stage.triangles, structure.as_ref(), false);
    let pixels = (0..16).flat_map(|row| (0..16).map(move |column| (column, row)));
    let hit: Vec<u32> = pixels
        .filter_map(|(column, row)| exactly.nearest(&stage.primary(column, row)))
        .map(|(triangle, _)| triangle)
        .collect();
    [hit.iter().filter(|one| **one == 0).count() as u64, hit.len() as u64]
}

fn is_near(query: &Query) -> bool {
    query.triangle[0][2] == 0.0
}

fn changed(change: impl Fn(&Query, Option<[f64; 3]>) -> Option<[f64; 3]> + 'static) -> Ask {
    let right = right();
    Box::new(move |query| change(query, right(query)))
}

#[test]
fn the_right_kernel_differs_nowhere() {
    let (counts, first, painted) = compared(&two(), right());
    assert_eq!((counts, first), ([Count::default(); 6], None));
    let is_grey = |pixel: &DVec3| pixel.x == pixel.y && pixel.y == pixel.z && pixel.x >= 0.6;
    assert!(painted.pixels().iter().all(is_grey));
    let [near, any] = hits(&two());
    assert!(near > 5 && any > near + 30 && any < 256, "{near} {any}");
}

#[test]
fn a_triangle_that_is_not_seen_is_a_crack_with_or_without_something_behind() {
    let [near, any] = hits(&two());
    let (counts, first, _) =
        compared(&two(), changed(|query, hit| hit.filter(|_| !is_near(query))));
    assert_eq!(counts[0], Count { rays: near, excused: 0, pixels: near });
    assert_eq!(counts[1..], [Count::default(); 5]);
    assert!(matches!(first, Some((_, Way::Crack))));
    let (counts, ..) = compared(&two(), changed(|_, _| None));
    assert_eq!(counts[0].rays, any);
}

#[test]
fn a_hit_of_what_is_not_there_is_false_or_takes_the_place_of_another() {
    let [near, any] = hits(&two());
    // The near one is hit everywhere: in its plane, in front of the far one.
    let everywhere = |query: &Query, hit: Option<[f64; 3]>| {
        let t = (query.triangle[0][2] - query.origin[2]) / query.direction[2];
        if is_near(query) { Some([t, 0.3, 0.3]) } else { hit }
    };
    let (counts, first, painted) = compared(&two(), changed(everywhere));
    assert_eq!(counts[1].rays, 256 - any);
    assert_eq!(counts[2].rays, any - near);
    assert_eq!((counts[0], counts[3]), (Count::default(), Count::default()));
    assert_eq!(first, Some((0, Way::FalseHit)));
    assert_eq!(painted.pixels()[0], colour(Way::FalseHit));
}

#[test]
fn a_distance_that_rounding_does_not_explain_is_counted() {
    let [near, _] = hits(&two());
    let farther = |by: f64| {
        changed(move |query, hit| {
            hit.map(|[t, u, v]| if is_near(query) { [t * (1.0 + by), u, v] } else { [t, u, v] })
        })
    };
    let (counts, ..) = compared(&two(), farther(1e-2));
    assert_eq!(counts[3], Count { rays: near, excused: 0, pixels: near });
    let (counts, first, _) = compared(&two(), farther(1e-7));
    assert_eq!((counts[3], first), (Count::default(), None));
}

#[test]
fn a_shadow_that_is_lost_is_counted() {
    // The kernel sees the near one from the eye, but not from below, where it blocks the light.
    let mut stage = Stage::new(&mesh(&[facing(0.0, 0.5), facing(-1.0, 3.0)]), [16, 16]);
    stage.lights.truncate(1);
    stage.lights[0].place = Vec3::new(2.0, 0.0, 4.0);
    let downwards = |query: &Query, hit: Option<[f64; 3]>| hit.filter(|_| query.direction[2] < 0.0);
    let (counts, first, painted) = compared(&stage, changed(downwards));
    let Count { rays, excused, pixels } = counts[5];
    assert!(rays > 0 && excused == 0 && pixels == rays, "{counts:?}");
    assert_eq!(counts[..5], [Count::default(); 5]);
    let Some((pixel, Way::Shadow)) = first else { panic!("{first:?}") };
    assert_eq!(painted.pixels()[pixel], colour(Way::Shadow));
}

#[test]
fn rounding_excuses_what_is_on_an_edge_which_is_an_outline_or_a_crack() {
    let lost = |_: &Query, hit: Option<[f64; 3]>| {
        hit.filter(|[_, u, v]| u.min(*v).min(1.0 - u - v) > 1e-7)
    };
    // An edge passes the middle of the picture, where its one pixel is.
    let upper = [Vec3::X, Vec3::NEG_X, Vec3::Y];
    let lower = [Vec3::NEG_X, Vec3::X, Vec3::NEG_Y];
    for (triangles, place) in [(vec![upper], 4), (vec![upper, lower], 0)] {
        let mut stage = Stage::new(&mesh(&triangles), [1, 1]);
        stage.lights.clear();
        let (counts, first, _) = compared(&stage, changed(lost));
        assert_eq!(counts[place], Count { rays: 1, excused: 1, pixels: 1 });
        assert_eq!((counts.iter().map(|count| count.rays).sum::<u64>(), first), (1, None));
    }
}

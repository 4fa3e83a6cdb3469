//! A part of the scene's own rays and triangles, small enough to be timed again and again.

use super::nearby::Nearby;
use super::proof::Nearest;
use crate::workload::{Pcg, Ray, Triangle};

/// Tests of a sample of pairs, as many as the experiments on pairs have.
const PAIRS: usize = 4000;
/// Fewer are too short a block for a clock; the same pairs stand in a sample again until there are more.
const FEWEST_PAIRS: usize = 1000;
/// Rays against all triangles, as the experiments on these have them.
const RAYS: usize = 256;
/// Purpose of the generator.
const SAMPLE: u64 = 104;

/// What is tested against what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// Ray i against triangle i: the tests of a search through a hierarchy.
    Pairs,
    /// Every ray against every triangle: where there is no hierarchy.
    Nearest,
}

/// Rays and triangles of a scene.
#[derive(Clone, Debug)]
pub struct Sample {
    /// What is tested against what.
    pub arrangement: Arrangement,
    /// The rays.
    pub rays: Vec<Ray>,
    /// The triangles.
    pub triangles: Vec<Triangle>,
}

/// Draws rays, one after the other in a drawn order. Of a hierarchy, each with the triangles that it comes
/// near on the way to its hit: those that a search tests, no others. A test is taken only where `suits`
/// says that its answer is beyond doubt; where none is, any will do.
pub fn draw(
    arrangement: Arrangement,
    (rays, nearest): (&[Ray], &[Nearest]),
    nearby: &mut Nearby<'_>,
    seed: u64,
    suits: &mut dyn FnMut(&Ray, &[Triangle]) -> bool,
) -> Sample {
    let order = Pcg::stream(seed, SAMPLE).permutation(rays.len() as u32);
    let found = match arrangement {
        Arrangement::Pairs => pairs((rays, nearest), nearby, &order, suits),
        Arrangement::Nearest => all(rays, nearby, &order, suits),
    };
    if !found.rays.is_empty() {
        return found;
    }
    match arrangement {
        Arrangement::Pairs => pairs((rays, nearest), nearby, &order, &mut |_, _| true),
        Arrangement::Nearest => all(rays, nearby, &order, &mut |_, _| true),
    }
}

fn all(
    rays: &[Ray],
    nearby: &Nearby<'_>,
    order: &[u32],
    suits: &mut dyn FnMut(&Ray, &[Triangle]) -> bool,
) -> Sample {
    let triangles = nearby.triangles().to_vec();
    let drawn = order.iter().map(|place| rays[*place as usize]);
    let rays = drawn.filter(|ray| suits(ray, &triangles)).take(RAYS).collect();
    Sample { arrangement: Arrangement::Nearest, rays, triangles }
}

fn pairs(
    (rays, nearest): (&[Ray], &[Nearest]),
    nearby: &mut Nearby<'_>,
    order: &[u32],
    suits: &mut dyn FnMut(&Ray, &[Triangle]) -> bool,
) -> Sample {
    let mut sample =
        Sample { arrangement: Arrangement::Pairs, rays: Vec::new(), triangles: Vec::new() };
    for place in order.iter().map(|place| *place as usize) {
        let ray = rays[place];
        // As far as a search goes that has found the hit; not less, whichever way the conversion rounds.
        let hit = nearest[place].as_ref().map(|(_, exact)| (exact.t as f32).next_up());
        let t_max = hit.map_or(ray.t_max, |t| t.min(ray.t_max));
        let near = nearby.of(&Ray { t_max, ..ray });
        for triangle in nearby.taken(&near) {
            if suits(&ray, &[triangle]) {
                sample.rays.push(ray);
                sample.triangles.push(triangle);
            }
        }
        if sample.rays.len() >= PAIRS {
            break;
        }
    }
    sample.rays.truncate(PAIRS);
    sample.triangles.truncate(PAIRS);
    let own = sample.rays.len();
    while own > 0 && sample.rays.len() < FEWEST_PAIRS {
        sample.rays.extend_from_within(..own);
        sample.triangles.extend_from_within(..own);
    }
    sample
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::{Query, classify};
    use crate::plan::rays::{Asking, draw as draw_rays};
    use crate::plan::usage::{Use, Wanted};
    use crate::scene::built_in::named;

    fn sample(model: &str, usage: Use, arrangement: Arrangement) -> Sample {
        let mesh = named(model).expect("a name").expect("a size");
        let list = mesh.list();
        let mut nearby = Nearby::new(&list);
        let wanted = Wanted::of(None, Some(usage), None);
        let rays = draw_rays(&wanted, &mesh, Asking::new(1), |_| None).expect("rays").rays;
        let nearest: Vec<Nearest> = rays.iter().map(|ray| nearby.nearest(ray)).collect();
        draw(arrangement, (&rays, &nearest), &mut nearby, 1, &mut |_, _| true)
    }

    #[test]
    fn pairs_are_the_tests_of_a_search() {
        let sample = sample("icosphere:3", Use::Raytracing, Arrangement::Pairs);
        assert_eq!((sample.rays.len(), sample.triangles.len()), (PAIRS, PAIRS));
        let hit = |(ray, triangle)| classify(&Query::of(ray, triangle)).is_hit();
        let hits = sample.rays.iter().zip(&sample.triangles).filter(|pair| hit(*pair)).count();
        // Each ray that meets the ball has one hit, among few others: it ends there.
        assert!(hits > PAIRS / 10 && hits < PAIRS, "{hits}");
    }

    #[test]
    fn few_pairs_stand_there_again() {
        let sample = sample("terrain:16", Use::Collision, Arrangement::Pairs);
        let count = sample.rays.len();
        assert!((FEWEST_PAIRS..2 * FEWEST_PAIRS).contains(&count), "{count}");
        assert_eq!(sample.triangles.len(), count);
    }

    #[test]
    fn without_a_hierarchy_every_triangle_is_there() {
        let sample = sample("cornell-box:1", Use::Raytracing, Arrangement::Nearest);
        assert_eq!(sample.rays.len(), RAYS);
        let mesh = named("cornell-box:1").expect("a name").expect("a size");
        assert_eq!(sample.triangles, mesh.list());
    }
}

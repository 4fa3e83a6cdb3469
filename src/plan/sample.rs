//! A part of the scene's own rays and triangles, small enough to be timed again and again.

use super::nearby::Nearby;
use super::proof::Nearest;
use crate::workload::{Pcg, Ray, Triangle};

/// Triangles that every ray of the sample is tested against.
const TRIANGLES: usize = 64;
/// Where they come from: the leaves of so many rays, a like number of each. Rays of other places hardly
/// meet them, and a sample of misses says nothing of hits.
const PLACES: usize = 8;
/// Rays, as in the experiments on rays and all triangles.
const RAYS: usize = 256;
/// Purpose of the generator.
const SAMPLE: u64 = 104;

/// Rays against all of some triangles.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Of the scene, in its order.
    pub rays: Vec<Ray>,
    /// All of the scene if there are no more than 64; else those of the leaves that eight drawn rays visit
    /// before their hit.
    pub triangles: Vec<Triangle>,
}

/// Draws a sample: triangles, then rays that come near one of them, in a drawn order, as long as `suits`
/// says that they have an answer beyond doubt among the triangles. Where there is no such ray, any will do.
pub fn draw(
    rays: &[Ray],
    nearest: &[Nearest],
    nearby: &mut Nearby<'_>,
    seed: u64,
    suits: &mut dyn FnMut(&Ray, &[Triangle]) -> bool,
) -> Sample {
    let mut source = Pcg::stream(seed, SAMPLE);
    let order = source.permutation(rays.len() as u32);
    let chosen = chosen(rays, nearest, nearby, &order);
    let triangles = nearby.taken(&chosen);
    let mut places: Vec<u32> = Vec::new();
    for place in &order {
        let ray = &rays[*place as usize];
        let is_near = nearby.of(ray).iter().any(|index| chosen.binary_search(index).is_ok());
        if is_near && suits(ray, &triangles) {
            places.push(*place);
        }
        if places.len() == RAYS {
            break;
        }
    }
    if places.is_empty() {
        places.extend(order.iter().take(RAYS));
    }
    places.sort_unstable();
    Sample { rays: places.iter().map(|place| rays[*place as usize]).collect(), triangles }
}

/// Indices of the triangles, ascending.
fn chosen(rays: &[Ray], nearest: &[Nearest], nearby: &mut Nearby<'_>, order: &[u32]) -> Vec<u32> {
    let all = nearby.triangles().len();
    if all <= TRIANGLES {
        return (0..all as u32).collect();
    }
    let mut chosen: Vec<u32> = Vec::new();
    for place in order {
        let (ray, hit) = (&rays[*place as usize], &nearest[*place as usize]);
        // As far as a search goes that knows the hit.
        let t_max = hit.as_ref().map_or(ray.t_max, |(_, exact)| (exact.t as f32).min(ray.t_max));
        let near = nearby.of(&Ray { t_max, ..*ray });
        let own = hit.as_ref().map(|(index, _)| *index as u32);
        let fresh = own.into_iter().chain(near).filter(|index| !chosen.contains(index));
        let mut fresh: Vec<u32> = fresh.take(TRIANGLES / PLACES).collect();
        fresh.sort_unstable();
        fresh.dedup();
        chosen.extend(fresh);
        if chosen.len() >= TRIANGLES {
            break;
        }
    }
    chosen.truncate(TRIANGLES);
    chosen.sort_unstable();
    if chosen.is_empty() { (0..TRIANGLES as u32).collect() } else { chosen }
}

//! The rays that a plan is for.

use super::usage::{Source, Wanted};
use crate::check::read::ReadError;
use crate::scene::mesh::Mesh;
use crate::scene::rays::{Asked, OFFSET, Plan as Drawing, Rays};
use crate::workload::{Pcg, Ray, Triangle, on_sphere};
use glam::{DVec3, Vec3};

/// Segments of simulations: orders of magnitude fewer than the rays of a picture (H 2.3).
const SEGMENTS: usize = 64;
/// The part of the diagonal that a fast and small thing moves in a step.
const STEP: f64 = 0.125;
/// How often a pair that faces away is drawn again, per pair that is wanted.
const ATTEMPTS: usize = 8;
/// Pixels of a picture: those that are asked are a part of it.
const PICTURE: u64 = 1920 * 1080;
/// Unit roundoff of f32.
const UNIT_ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;
/// Purposes of the generator.
const STEPS: u64 = 101;
const SIGHTS: u64 = 102;
const PATCHES: u64 = 103;

/// How many rays are asked, and by which numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asking {
    /// Pixels along each side of a camera's picture. Random rays are as many as pixels, pairs of patches
    /// at most as many.
    pub side: u32,
    /// Where the generator starts.
    pub seed: u64,
}

impl Asking {
    /// 128 x 128 pixels.
    pub fn new(seed: u64) -> Self {
        Asking { side: 128, seed }
    }

    fn pixels(self) -> usize {
        (self.side * self.side) as usize
    }
}

/// Rays, and how many there would be of them.
pub struct Crowd {
    /// Those that are asked.
    pub rays: Vec<Ray>,
    /// As many as the use has: of a picture more than are asked, and of all pairs of patches.
    pub in_use: u64,
}

/// Draws them. `nearest` gives the index of the first triangle that a ray meets.
///
/// # Errors
/// Of a file: what is wrong, where, and what is allowed. Also where no ray comes of it.
pub fn draw(
    wanted: &Wanted,
    mesh: &Mesh,
    asking: Asking,
    nearest: impl FnMut(&Ray) -> Option<u32>,
) -> Result<Crowd, ReadError> {
    let Asking { side, seed } = asking;
    let mut in_use = None;
    let mut rays = match &wanted.source {
        Source::Rays(asked) => {
            let drawing = Drawing { width: side, height: side, per_point: 1, seed };
            let rays = Rays::of(asked, mesh, drawing, nearest)?.rays;
            if matches!(asked, Asked::Primary | Asked::Shadow | Asked::Ambient) {
                in_use = Some(rays.len() as u64 * PICTURE / asking.pixels() as u64);
            }
            rays
        }
        Source::Steps => segments(mesh, &mut Pcg::stream(seed, STEPS), Hall::step),
        Source::Sights => segments(mesh, &mut Pcg::stream(seed, SIGHTS), Hall::sight),
        Source::Patches => {
            let patches = mesh.triangles.len() as u64;
            in_use = Some(patches * patches.saturating_sub(1));
            pairs(mesh, asking.pixels(), &mut Pcg::stream(seed, PATCHES))
        }
    };
    // Structures and leaves count what lies before the origin for nothing: a search is along a ray.
    rays.iter_mut().for_each(|ray| ray.t_min = ray.t_min.max(0.0));
    if rays.is_empty() {
        let file = mesh.name.clone();
        let message = format!(
            "no '{}' ray comes of it (no primary ray meets it, all of it is dark, or no two patches \
             see each other); allowed: --rays random, or a file of rays",
            wanted.source.word()
        );
        return Err(ReadError::Whole { file, message });
    }
    Ok(Crowd { in_use: in_use.unwrap_or(rays.len() as u64), rays })
}

/// The box around a mesh, as far as segments are drawn in it.
struct Hall {
    low: DVec3,
    high: DVec3,
    diagonal: f64,
}

impl Hall {
    /// A random point.
    fn point(&self, source: &mut Pcg) -> DVec3 {
        let share = DVec3::new(source.unit_f64(), source.unit_f64(), source.unit_f64());
        self.low + (self.high - self.low) * share
    }

    /// Where a step from a point ends.
    fn step(&self, from: DVec3, source: &mut Pcg) -> DVec3 {
        from + on_sphere(source).as_dvec3() * (STEP * self.diagonal)
    }

    /// What is looked at, wherever from.
    fn sight(&self, _: DVec3, source: &mut Pcg) -> DVec3 {
        self.point(source)
    }
}

/// Segments from random points to where `to` says.
fn segments(mesh: &Mesh, source: &mut Pcg, to: fn(&Hall, DVec3, &mut Pcg) -> DVec3) -> Vec<Ray> {
    let bounds = mesh.bounds();
    let (low, high) = (bounds.lowest.as_dvec3(), bounds.highest.as_dvec3());
    let hall = Hall { low, high, diagonal: bounds.diagonal() };
    let mut one = || {
        let from = hall.point(source);
        between(from, to(&hall, from, source))
    };
    (0..SEGMENTS).filter_map(|_| one()).collect()
}

/// A ray from one point to another, with a direction of length 1.
fn between(from: DVec3, to: DVec3) -> Option<Ray> {
    let (way, length) = (to - from, (to - from).length());
    let direction = (way / length).as_vec3();
    let (origin, end, t_max) = (from.as_vec3(), to.as_vec3(), length as f32);
    (length > 0.0 && direction.is_finite()).then_some(Ray {
        origin,
        direction,
        end,
        t_min: 0.0,
        t_max,
    })
}

/// All pairs of patches that face each other, or a drawn part of them: a pair that does not has a form
/// factor of 0 without any ray. Where no two do, as on a ball, those whose backs do: which side of a
/// patch is its front is for the mesh to say, and not all do.
fn pairs(mesh: &Mesh, most: usize, source: &mut Pcg) -> Vec<Ray> {
    let mut list = mesh.list();
    let fronts = facing(&list, most, source);
    if !fronts.is_empty() {
        return fronts;
    }
    list.iter_mut().for_each(|patch| std::mem::swap(&mut patch.b, &mut patch.c));
    facing(&list, most, source)
}

fn facing(list: &[Triangle], most: usize, source: &mut Pcg) -> Vec<Ray> {
    let count = list.len();
    if count * count <= most {
        let all = (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
        return all.filter_map(|(i, j)| pair(&list[i], &list[j])).collect();
    }
    let mut rays = Vec::new();
    for _ in 0..ATTEMPTS * most {
        let mut one = || &list[source.below(count as u64) as usize];
        let (from, to) = (one(), one());
        rays.extend(pair(from, to));
        if rays.len() == most {
            break;
        }
    }
    rays
}

fn pair(from: &Triangle, to: &Triangle) -> Option<Ray> {
    let (start, end) = (above(from)?, above(to)?);
    let way = end - start;
    let faces = normal(from).dot(way) > 0.0 && normal(to).dot(way) < 0.0;
    if faces { between(start, end) } else { None }
}

/// The centre of a patch, off it to the front as shadow rays start.
fn above(patch: &Triangle) -> Option<DVec3> {
    let largest = [patch.a, patch.b, patch.c].map(|p| p.abs().max_element()).into_iter();
    let off = OFFSET * UNIT_ROUNDOFF * f64::from(largest.fold(0.0, f32::max));
    Some(centre(patch) + normal(patch).try_normalize()? * off)
}

fn centre(triangle: &Triangle) -> DVec3 {
    let [a, b, c]: [Vec3; 3] = [triangle.a, triangle.b, triangle.c];
    (a.as_dvec3() + b.as_dvec3() + c.as_dvec3()) / 3.0
}

fn normal(triangle: &Triangle) -> DVec3 {
    let a = triangle.a.as_dvec3();
    (triangle.b.as_dvec3() - a).cross(triangle.c.as_dvec3() - a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::usage::Use;
    use crate::scene::built_in::named;

    fn crowd(model: &str, usage: Use) -> (Mesh, Crowd) {
        let mesh = named(model).expect("a name").expect("a size");
        let crowd = draw(&Wanted::of(None, Some(usage), None), &mesh, Asking::new(1), |_| None);
        (mesh, crowd.expect("there are rays"))
    }

    #[test]
    fn segments_are_few_and_end() {
        for usage in [Use::Collision, Use::Visibility] {
            let (mesh, crowd) = crowd("cornell-box", usage);
            assert_eq!((crowd.rays.len(), crowd.in_use), (SEGMENTS, SEGMENTS as u64));
            let bounds = mesh.bounds();
            assert!(crowd.rays.iter().all(|ray| bounds.holds(ray.origin)));
            assert!(crowd.rays.iter().all(|ray| f64::from(ray.t_max) <= bounds.diagonal()));
        }
    }

    #[test]
    fn patches_that_see_each_other_face_each_other() {
        let (mesh, crowd) = crowd("cornell-box", Use::Radiosity);
        let count = mesh.triangles.len() as u64;
        assert_eq!(crowd.in_use, count * (count - 1));
        assert!(!crowd.rays.is_empty() && crowd.rays.len() <= Asking::new(1).pixels());
        // The fronts of a ball's patches see none of each other, their backs do.
        let (ball, crowd) = self::crowd("icosphere:1", Use::Radiosity);
        assert_eq!(crowd.rays.len(), ball.triangles.len() * (ball.triangles.len() - 1));
        // One triangle sees nothing.
        let mut one = ball;
        one.triangles.truncate(1);
        let wanted = Wanted::of(None, Some(Use::Radiosity), None);
        let refusal =
            draw(&wanted, &one, Asking::new(1), |_| None).err().map(|error| error.to_string());
        assert!(refusal.is_some_and(|text| text.contains("no 'patches' ray")));
    }

    #[test]
    fn the_same_seed_draws_the_same() {
        let ray = |usage| crowd("terrain:8", usage).1.rays[7];
        assert_eq!(ray(Use::Collision), ray(Use::Collision));
        assert_ne!(ray(Use::Collision), ray(Use::Visibility));
    }
}

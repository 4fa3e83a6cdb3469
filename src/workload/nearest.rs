//! Rays against all triangles, the nearest hit beyond doubt.

use super::camera::Camera;
use super::error::counted;
use super::random::{Pcg, Unit};
use super::settled::{Standing, aspect};
use super::{Ray, Triangle, WorkloadError, hash, thesis};
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// Lanes of the widest packet; the number of rays is a multiple of it.
pub(super) const PACKET: usize = 16;
/// Beyond this the nearest hits lie so close together that rounding decides most of them.
const MOST_TRIANGLES: u64 = 1 << 16;
/// Each of the two, and their product, is bounded: drawing is a test of every ray and triangle.
const MOST_RAYS: u64 = 1 << 20;
const MOST_TESTS: u64 = 1 << 30;
/// As for pairs, but less: with many triangles the gaps between hits are small.
const ALLOWANCE: f64 = 16.0;
/// Triangles longer than this by their width are drawn again (about 1 %): no ray's answer on
/// them is beyond doubt.
const LARGEST_ASPECT: f64 = 100.0;
/// How often one ray is drawn.
const MOST_ATTEMPTS: u64 = 1000;
/// What heights of a terrain are multiplied by: a power of two, so that it rounds nothing.
const FLATNESS: f32 = 0.0625;
/// The scene is the unit ball; segments end this far beyond it.
pub(super) const BEYOND: f32 = 0.25;
/// Of bunches: from there on they are random rays.
const MOST_SPREAD: f32 = 1000.0;

/// How the rays of a packet belong together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Not at all: each from a random point of the unit sphere to another.
    #[default]
    Random,
    /// One camera, and 16 consecutive rays are a 4 x 4 tile of its pixels.
    Coherent,
    /// By bunches of 16: each ray runs near the bunch's own random ray, see [`NearestSpec::spread`].
    Bunches,
    /// A camera above a terrain: no triangle is steeper than 45 degrees; else as `coherent`.
    Terrain,
    /// One direction, along no axis; 16 consecutive rays are a 4 x 4 tile of a picture without
    /// perspective.
    Parallel,
}

impl Kind {
    /// The word for it in configs and columns.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Random => "random",
            Kind::Coherent => "coherent",
            Kind::Bunches => "bunches",
            Kind::Terrain => "terrain",
            Kind::Parallel => "parallel",
        }
    }
}

/// What to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestSpec {
    /// Number of triangles, 1 to 2^16.
    pub triangles: usize,
    /// Number of rays, a multiple of 16 up to 2^20; times triangles at most 2^30.
    pub rays: usize,
    /// How the rays belong together.
    pub kind: Kind,
    /// Of bunches: how far, in radii of the scene, both points that make a ray are from those of the
    /// bunch's own ray before they are put back on the sphere; above 0, at most 1 000. Others take 0.
    pub spread: f32,
    /// Where the generator starts.
    pub seed: u64,
}

/// Rays and triangles, every ray to be tested against every triangle.
///
/// Triangles have their vertices, and random rays their origin and a second point, uniform on the
/// unit sphere. Kensler and Shirley do not print their distribution; this one is isotropic, has no
/// parameter, gives a hit rate of 9.98 % for a single test (half of it with back faces culled),
/// and puts every triangle in front of every random origin, so that the hit rate of lines, rays
/// and segments is the same.
#[derive(Clone, Debug)]
pub struct NearestSet {
    /// t from 0 to MAX; `end` lies on the ray, beyond the scene.
    pub rays: Vec<Ray>,
    /// In the unit ball.
    pub triangles: Vec<Triangle>,
    /// [`hash::workload`] of both.
    pub hash: u64,
    /// Rays drawn again since rounding could have decided their nearest triangle.
    pub redrawn: u64,
}

impl NearestSpec {
    /// Refuses what cannot be drawn.
    ///
    /// # Errors
    /// What, and what is allowed.
    pub fn validate(&self) -> Result<(), WorkloadError> {
        validated(self)
    }
}

impl NearestSet {
    /// Draws a set. A ray is drawn again (within its pixel, if it has one) when some triangle that
    /// rounding could make its nearest is not the nearest by more than rounding.
    ///
    /// # Errors
    /// For a specification that is not allowed, or a ray that was drawn 1 000 times in vain.
    pub fn draw(spec: NearestSpec) -> Result<Self, WorkloadError> {
        validated(&spec)?;
        let mut source = Pcg::new(spec.seed);
        let one = if spec.kind == Kind::Terrain { flat_triangle } else { triangle };
        let triangles: Vec<Triangle> = (0..spec.triangles).map(|_| one(&mut source)).collect();
        let camera = Camera::new(spec.rays);
        let mut bunch = [Vec3::ZERO; 2];
        let mut rays = Vec::with_capacity(spec.rays);
        let mut attempts = 0u64;
        for index in 0..spec.rays {
            if spec.kind == Kind::Bunches && index.is_multiple_of(PACKET) {
                bunch = [on_sphere(&mut source), on_sphere(&mut source)];
            }
            let mut tries = 0;
            loop {
                attempts += 1;
                tries += 1;
                let ray = match spec.kind {
                    Kind::Random => random_ray(&mut source),
                    Kind::Coherent | Kind::Terrain => camera.ray(index, &mut source),
                    Kind::Bunches => bunched_ray(bunch, spec.spread, &mut source),
                    Kind::Parallel => camera.parallel_ray(index, &mut source),
                };
                if nearest_is_settled(&ray, &triangles) {
                    rays.push(ray);
                    break;
                }
                if tries == MOST_ATTEMPTS {
                    return Err(WorkloadError::Rays { attempts, rays: index, wanted: spec.rays });
                }
            }
        }
        let hash = hash::workload(&rays, &triangles);
        Ok(NearestSet { redrawn: attempts - rays.len() as u64, rays, triangles, hash })
    }
}

fn validated(spec: &NearestSpec) -> Result<(), WorkloadError> {
    counted("number of triangles", spec.triangles, 1, MOST_TRIANGLES)?;
    counted("number of rays", spec.rays, 1, MOST_RAYS)?;
    if !spec.rays.is_multiple_of(PACKET) {
        return Err(WorkloadError::Packets { value: spec.rays, multiple: PACKET });
    }
    let is_spread = spec.spread > 0.0 && spec.spread <= MOST_SPREAD;
    if is_spread != (spec.kind == Kind::Bunches) {
        return Err(WorkloadError::Spread { value: spec.spread, most: MOST_SPREAD });
    }
    // Both are below 2^21 by now.
    counted("rays times triangles", spec.rays * spec.triangles, 1, MOST_TESTS)
}

/// Whether every kernel must find the same nearest triangle, or none.
fn nearest_is_settled(ray: &Ray, triangles: &[Triangle]) -> bool {
    let mut nearest = f64::INFINITY;
    let mut rivals: Vec<Standing> = Vec::new();
    for triangle in triangles {
        let standing = Standing::of(ray, triangle, ALLOWANCE);
        if standing.is_miss() {
            continue;
        }
        if standing.is_hit() {
            nearest = nearest.min(standing.t + standing.doubt);
        }
        rivals.push(standing);
    }
    // The nearest itself is one of those that could be. A t that is not finite always could be.
    let is_behind = |rival: &&Standing| rival.t - rival.doubt > nearest;
    let possible = rivals.len() - rivals.iter().filter(is_behind).count();
    possible == usize::from(nearest.is_finite())
}

fn triangle(source: &mut Pcg) -> Triangle {
    loop {
        let a = on_sphere(source);
        let b = on_sphere(source);
        let c = on_sphere(source);
        let triangle = Triangle { a, b, c };
        if aspect(&triangle) <= LARGEST_ASPECT {
            return triangle;
        }
    }
}

/// A triangle whose normal has its largest component along z.
fn flat_triangle(source: &mut Pcg) -> Triangle {
    loop {
        let flat = |p: Vec3| Vec3::new(p.x, p.y, p.z * FLATNESS);
        let Triangle { a, b, c } = triangle(source);
        let triangle = Triangle { a: flat(a), b: flat(b), c: flat(c) };
        let n = (triangle.b - triangle.a).cross(triangle.c - triangle.a).abs();
        if n.z >= n.x && n.z >= n.y && aspect(&triangle) <= LARGEST_ASPECT {
            return triangle;
        }
    }
}

/// A point of the unit sphere: a point of the cube that is in the ball but not near its centre,
/// divided by its length.
pub(crate) fn on_sphere(source: &mut Pcg) -> Vec3 {
    loop {
        let x = 2.0 * source.unit() - 1.0;
        let y = 2.0 * source.unit() - 1.0;
        let z = 2.0 * source.unit() - 1.0;
        let point = Vec3::new(x, y, z);
        if (0.01..=1.0).contains(&thesis::length(point)) {
            return thesis::normalised(point);
        }
    }
}

/// A ray and a triangle as random sets have them, the next of a generator, without regard to what
/// rounding makes of them: what errors are measured on.
pub fn random_pair(source: &mut Pcg) -> (Ray, Triangle) {
    let triangle = triangle(source);
    (random_ray(source), triangle)
}

fn random_ray(source: &mut Pcg) -> Ray {
    let origin = on_sphere(source);
    let target = on_sphere(source);
    let chord = target - origin;
    ray(origin, thesis::normalised(chord), thesis::length(chord) + BEYOND)
}

/// A ray between two points of the sphere near those of the bunch.
fn bunched_ray(bunch: [Vec3; 2], spread: f32, source: &mut Pcg) -> Ray {
    let [origin, target] = bunch.map(|point| near(point, spread, source));
    let chord = target - origin;
    ray(origin, thesis::normalised(chord), thesis::length(chord) + BEYOND)
}

/// A point of the sphere: `point`, moved by `spread` in a random direction and put back.
fn near(point: Vec3, spread: f32, source: &mut Pcg) -> Vec3 {
    loop {
        let moved = point + on_sphere(source) * spread;
        if thesis::length(moved) >= 0.01 {
            return thesis::normalised(moved);
        }
    }
}

/// From t = 0 to the largest number, and a segment of that length.
pub(crate) fn ray(origin: Vec3, direction: Vec3, length: f32) -> Ray {
    Ray { origin, direction, end: origin + direction * length, t_min: 0.0, t_max: f32::MAX }
}

#[cfg(test)]
#[path = "nearest_tests.rs"]
mod tests;

//! The colour that a ray brings back.

use super::material::Material;
use super::stage::{Light, Stage};
use super::tracer::Tracer;
use crate::scene::rays::{Spot, beyond, towards_light};
use crate::workload::Ray;
use glam::DVec3;

/// Light that comes from everywhere.
const AMBIENT: f64 = 0.12;
/// Above and below of what is behind everything.
const SKY: [DVec3; 2] = [DVec3::new(0.55, 0.65, 0.80), DVec3::new(0.90, 0.90, 0.88)];

/// Rays that were cast, by what for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rays {
    /// From the eye.
    pub primary: u64,
    /// To a light.
    pub shadow: u64,
    /// Into a mirror.
    pub reflected: u64,
}

impl Rays {
    /// All of them.
    pub fn all(&self) -> u64 {
        self.primary + self.shadow + self.reflected
    }
}

/// How far rays are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Following {
    /// Mirrors in a row.
    pub depth: u32,
    /// Primary rays only: no shadows, no mirrors.
    pub casts_only: bool,
}

/// Follows rays on a stage.
pub(super) struct Follower<'a> {
    pub stage: &'a Stage,
    pub tracer: &'a mut dyn Tracer,
    pub following: Following,
    pub rays: Rays,
}

impl Follower<'_> {
    /// The colour of a pixel, each of red, green and blue from 0 to 1, as shown.
    pub fn pixel(&mut self, column: u32, row: u32) -> DVec3 {
        let [columns, _] = self.stage.size();
        self.tracer.begin(row as usize * columns as usize + column as usize);
        self.rays.primary += 1;
        let ray = self.stage.primary(column, row);
        shown(self.light_along(&ray, 0))
    }

    /// Light that comes back along a ray, red, green and blue; `mirrors` are behind it.
    fn light_along(&mut self, ray: &Ray, mirrors: u32) -> DVec3 {
        let direction = ray.direction.as_dvec3();
        let Some(hit) = self.tracer.nearest(ray) else { return background(direction) };
        let index = hit.triangle as usize;
        let material = self.stage.surfaces[index];
        if material.glows {
            return material.colour;
        }
        // A ray that lies in the triangle's plane sees none of its light.
        let Some(spot) = Spot::of(ray, &self.stage.triangles[index]) else { return DVec3::ZERO };
        let own = self.own_light(&spot, direction, &material);
        if material.mirror == 0.0 || mirrors >= self.following.depth || self.following.casts_only {
            return own;
        }
        let way = direction - spot.normal * (2.0 * spot.normal.dot(direction));
        self.rays.reflected += 1;
        let reflected = beyond(spot.start, way.normalize(), &self.stage.bounds);
        own.lerp(self.light_along(&reflected, mirrors + 1), material.mirror)
    }

    /// What a surface shows without mirrors: of every light that reaches it, Lambert's and Blinn's.
    fn own_light(&mut self, spot: &Spot, direction: DVec3, material: &Material) -> DVec3 {
        let stage = self.stage;
        let mut sum = material.colour * AMBIENT;
        for light in stage.lights.iter().filter(|light| self.is_lit(spot, light)) {
            let way = (light.place.as_dvec3() - spot.start.as_dvec3()).normalize_or_zero();
            let half = (way - direction).normalize_or_zero();
            // Squared again and again: a power whose bits are the same on every machine.
            let gloss = (0..material.sharpness)
                .fold(spot.normal.dot(half).max(0.0), |power, _| power * power);
            let scattered = material.colour * spot.normal.dot(way);
            sum += (scattered + material.shine * gloss) * light.strength;
        }
        sum
    }

    /// Whether the spot faces the light, and nothing is between them.
    fn is_lit(&mut self, spot: &Spot, light: &Light) -> bool {
        let Some(ray) = towards_light(spot, light.place) else { return false };
        if self.following.casts_only {
            return true;
        }
        self.rays.shadow += 1;
        !self.tracer.any(&ray)
    }
}

/// What is seen where nothing is: brighter towards the horizon.
fn background(direction: DVec3) -> DVec3 {
    SKY[1].lerp(SKY[0], direction.y.abs().min(1.0))
}

/// Light as a screen shows it: cut off at 1, and the root of it (a gamma of 2).
fn shown(light: DVec3) -> DVec3 {
    let light = light.clamp(DVec3::ZERO, DVec3::ONE);
    DVec3::new(light.x.sqrt(), light.y.sqrt(), light.z.sqrt())
}

//! All that pieces are decided by.

use super::evidence::Saving;
use super::form::Output;
use super::usage::Wanted;
use crate::scene::look::Looks;

/// A mesh, its rays, and what is wanted of them, looked at and measured.
#[derive(Clone, Debug)]
pub struct Situation {
    /// What mesh and rays are like.
    pub looks: Looks,
    /// What is wanted of the answers.
    pub wanted: Wanted,
    /// How many tests there will be.
    pub crowd: Crowding,
    /// What the default variant does on all rays.
    pub pilot: Pilot,
    /// What it takes to find the triangles to test.
    pub paths: Option<Paths>,
    /// What preparing triangles is worth.
    pub preparing: Option<Preparing>,
}

/// How many tests there will be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crowding {
    /// Rays that were asked here.
    pub rays: u64,
    /// Rays of the use.
    pub in_use: u64,
    /// Triangles.
    pub triangles: u64,
    /// Tests that a ray takes through the hierarchy that the plan begins with.
    pub tests_per_ray: f64,
}

impl Crowding {
    /// Tests that a triangle takes part in.
    pub fn tests_per_triangle(&self) -> f64 {
        self.in_use as f64 * self.tests_per_ray / self.triangles as f64
    }
}

/// What the usual f32 test does on all rays, and what others would do better.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pilot {
    /// Rays.
    pub rays: u64,
    /// Rays that go through the surface where a watertight test finds it.
    pub leaks: u64,
    /// Answers that rounding does not explain, and that the same test has right in f64.
    pub too_coarse: u64,
}

/// What the ways to the triangles take; times are paired.
#[derive(Clone, Debug, PartialEq)]
pub struct Paths {
    /// The hierarchy, by name.
    pub hierarchy: String,
    /// Triangles that a ray is tested against in it.
    pub tests_in_hierarchy: f64,
    /// The list without the hierarchy; `None` where it is too long to be timed.
    pub list: Option<Saving>,
    /// The list without a box around it; `None` as for the list.
    pub without_box: Option<Saving>,
}

/// What preparing triangles is worth, in the use's number of tests.
#[derive(Clone, Debug, PartialEq)]
pub struct Preparing {
    /// The fastest form that prepares.
    pub with: String,
    /// Its preparing, ns a triangle.
    pub prepare_ns: f64,
    /// From how many tests a triangle on it is cheaper than the fastest form that prepares nothing;
    /// `None` where it never is.
    pub pays_from: Option<f64>,
    /// Time of testing without, over that of testing and preparing with.
    pub saving: Option<Saving>,
}

impl Situation {
    /// Whether the first hit that is found will do.
    pub fn any_hit(&self) -> bool {
        self.wanted.output == Output::Hit
    }
}

//! Which pictures are made, and with what.

use serde::Deserialize;

use crate::experiment::search::{leaves_of, scenes_exist};
use crate::experiment::workload::some;
use crate::render::{Following, Interpolation, Manner, Subsampling};
use crate::structure::{KINDS, kind};

/// Pictures of built-in scenes by several kernels.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PicturesWorkload {
    /// Columns and rows of a picture.
    #[serde(default = "size")]
    pub size: [u32; 2],
    /// Mirrors in a row that a ray is followed through.
    #[serde(default = "depth")]
    pub depth: u32,
    /// What tests rays against triangles.
    pub kernels: Vec<String>,
    /// Sets of pictures.
    pub sets: Vec<PictureSet>,
}

/// Scenes in one structure.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PictureSet {
    /// What the triangles are in.
    pub structure: String,
    /// Built-in scenes with their sizes.
    pub scenes: Vec<String>,
    /// Which pixels get a ray; every pixel where nothing is said.
    #[serde(default = "every_pixel")]
    pub sampling: Vec<Sampling>,
}

/// Which pixels get a ray.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sampling {
    /// Columns and rows of a cell; its corners get rays.
    pub grid: [u32; 2],
    /// A cell whose corners differ by less, of 1, is filled without rays.
    pub tolerance: f64,
}

fn size() -> [u32; 2] {
    [64, 48]
}

fn depth() -> u32 {
    2
}

fn every_pixel() -> Vec<Sampling> {
    vec![Sampling { grid: [1, 1], tolerance: 0.0 }]
}

/// Longest side of a picture, and widest cell.
const MOST_SIDE: u32 = 1024;
/// Most mirrors in a row.
const MOST_DEPTH: u32 = 16;

impl PicturesWorkload {
    pub(in crate::experiment) fn validate(&self) -> Result<(), String> {
        side("size", &self.size)?;
        if self.depth > MOST_DEPTH {
            return Err(format!(
                "workload.depth: {} is not allowed; allowed: 0 to {MOST_DEPTH}",
                self.depth
            ));
        }
        some("kernels", &self.kernels)?;
        leaves_of(&self.kernels)?;
        some("sets", &self.sets)?;
        self.sets.iter().try_for_each(PictureSet::validate)
    }

    /// Every picture: structure, scene, sampling.
    pub(super) fn pictures(&self) -> impl Iterator<Item = (&str, &str, Sampling)> {
        self.sets.iter().flat_map(|set| {
            set.scenes.iter().flat_map(move |scene| {
                let of =
                    move |sampling: &Sampling| (set.structure.as_str(), scene.as_str(), *sampling);
                set.sampling.iter().map(of)
            })
        })
    }
}

impl PictureSet {
    fn validate(&self) -> Result<(), String> {
        if kind(&self.structure).is_none() {
            let known = KINDS.map(|kind| kind.id).join(", ");
            return Err(format!(
                "workload.sets.structure: '{}' is not allowed; allowed: {known}",
                self.structure
            ));
        }
        some("sets.scenes", &self.scenes)?;
        scenes_exist("sets.scenes", &self.scenes)?;
        some("sets.sampling", &self.sampling)?;
        for sampling in &self.sampling {
            side("sets.sampling.grid", &sampling.grid)?;
            let tolerance = sampling.tolerance;
            if !(tolerance.is_finite() && tolerance >= 0.0) {
                return Err(format!(
                    "workload.sets.sampling.tolerance: {tolerance} is not allowed; allowed: 0 or more"
                ));
            }
        }
        Ok(())
    }
}

fn side(key: &str, sides: &[u32; 2]) -> Result<(), String> {
    match sides.iter().find(|side| !(1..=MOST_SIDE).contains(*side)) {
        Some(side) => {
            Err(format!("workload.{key}: {side} is not allowed; allowed: 1 to {MOST_SIDE}"))
        }
        None => Ok(()),
    }
}

impl Sampling {
    /// The word in the column `variation`.
    pub(super) fn word(self) -> String {
        match self.grid {
            [1, 1] => "every pixel".to_owned(),
            [x, y] => format!("grid {x} x {y} within {}", self.tolerance),
        }
    }

    pub(super) fn manner(self, depth: u32) -> Manner {
        Manner {
            following: Following { depth, casts_only: false },
            subsampling: Subsampling {
                grid: self.grid,
                tolerance: self.tolerance,
                interpolation: Interpolation::Bilinear,
            },
        }
    }
}

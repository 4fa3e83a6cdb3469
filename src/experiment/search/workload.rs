//! The workload `structures`: which triangles, which rays, what they are searched with.

use serde::Deserialize;

use super::subject::{self, Class, Subject};
use crate::experiment::workload::{in_range, some};
use crate::scene::built_in;

/// Rays through structures around the triangles of built-in scenes.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StructuresWorkload {
    /// Built-in scenes with their sizes, `soup:1000`. Sizes of one scene make a line in a figure.
    pub scenes: Vec<String>,
    /// `primary`, `random`.
    pub rays: Vec<RayKind>,
    /// Pixels along both sides of the picture that primary rays are of; random rays are as many. A
    /// multiple of 16.
    #[serde(default = "width")]
    pub width: u32,
    /// What tests every triangle gets so few rays that a pass has no more tests than these, but at least 32.
    #[serde(default = "list_tests")]
    pub list_tests: usize,
    /// Volumes around lists are left out beyond so many triangles: rays that miss a volume and rays that
    /// do not take too different times then for blocks of a few rays.
    #[serde(default = "bounded_most")]
    pub bounded_most: usize,
    /// What stands at the leaves, and in groups on the fast path.
    pub kernels: Vec<String>,
    /// Names of structures; `wide` is the fast path at every level, `peer-...` another crate's hierarchy.
    pub structures: Vec<String>,
    /// Bounding volumes whose gain is foretold.
    pub volumes: Option<VolumesWorkload>,
    /// What is counted without a clock.
    pub counted: Option<CountedWorkload>,
}

/// Where rays come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RayKind {
    /// From a camera, in runs of 16 neighbours, the runs in random order.
    Primary,
    /// Chords of the ball around the scene: they have nothing in common.
    Random,
}

impl RayKind {
    /// The word in the column `ray_class`.
    pub fn word(self) -> &'static str {
        match self {
            RayKind::Primary => "primary",
            RayKind::Random => "random",
        }
    }
}

/// Bounding volumes around a few triangles of the scene `soup`, and lines through a ball around them.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VolumesWorkload {
    /// Triangles inside.
    pub triangles: Vec<u32>,
    /// Radii of the ball, in that of the smallest: the larger, the fewer lines meet the volume.
    pub radii: Vec<f64>,
}

/// Counted without a clock, with the first kernel.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CountedWorkload {
    /// Built-in scenes.
    pub scenes: Vec<String>,
    /// Orders of insertion: as given, along the x axis, and at random, as many as make up this number.
    pub orders: usize,
    /// Lines that are counted.
    pub lines: usize,
}

fn width() -> u32 {
    32
}

fn list_tests() -> usize {
    1_000_000
}

fn bounded_most() -> usize {
    1000
}

/// Fewest rays of what tests every triangle.
pub(super) const LEAST_RAYS: usize = 32;
/// Neighbouring pixels whose rays follow each other.
pub(super) const RUN: usize = 16;
/// Widest picture: a million rays.
const MOST_WIDTH: u32 = 1024;
/// Largest radius: beyond it hardly any line meets the volume.
const MOST_RADIUS: f64 = 16.0;
/// Most triangles that a volume is put around here.
const MOST_BOUNDED: u32 = 1 << 16;

impl StructuresWorkload {
    pub(in crate::experiment) fn validate(&self) -> Result<(), String> {
        some("scenes", &self.scenes)?;
        some("rays", &self.rays)?;
        some("kernels", &self.kernels)?;
        some("structures", &self.structures)?;
        scenes_exist("scenes", &self.scenes)?;
        if !(RUN as u32..=MOST_WIDTH).contains(&self.width)
            || !self.width.is_multiple_of(RUN as u32)
        {
            return Err(format!(
                "workload.width: {} is not allowed; allowed: multiples of {RUN} from {RUN} to \
                 {MOST_WIDTH}",
                self.width
            ));
        }
        in_range("list_tests", self.list_tests, 1)?;
        in_range("bounded_most", self.bounded_most, 0)?;
        subject::leaves_of(&self.kernels)?;
        self.subjects()?;
        self.volumes.as_ref().map_or(Ok(()), VolumesWorkload::validate)?;
        self.counted.as_ref().map_or(Ok(()), CountedWorkload::validate)
    }

    /// Everything that searches, in the order of `structures`, each with every kernel.
    ///
    /// # Errors
    /// A name that is none, and what is allowed.
    pub(in crate::experiment) fn subjects(&self) -> Result<Vec<Subject>, String> {
        let mut all = Vec::new();
        for name in &self.structures {
            all.extend(subject::named(name, &self.kernels)?);
        }
        Ok(all)
    }

    /// Whether a search is measured on so many triangles.
    pub(super) fn includes(&self, subject: &Subject, triangles: usize) -> bool {
        let is_bounded = subject.class() == Class::Linear && subject.name() != "list";
        !is_bounded || triangles <= self.bounded_most
    }

    /// Rays of each kind.
    pub(super) fn count(&self) -> usize {
        self.width as usize * self.width as usize
    }

    /// Rays of what tests every one of so many triangles.
    pub(super) fn list_count(&self, triangles: usize) -> usize {
        (self.list_tests / triangles.max(1)).clamp(LEAST_RAYS.min(self.count()), self.count())
    }
}

impl VolumesWorkload {
    fn validate(&self) -> Result<(), String> {
        some("volumes.triangles", &self.triangles)?;
        some("volumes.radii", &self.radii)?;
        if let Some(count) = self.triangles.iter().find(|n| !(1..=MOST_BOUNDED).contains(*n)) {
            return Err(format!(
                "workload.volumes.triangles: {count} is not allowed; allowed: 1 to {MOST_BOUNDED}"
            ));
        }
        match self.radii.iter().find(|radius| !(1.0..=MOST_RADIUS).contains(*radius)) {
            Some(radius) => Err(format!(
                "workload.volumes.radii: {radius} is not allowed; allowed: 1 to {MOST_RADIUS}"
            )),
            None => Ok(()),
        }
    }
}

impl CountedWorkload {
    fn validate(&self) -> Result<(), String> {
        some("counted.scenes", &self.scenes)?;
        scenes_exist("counted.scenes", &self.scenes)?;
        in_range("counted.orders", self.orders, 2)?;
        in_range("counted.lines", self.lines, 1)
    }
}

/// Refuses what is no built-in scene: a file would be another on another machine.
pub(in crate::experiment) fn scenes_exist(key: &str, scenes: &[String]) -> Result<(), String> {
    for scene in scenes {
        let refused = |why: String| Err(format!("workload.{key}: {why}"));
        let (name, size) = scene.split_once(':').unwrap_or((scene, ""));
        let Some(known) = built_in::ALL.iter().find(|one| one.name == name) else {
            let names: Vec<&str> = built_in::ALL.iter().map(|one| one.name).collect();
            return refused(format!(
                "'{scene}' is not allowed; allowed: {}, each with a size behind a colon if wanted",
                names.join(", ")
            ));
        };
        let [least, most] = known.sizes;
        let is_size = |size: &str| size.parse().is_ok_and(|size| (least..=most).contains(&size));
        if scene.contains(':') && !is_size(size) {
            return refused(format!(
                "'{scene}' is not allowed; allowed behind the colon: {least} to {most} ({})",
                known.size
            ));
        }
    }
    Ok(())
}

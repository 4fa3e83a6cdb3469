//! Thesis B's pairs at an exact hit density, with nothing left for rounding to decide.

use super::error::counted;
use super::random::Pcg;
use super::settled::Standing;
use super::{Generator, Ray, Triangle, WorkloadError, hash, thesis};
use crate::oracle::{Query, classify};
use glam::Vec3;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, Ordering};

/// Most pairs of one set: 1.6 GB of rays and triangles.
const MOST_PAIRS: u64 = 1 << 24;
/// Rounding moves no kernel's quantity by more than this many pessimistic condition numbers.
const ALLOWANCE: f64 = 64.0;
/// Stream of the generator that orders the pairs.
const ORDER: u64 = 1;

/// Which part of the line through origin and end counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum QueryKind {
    /// All of it: t from -MAX to MAX. What thesis B calls a hit.
    #[default]
    Line,
    /// From the origin on: t from 0 to MAX.
    Ray,
    /// From the origin to the end: t from 0 to their distance in f32.
    Segment,
}

impl QueryKind {
    /// The word for it in configs and columns.
    pub fn word(self) -> &'static str {
        match self {
            QueryKind::Line => "line",
            QueryKind::Ray => "ray",
            QueryKind::Segment => "segment",
        }
    }

    /// The ray from `origin` towards `end`, its direction normalised in f32 (0 where they agree).
    pub(super) fn ray(self, origin: Vec3, end: Vec3) -> Ray {
        let difference = end - origin;
        let (t_min, t_max) = match self {
            QueryKind::Line => (-f32::MAX, f32::MAX),
            QueryKind::Ray => (0.0, f32::MAX),
            QueryKind::Segment => (0.0, thesis::length(difference)),
        };
        Ray { origin, direction: thesis::normalised(difference), end, t_min, t_max }
    }
}

/// Which side of the triangles the rays see.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Winding {
    /// As drawn: either, about evenly.
    #[default]
    Natural,
    /// The front, where a, b, c run counter-clockwise: b and c are swapped where
    /// `direction . ((b - a) x (c - a)) > 0`.
    Facing,
}

impl Winding {
    /// The word for it in configs and columns.
    pub fn word(self) -> &'static str {
        match self {
            Winding::Natural => "natural",
            Winding::Facing => "facing",
        }
    }
}

/// What to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairSpec {
    /// Number of pairs, 1 to 2^24.
    pub count: usize,
    /// Share of hits, 0 to 1; times `count` it is rounded half up.
    pub density: f64,
    /// What counts as a hit.
    pub query: QueryKind,
    /// Which side the rays see.
    pub winding: Winding,
    /// What draws the coordinates.
    pub generator: Generator,
    /// Where it starts.
    pub seed: u64,
}

impl PairSpec {
    /// The thesis's pairs: line query, winding as drawn, the project's generator.
    pub fn new(count: usize, density: f64, seed: u64) -> Self {
        PairSpec {
            count,
            density,
            query: QueryKind::default(),
            winding: Winding::default(),
            generator: Generator::default(),
            seed,
        }
    }

    /// Number of hits that the density asks for.
    ///
    /// # Errors
    /// For a count or a density that is not allowed.
    pub fn hits(&self) -> Result<usize, WorkloadError> {
        quota("number of pairs", self.count, self.density)
    }

    /// Refuses what can be seen to be wrong before anything is drawn.
    ///
    /// # Errors
    /// For a count, a density or a seed that is not allowed.
    pub fn check(&self) -> Result<(), WorkloadError> {
        self.hits()?;
        self.generator.start(self.seed).map(drop)
    }
}

/// Number of `count` things that a density asks for, rounded half up.
///
/// # Errors
/// For a count or a density that is not allowed.
pub(super) fn quota(
    what: &'static str,
    count: usize,
    density: f64,
) -> Result<usize, WorkloadError> {
    counted(what, count, 1, MOST_PAIRS)?;
    if !(0.0..=1.0).contains(&density) {
        return Err(WorkloadError::Density { value: density });
    }
    // At most 2^24: the product's rounding cannot lift it past the count.
    Ok((density * count as f64 + 0.5).floor() as usize)
}

/// A set of pairs: ray i belongs to triangle i.
#[derive(Clone, Debug)]
pub struct Pairs {
    /// One a pair.
    pub rays: Vec<Ray>,
    /// One a pair.
    pub triangles: Vec<Triangle>,
    /// Number of pairs that hit. Any run of n consecutive pairs holds n times the density of them,
    /// rounded down or up.
    pub hits: usize,
    /// What was asked for.
    pub spec: PairSpec,
    /// [`hash::workload`] of the rays and triangles.
    pub hash: u64,
    /// Pairs drawn for the set.
    pub attempts: u64,
    /// Pairs drawn again since rounding could have decided them.
    pub redrawn: u64,
}

impl Pairs {
    /// Draws a set: pairs as they fall go to the hits or to the misses while there is room, unless
    /// rounding could decide them; each kind is then shuffled and the two are interleaved evenly.
    ///
    /// # Errors
    /// For a specification that is not allowed, or (which a sound generator will not see) a quota
    /// that 10 000 + 64 x count attempts did not fill.
    pub fn draw(spec: PairSpec) -> Result<Self, WorkloadError> {
        Self::draw_unless(spec, &AtomicBool::new(false))
    }

    /// The same, unless it is cancelled meanwhile: sets may be of millions.
    ///
    /// # Errors
    /// As [`Pairs::draw`]; [`WorkloadError::Cancelled`] once `cancel` is set.
    pub fn draw_unless(spec: PairSpec, cancel: &AtomicBool) -> Result<Self, WorkloadError> {
        let hits_wanted = spec.hits()?;
        let mut bins = Bins::draw(&spec, hits_wanted, cancel)?;
        let mut order = Pcg::stream(spec.seed, ORDER);
        order.shuffle(&mut bins.hits);
        order.shuffle(&mut bins.misses);
        let (rays, triangles): (Vec<Ray>, Vec<Triangle>) =
            interleaved(bins.hits, bins.misses).unzip();
        let hash = hash::workload(&rays, &triangles);
        let (attempts, redrawn) = (bins.attempts, bins.redrawn);
        Ok(Pairs { rays, triangles, hits: hits_wanted, spec, hash, attempts, redrawn })
    }

    /// Share of the pairs that hit.
    pub fn density(&self) -> f64 {
        self.hits as f64 / self.rays.len() as f64
    }
}

type Pair = (Ray, Triangle);

#[derive(Default)]
struct Bins {
    hits: Vec<Pair>,
    misses: Vec<Pair>,
    attempts: u64,
    redrawn: u64,
}

impl Bins {
    fn draw(
        spec: &PairSpec,
        hits_wanted: usize,
        cancel: &AtomicBool,
    ) -> Result<Self, WorkloadError> {
        let misses_wanted = spec.count - hits_wanted;
        let most_attempts = 10_000 + 64 * spec.count as u64;
        let mut source = spec.generator.start(spec.seed)?;
        let mut bins = Bins::default();
        while bins.hits.len() < hits_wanted || bins.misses.len() < misses_wanted {
            if bins.attempts == most_attempts {
                return Err(bins.shortfall(hits_wanted, misses_wanted));
            }
            if cancel.load(Ordering::Relaxed) {
                return Err(WorkloadError::Cancelled);
            }
            bins.attempts += 1;
            let (ray, triangle) = thesis::draw(&mut source, spec.query);
            let hit = classify(&Query::of(&ray, &triangle)).is_hit();
            let (bin, wanted) =
                if hit { (&mut bins.hits, hits_wanted) } else { (&mut bins.misses, misses_wanted) };
            if bin.len() == wanted {
                continue;
            }
            let standing = Standing::of(&ray, &triangle, ALLOWANCE);
            if standing.is_settled() {
                bin.push((ray, wound(spec.winding, &standing, triangle)));
            } else {
                bins.redrawn += 1;
            }
        }
        Ok(bins)
    }

    fn shortfall(&self, hits_wanted: usize, misses_wanted: usize) -> WorkloadError {
        WorkloadError::Quota {
            attempts: self.attempts,
            hits: self.hits.len(),
            hits_wanted,
            misses: self.misses.len(),
            misses_wanted,
        }
    }
}

/// The triangle as the winding wants it.
fn wound(winding: Winding, standing: &Standing, triangle: Triangle) -> Triangle {
    let Triangle { a, b, c } = triangle;
    match winding {
        Winding::Facing if !standing.faces() => Triangle { a, b: c, c: b },
        _ => triangle,
    }
}

/// Spreads hits among misses as evenly as whole pairs allow (Bresenham's line): after i pairs,
/// `floor(i * hits / count)` of them have hit.
pub(super) fn interleaved(hits: Vec<Pair>, misses: Vec<Pair>) -> impl Iterator<Item = Pair> {
    let (many, count) = (hits.len() as u64, (hits.len() + misses.len()) as u64);
    let (mut hits, mut misses) = (hits.into_iter(), misses.into_iter());
    (0..count).filter_map(move |i| {
        let next_hits = (i + 1) * many / count > i * many / count;
        if next_hits { hits.next() } else { misses.next() }
    })
}

#[cfg(test)]
#[path = "pairs_tests.rs"]
mod tests;

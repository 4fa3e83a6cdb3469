//! Triangles and rays, with the answers that searches are held against.

use std::cell::OnceCell;

use super::workload::{RUN, RayKind};
use crate::accuracy::{Judgement, Reported, judge_nearest};
use crate::job::Answer;
use crate::oracle::Exact;
use crate::render::Exactly;
use crate::scene::built_in;
use crate::scene::mesh::Mesh;
use crate::scene::rays::{Asked, Plan, Rays};
use crate::structure::{Excuse, Hit, List, Structure, excuse, kind};
use crate::workload::{Pcg, Ray, Triangle, WorkloadError, hash};

/// A scene's triangles and rays of one kind.
pub struct Set<'a> {
    /// In the scene's order.
    pub triangles: &'a [Triangle],
    /// In the order in which they are searched for.
    pub rays: Vec<Ray>,
    /// Hash of both.
    pub hash: u64,
    structure: &'a dyn Structure,
    exact: OnceCell<Vec<Option<(usize, Exact)>>>,
    kept: OnceCell<(Vec<Answer>, Judgement)>,
}

/// How answers differ from the list's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Differences {
    /// All of them.
    pub all: u64,
    /// Those that a structure is allowed.
    pub excused: u64,
    /// The first ray of those that it is not.
    pub wrong: Option<usize>,
}

/// The generator's stream for the order of runs.
const RUNS: u64 = 0x5255_4e53;

/// The mesh of a scene whose name was checked.
pub fn opened(scene: &str) -> Result<Mesh, WorkloadError> {
    let mesh = built_in::named(scene);
    let mesh = mesh.ok_or_else(|| WorkloadError::Scene(format!("there is no scene '{scene}'")))?;
    mesh.map_err(|error| WorkloadError::Scene(error.to_string()))
}

/// A scene without its size.
pub fn scene_name(scene: &str) -> &str {
    scene.split_once(':').map_or(scene, |(name, _)| name)
}

/// The structure that answers where the list takes too long.
pub fn standing_in(triangles: &[Triangle]) -> Box<dyn Structure> {
    match kind("surface") {
        Some(kind) => (kind.build)(triangles),
        None => Box::new(List::new(triangles.len() as u32)),
    }
}

/// Rays of a kind for a scene, as many as pixels.
///
/// # Errors
/// None that is known: they are drawn, not read.
pub fn rays(mesh: &Mesh, kind: RayKind, width: u32, seed: u64) -> Result<Vec<Ray>, WorkloadError> {
    if kind == RayKind::Random {
        return chords(mesh, width as usize * width as usize, seed);
    }
    let plan = Plan { width, height: width, per_point: 1, seed };
    let rays = drawn(&Asked::Primary, mesh, plan)?;
    // Blocks of rows would be sky, then ground: runs in random order make one block like another, and
    // neighbours still follow each other.
    let mut runs: Vec<&[Ray]> = rays.chunks(RUN).collect();
    Pcg::stream(seed, RUNS).shuffle(&mut runs);
    Ok(runs.concat())
}

/// So many chords of the ball around a scene.
///
/// # Errors
/// As [`rays`].
pub fn chords(mesh: &Mesh, count: usize, seed: u64) -> Result<Vec<Ray>, WorkloadError> {
    let width = u32::try_from(count).unwrap_or(u32::MAX);
    drawn(&Asked::Random, mesh, Plan { width, height: 1, per_point: 1, seed })
}

fn drawn(asked: &Asked, mesh: &Mesh, plan: Plan) -> Result<Vec<Ray>, WorkloadError> {
    // Neither kind starts at a hit.
    let drawn = Rays::of(asked, mesh, plan, |_| None);
    Ok(drawn.map_err(|error| WorkloadError::Scene(error.to_string()))?.rays)
}

/// So many of the rays, evenly from among them.
pub fn thinned(rays: &[Ray], count: usize) -> Vec<Ray> {
    (0..count).map(|place| rays[place * rays.len() / count]).collect()
}

impl<'a> Set<'a> {
    /// `structure` holds the triangles: exact answers are looked for in it.
    pub fn new(triangles: &'a [Triangle], rays: Vec<Ray>, structure: &'a dyn Structure) -> Self {
        let hash = hash::workload(&rays, triangles);
        Set { triangles, rays, hash, structure, exact: OnceCell::new(), kept: OnceCell::new() }
    }

    /// The same triangles with some of the rays.
    pub fn thinned(&self, count: usize) -> Set<'a> {
        Set::new(self.triangles, thinned(&self.rays, count), self.structure)
    }

    fn exact(&self) -> &[Option<(usize, Exact)>] {
        self.exact.get_or_init(|| {
            let mut exactly = Exactly::new(self.triangles, self.structure, false);
            let one = |ray: &Ray| {
                exactly.nearest(ray).map(|(triangle, exact)| (triangle as usize, exact))
            };
            self.rays.iter().map(one).collect()
        })
    }

    /// Holds answers, of f32 numbers, against the exact ones; `uv` says whether they tell u and v. The
    /// judgement of the first answers is kept: most searches give the same, bit for bit.
    pub fn judge(&self, answers: &[Answer], uv: bool) -> Judgement {
        let reported =
            Reported { unit_roundoff: 0.5f64.powi(24), t: true, uv, surface: false, culls: false };
        let both = (self.rays.as_slice(), self.triangles);
        let judge = |answers: &[Answer]| judge_nearest(answers, self.exact(), both, reported);
        if !uv {
            return judge(answers);
        }
        let (kept, judgement) = self.kept.get_or_init(|| (answers.to_vec(), judge(answers)));
        if kept == answers { judgement.clone() } else { judge(answers) }
    }

    /// How answers differ from others of the same kernel, ray by ray.
    pub fn differences(&self, answers: &[Answer], wanted: &[Answer]) -> Differences {
        let mut differences = Differences::default();
        for (place, (answer, wanted)) in answers.iter().zip(wanted).enumerate() {
            if answer == wanted {
                continue;
            }
            differences.all += 1;
            // Each has tested what it found, so the other one has left it out.
            let lost = match (hit(answer), hit(wanted)) {
                (Some(own), Some(other)) if own.precedes(&other) => Some(own),
                (own, other) => other.or(own),
            };
            let ray = &self.rays[place];
            let excuse: Option<Excuse> =
                lost.and_then(|hit| excuse(ray, self.triangles, &hit, false));
            if excuse.is_some() {
                differences.excused += 1;
            } else {
                differences.wrong.get_or_insert(place);
            }
        }
        differences
    }
}

/// An answer that was of f32 numbers.
fn hit(answer: &Answer) -> Option<Hit> {
    let triangle = u32::try_from(answer.triangle?).ok()?;
    Some(Hit { triangle, t: answer.t as f32, u: answer.u as f32, v: answer.v as f32 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::built_in::named;

    fn mesh() -> Mesh {
        named("soup:40").and_then(Result::ok).expect("a built-in scene")
    }

    #[test]
    fn primary_rays_are_those_of_the_picture_in_runs() {
        let drawn = rays(&mesh(), RayKind::Primary, 32, 1).expect("they are drawn");
        let plan = Plan { width: 32, height: 32, per_point: 1, seed: 1 };
        let picture = Rays::of(&Asked::Primary, &mesh(), plan, |_| None).expect("drawn").rays;
        assert_ne!(drawn, picture);
        for run in drawn.chunks(RUN) {
            let place = picture.iter().position(|ray| *ray == run[0]).expect("a ray of it");
            assert!(place.is_multiple_of(RUN) && picture[place..][..RUN] == *run);
        }
    }

    #[test]
    fn an_answer_that_is_lost_without_an_excuse_is_wrong() {
        let triangles = mesh().list();
        let list = List::new(triangles.len() as u32);
        let drawn = rays(&mesh(), RayKind::Random, 32, 1).expect("they are drawn");
        let set = Set::new(&triangles, drawn, &list);
        let answer = |exact: &Option<(usize, Exact)>| {
            exact.as_ref().map_or_else(Answer::default, |(triangle, exact)| Answer {
                triangle: Some(*triangle),
                t: exact.t as f32 as f64,
                u: exact.u as f32 as f64,
                v: exact.v as f32 as f64,
                ..Answer::default()
            })
        };
        let wanted: Vec<Answer> = set.exact().iter().map(answer).collect();
        assert_eq!(set.differences(&wanted, &wanted), Differences::default());
        assert_eq!(set.judge(&wanted, true).wrong, None);
        let lost = wanted.iter().position(|one| one.triangle.is_some()).expect("a ray hits");
        let mut found = wanted.clone();
        found[lost] = Answer::default();
        let differences = Differences { all: 1, excused: 0, wrong: Some(lost) };
        assert_eq!(set.differences(&found, &wanted), differences);
        assert!(set.judge(&found, true).wrong.is_some());
        // Too near by more than the slack: the structure may leave it out.
        let mut near = wanted.clone();
        near[lost].t *= 0.9;
        let differences = Differences { all: 1, excused: 1, wrong: None };
        assert_eq!(set.differences(&wanted, &near), differences);
    }
}

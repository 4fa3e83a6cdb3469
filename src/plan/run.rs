//! Looks, measures, settles, proves.

use super::contest::{default_variant, forms_at_most};
use super::nearby::Nearby;
use super::paths::{self, Walked};
use super::pilot::{self, Asking, Way};
use super::proof::Exactly;
use super::rays::{self, Asking as Drawing, Crowd};
use super::sample::{self, Arrangement};
use super::settle::Settled;
use super::situation::{Crowding, Pilot, Situation};
use super::stages::{self, Stages};
use super::{Report, Wanted};
use crate::check::read::ReadError;
use crate::experiment::{Bench, Facts, Scene, Trouble};
use crate::registry::Variant;
use crate::scene::look::Looks;
use crate::scene::mesh::Mesh;
use crate::table::Row;
use crate::workload::{QueryKind, Ray, Triangle, hash};

/// What is planned for: made without a clock.
pub struct Task<'a> {
    mesh: &'a Mesh,
    wanted: Wanted,
    triangles: &'a [Triangle],
    nearby: Nearby<'a>,
    crowd: Crowd,
    looks: Looks,
    seed: u64,
}

/// What came of it.
pub struct Outcome {
    /// Everything that was timed.
    pub rows: Vec<Row>,
    /// The plan with its proof; `None` if it was interrupted before.
    pub found: Option<Found>,
}

/// A plan with what stands behind it.
pub struct Found {
    /// As programs read it.
    pub report: Report,
    /// Triangles of the mesh.
    pub triangles: u64,
    /// The way to the triangles, as structures are named.
    pub structure: String,
    /// The id of the variant that it was held against.
    pub default: String,
    /// What came of the choice.
    pub settled: Settled,
}

impl<'a> Task<'a> {
    /// Draws the rays and looks at everything; `triangles` are those of the mesh.
    ///
    /// # Errors
    /// Of a file of rays: what is wrong, where, and what is allowed. Also where no ray comes of it.
    pub fn new(
        mesh: &'a Mesh,
        triangles: &'a [Triangle],
        wanted: Wanted,
        drawing: Drawing,
    ) -> Result<Self, ReadError> {
        let mut nearby = Nearby::new(triangles);
        let mut first = |ray: &Ray| nearby.nearest(ray).map(|(index, _)| index as u32);
        let crowd = rays::draw(&wanted, mesh, drawing, &mut first)?;
        let looks = Looks::of(mesh).with_rays(mesh, &crowd.rays, &mut first);
        Ok(Task { mesh, wanted, triangles, nearby, crowd, looks, seed: drawing.seed })
    }

    /// Number of rays.
    pub fn rays(&self) -> usize {
        self.crowd.rays.len()
    }

    /// What mesh and rays are like.
    pub fn looks(&self) -> &Looks {
        &self.looks
    }

    /// About how many blocks will be timed in groups of so many rounds, for a progress bar: no fewer than
    /// are.
    pub fn blocks(&self, rounds: usize) -> usize {
        stages::blocks(rounds, forms_at_most(self.wanted.output))
    }

    /// Measures, and settles on a plan.
    ///
    /// # Errors
    /// A group that cannot be measured.
    pub fn run(self, bench: &mut Bench<'_>) -> Result<Outcome, Trouble> {
        bench.calls = false;
        let mut rows = Vec::new();
        let found = self.plan(bench, &mut rows)?;
        Ok(Outcome { rows, found })
    }

    fn plan(
        mut self,
        bench: &mut Bench<'_>,
        rows: &mut Vec<Row>,
    ) -> Result<Option<Found>, Trouble> {
        let name = format!("scene {} {}", self.mesh.name, self.wanted.source.word());
        let both = (self.crowd.rays.as_slice(), self.triangles);
        let mut walked =
            paths::time(&name, both, self.wanted.output == super::Output::Hit, self.seed, bench)?;
        rows.append(&mut walked.rows);
        let nearest = self.crowd.rays.iter().map(|ray| self.nearby.nearest(ray)).collect();
        let exactly = Exactly { rays: &self.crowd.rays, triangles: self.triangles, nearest };
        let output = self.wanted.output;
        let (nearby, way) = (&mut self.nearby, Way::Nearby);
        let mut asking = Asking { exactly: &exactly, nearby, way, output };
        let pilot = pilot::fly(&mut asking);
        let (tight, fine) = (pilot.leaks > 0, pilot.too_coarse > 0);
        let Some(default) = default_variant(output, tight, fine) else { return Ok(None) };
        let situation =
            situation(self.looks, self.wanted, &self.crowd, pilot, walked, both.1.len());
        let flat = asking.goes_through_all(&situation);
        let sample = sampled(&mut asking, flat, default, self.seed);
        let scene = scene(name, sample, self.seed);
        if flat {
            asking.way = Way::List;
        }
        let mut stages = Stages { situation, default, scene: &scene, bench, rows };
        let settled = stages.settled(&mut asking)?;
        Ok(settled.map(|settled| found(self.mesh, &stages.situation, default, settled)))
    }
}

/// All that is told.
fn found(mesh: &Mesh, situation: &Situation, default: &Variant, settled: Settled) -> Found {
    let wanted = &situation.wanted;
    let report = Report {
        mesh: mesh.name.clone(),
        rays: wanted.source.word().to_owned(),
        needs: wanted.output.word(),
        plan: settled.plan.clone(),
        answers: settled.answers,
    };
    let goes = |piece: &str| settled.plan.left_out.iter().any(|one| one.piece == piece);
    let structure = match &situation.paths {
        _ if goes("hierarchy") && goes("bounding volume") => paths::LIST,
        _ if goes("hierarchy") => paths::BOXED,
        Some(paths) => &paths.hierarchy,
        None => paths::HIERARCHIES[0],
    };
    Found {
        report,
        triangles: situation.crowd.triangles,
        structure: structure.to_owned(),
        default: default.id(),
        settled,
    }
}

/// Everything that pieces are decided by, but for what preparing is worth.
fn situation(
    looks: Looks,
    wanted: Wanted,
    crowd: &Crowd,
    pilot: Pilot,
    walked: Walked,
    triangles: usize,
) -> Situation {
    let crowd = Crowding {
        rays: crowd.rays.len() as u64,
        in_use: crowd.in_use,
        triangles: triangles as u64,
        tests_per_ray: walked.tests_per_ray,
    };
    Situation { looks, wanted, crowd, pilot, paths: walked.paths, preparing: None }
}

/// What forms are timed on: without a hierarchy rays against all triangles, else the tests of a search.
fn sampled(
    asking: &mut Asking<'_, '_>,
    flat: bool,
    default: &Variant,
    seed: u64,
) -> sample::Sample {
    let arrangement = if flat { Arrangement::Nearest } else { Arrangement::Pairs };
    let exactly = asking.exactly;
    let suits = &mut |ray: &Ray, triangles: &[Triangle]| pilot::is_plain(default, ray, triangles);
    sample::draw(arrangement, (exactly.rays, &exactly.nearest), asking.nearby, seed, suits)
}

/// The sample as experiments know it.
fn scene(workload: String, sample: sample::Sample, seed: u64) -> Scene {
    let facts = Facts {
        workload,
        query: QueryKind::Ray.word(),
        generator: "pcg",
        hash: hash::workload(&sample.rays, &sample.triangles),
        seed,
        ..Facts::default()
    };
    match sample.arrangement {
        Arrangement::Nearest => Scene::given(facts, sample.rays, sample.triangles),
        Arrangement::Pairs => Scene::given_pairs(facts, sample.rays, sample.triangles),
    }
}

//! Looks, measures, settles, proves.

use super::contest::{self, Timed};
use super::nearby::Nearby;
use super::pieces::PIECES;
use super::pilot::{self, Asking, Way};
use super::prepare::{self, Stores};
use super::proof::{Answers, Exactly};
use super::rays::{self, Asking as Drawing, Crowd};
use super::sample::{self, Arrangement};
use super::settle::{Finals, Looked, Settled, settle, waste};
use super::situation::{Crowding, Situation};
use super::{Form, Piece, Report, Saving, Wanted, paths};
use crate::check::read::ReadError;
use crate::experiment::{Bench, Facts, Scene, Trouble};
use crate::registry::{Variant, find};
use crate::scene::look::Looks;
use crate::scene::mesh::Mesh;
use crate::table::Row;
use crate::workload::{QueryKind, Ray, Triangle, hash};
use std::sync::atomic::Ordering;

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

    /// About how many blocks will be timed in groups of so many rounds, for a progress bar.
    pub fn blocks(rounds: usize) -> usize {
        GROUPS
            * rounds
            * (crate::experiment::cells::MOST_SUBJECTS + crate::experiment::cells::CONTROLS)
    }

    /// Measures, and settles on a plan.
    ///
    /// # Errors
    /// A group that cannot be measured.
    pub fn run(mut self, bench: &mut Bench<'_>) -> Result<Outcome, Trouble> {
        bench.calls = false;
        let mut rows = Vec::new();
        let found = self.plan(bench, &mut rows)?;
        Ok(Outcome { rows, found })
    }

    fn plan(
        &mut self,
        bench: &mut Bench<'_>,
        rows: &mut Vec<Row>,
    ) -> Result<Option<Found>, Trouble> {
        let name = format!("scene {} {}", self.mesh.name, self.wanted.source.word());
        let both = (self.crowd.rays.as_slice(), self.triangles);
        let any = self.wanted.output == super::Output::Hit;
        let walked = paths::time(&name, both, any, self.seed, bench)?;
        rows.extend(walked.rows);
        let nearest = self.crowd.rays.iter().map(|ray| self.nearby.nearest(ray)).collect();
        let exactly = Exactly { rays: &self.crowd.rays, triangles: self.triangles, nearest };
        let output = self.wanted.output;
        let (nearby, way) = (&mut self.nearby, Way::Nearby);
        let mut asking = Asking { exactly: &exactly, nearby, way, output };
        let pilot = pilot::fly(&mut asking);
        let mut situation = Situation {
            looks: self.looks.clone(),
            wanted: self.wanted.clone(),
            crowd: Crowding {
                rays: self.crowd.rays.len() as u64,
                in_use: self.crowd.in_use,
                triangles: self.triangles.len() as u64,
                tests_per_ray: walked.tests_per_ray,
            },
            pilot,
            paths: walked.paths,
            preparing: None,
        };
        let tight = pilot.leaks > 0;
        let Some(default) = contest::default_variant(output, tight, pilot.too_coarse > 0) else {
            return Ok(None);
        };
        let flat = asking.goes_through_all(&situation);
        let sample = sample::draw(
            if flat { Arrangement::Nearest } else { Arrangement::Pairs },
            (&self.crowd.rays, &exactly.nearest),
            asking.nearby,
            self.seed,
            &mut |ray, triangles| pilot::is_plain(default, ray, triangles),
        );
        let facts = Facts {
            workload: name,
            query: QueryKind::Ray.word(),
            generator: "pcg",
            hash: hash::workload(&sample.rays, &sample.triangles),
            seed: self.seed,
            ..Facts::default()
        };
        let scene = match sample.arrangement {
            Arrangement::Nearest => Scene::given(facts, sample.rays, sample.triangles),
            Arrangement::Pairs => Scene::given_pairs(facts, sample.rays, sample.triangles),
        };
        let Some(contested) = contested(&mut situation, default, &scene, bench, rows)? else {
            return Ok(None);
        };
        if flat {
            asking.way = Way::List;
        }
        let settled = settled(&situation, &contested, default, &mut asking);
        let report = Report {
            mesh: self.mesh.name.clone(),
            rays: self.wanted.source.word().to_owned(),
            needs: output.word(),
            plan: settled.plan.clone(),
            answers: settled.answers,
        };
        Ok(Some(Found { report, default: default.id(), settled }))
    }
}

/// Groups that are timed, more or less: paths and preparing; pairs, heats and finals in four times the
/// rounds, since they are reshuffled.
const GROUPS: usize = 2 + 4 * 6;

/// Triangles that are prepared: corners and records fit the first cache.
const PREPARED: usize = 256;

/// What the contests on the sample gave.
struct Contested {
    pairs: Timed,
    finals: Finals,
}

/// Pairs, heats, preparing, finals. `None` when interrupted, or where the default cannot be timed.
fn contested(
    situation: &mut Situation,
    default: &'static Variant,
    scene: &Scene,
    bench: &mut Bench<'_>,
    rows: &mut Vec<Row>,
) -> Result<Option<Contested>, Trouble> {
    let looks: Vec<bool> = PIECES.iter().map(|p| (p.look)(situation).is_spare()).collect();
    let pairs = contest::time(&contest::paired(&|place| looks[place]), default, scene, bench)?;
    rows.extend(pairs.rows.iter().cloned());
    let needed = |form: &Form| {
        let mut pieces = PIECES.iter().zip(&looks);
        pieces.all(|(piece, is_spare)| *is_spare || !piece.is_left_out_by(form))
    };
    let mut forms =
        contest::candidates(situation.wanted.output, situation.pilot.too_coarse > 0, &needed);
    if !forms.iter().any(|form| std::ptr::eq(*form, default)) {
        forms.push(default);
    }
    forms.sort_by_key(|variant| variant.axes.kernel);
    let heats = contest::time(&forms, default, scene, bench)?;
    rows.extend(heats.rows.iter().cloned());
    let seed = scene.facts.seed;
    let some = &scene.triangles[..scene.triangles.len().min(PREPARED)];
    let stores = prepare::time(&forms, some, seed, bench)?;
    let tests = situation.crowd.tests_per_triangle();
    let share = |variant: &Variant| share(&stores, variant, tests);
    situation.preparing = prepare::worth(&heats, &forms, &stores, tests);
    let looked = looked(situation, contest::savings(&pairs));
    let waste = |form: &Form| waste(&looked, form);
    let finalists = contest::finalists(&heats, &forms, default, &share, &waste);
    let timed = contest::time(&finalists, default, scene, bench)?;
    rows.extend(timed.rows.iter().cloned());
    if bench.cancel.load(Ordering::Relaxed) {
        return Ok(None);
    }
    situation.preparing = prepare::worth(&timed, &finalists, &stores, tests);
    let finals = contest::finals(&timed, &finalists, default, &share);
    Ok(finals.map(|finals| Contested { pairs, finals }))
}

/// What is known of each piece.
fn looked(situation: &Situation, savings: Vec<Option<Saving>>) -> Vec<Looked<'static>> {
    let pieces = PIECES.iter().zip(savings);
    let one = |(piece, saving): (&'static Piece, _)| Looked {
        piece,
        look: (piece.look)(situation),
        saving,
        back: None,
    };
    pieces.map(one).collect()
}

/// What preparing adds to a test, ns. What could not be timed is never chosen.
fn share(stores: &Stores, variant: &Variant, tests_per_triangle: f64) -> f64 {
    stores.of(variant).map_or(f64::INFINITY, |cost| cost.median / tests_per_triangle)
}

/// Settles on a plan, with the proof that stays.
fn settled(
    situation: &Situation,
    contested: &Contested,
    default: &'static Variant,
    asking: &mut Asking<'_, '_>,
) -> Settled {
    let mut looked = looked(situation, contest::savings(&contested.pairs));
    let usual = asking.standing(default);
    let mut known: Vec<(String, Answers)> = Vec::new();
    let mut prove = |form: &Form| {
        if let Some((_, answers)) = known.iter().find(|(id, _)| *id == form.id) {
            return *answers;
        }
        let answers = find(&form.id)
            .map_or_else(Answers::default, |variant| asking.standing(variant).beside(&usual));
        known.push((form.id.clone(), answers));
        answers
    };
    settle(&mut looked, &contested.finals, usual.agree(), &mut prove)
}

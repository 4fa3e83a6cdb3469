//! Scene by scene: built, checked, measured in groups of searches that are alike in speed.

use std::rc::Rc;
use std::sync::atomic::Ordering;

use super::set::{Set, opened, rays, scene_name, standing_in, thinned};
use super::subject::{Built, Class, Subject};
use super::workload::{RayKind, StructuresWorkload};
use super::{build, derived, volumes};
use crate::experiment::bench::Bench;
use crate::experiment::cells::Measured;
use crate::experiment::plan::Plan;
use crate::experiment::rows::{outputs_hash, put_group};
use crate::experiment::run::Trouble;
use crate::job::{Answer, Block};
use crate::measure::{Chain, Contestant, EmptyLoop, Order, Pace, Protocol, Role};
use crate::rows::put_accuracy;
use crate::structure::{List, Structure, StructureJob};
use crate::table::Row;
use crate::workload::Ray;

/// Empty loop and chain.
pub const CONTROLS: usize = 2;

/// Rays differ by more than blocks of the usual length do.
const BLOCK_NS: u64 = 120_000;
/// Longest block: of lists of many triangles.
const LONGEST_NS: u64 = 4_000_000;
/// Blocks that a pass is cut into, at most: each is visited often enough to be told from the others, so that
/// times are of whole passes.
const MOST_BLOCKS: u64 = 6;

/// So many rounds of walks over sets of rays.
pub fn protocol(rounds: usize, seed: u64) -> Protocol {
    Protocol {
        rounds: rounds.max(Protocol::LEAST_ROUNDS),
        exact_rounds: true,
        block_ns: BLOCK_NS,
        pace: Pace::Walk,
        ..Protocol::new(Order::Fixed, seed)
    }
}

/// A row per scene, kind of rays and search; then what volumes cost, and what follows from all rows.
///
/// # Errors
/// As drawing, measuring and keeping.
pub fn run(
    plan: &Plan,
    workload: &StructuresWorkload,
    bench: &mut Bench<'_>,
) -> Result<Measured, Trouble> {
    let mut measured = Measured { rows: Vec::new(), figures: Vec::new(), wrong: Vec::new() };
    for scene in &workload.scenes {
        if bench.cancel.load(Ordering::Relaxed) {
            return Ok(measured);
        }
        of_scene(plan, workload, scene, bench, &mut measured)?;
    }
    if let Some(bounded) = &workload.volumes
        && !bench.cancel.load(Ordering::Relaxed)
    {
        volumes::run(plan, &workload.kernels[0], bounded, bench, &mut measured)?;
    }
    // Of some sizes only, a growth would be another one.
    if !bench.cancel.load(Ordering::Relaxed) {
        let derived = derived::rows(&mut measured.rows);
        measured.rows.extend(derived);
    }
    Ok(measured)
}

fn of_scene(
    plan: &Plan,
    workload: &StructuresWorkload,
    scene: &str,
    bench: &mut Bench<'_>,
    measured: &mut Measured,
) -> Result<(), Trouble> {
    let seed = plan.experiment.seed;
    let mesh = opened(scene)?;
    let triangles = mesh.list();
    let base: Rc<dyn Structure> = standing_in(&triangles).into();
    let mut sets = Vec::new();
    for kind in &workload.rays {
        let rays = rays(&mesh, *kind, workload.width, seed)?;
        sets.push((*kind, Set::new(&triangles, rays, base.as_ref())));
    }
    let subjects = workload.subjects().unwrap_or_default();
    for class in Class::ALL {
        let of_class =
            |one: &&Subject| one.class() == class && workload.includes(one, triangles.len());
        let mut members: Vec<Member<'_>> =
            subjects.iter().filter(of_class).map(Member::of).collect();
        let name = |kind: &RayKind| format!("{scene} {} {class:?}", kind.word());
        let is_kept = workload.rays.iter().all(|kind| bench.keep.is_kept(&name(kind)));
        for member in members.iter_mut().filter(|member| member.subject.lacks().is_none()) {
            member.built = member.subject.build(&triangles);
            if !is_kept {
                member.times = build::times_ms(member.subject, &triangles, bench);
            }
        }
        for (kind, set) in &sets {
            if bench.cancel.load(Ordering::Relaxed) {
                return Ok(());
            }
            let list_count = workload.list_count(triangles.len());
            let group = Group { plan, scene, kind: *kind, base: &base, list_count };
            if class == Class::Linear {
                let set = set.thinned(list_count);
                group.measure(&members, &set, &name(kind), bench, measured)?;
            } else {
                group.measure(&members, set, &name(kind), bench, measured)?;
            }
        }
    }
    Ok(())
}

/// A search of a group, built.
struct Member<'a> {
    subject: &'a Subject,
    built: Built,
    times: Vec<f64>,
}

impl<'a> Member<'a> {
    fn of(subject: &'a Subject) -> Self {
        Member { subject, built: Built::WithItsJob, times: Vec::new() }
    }
}

/// The answers that structures must give, by the kernel at their leaves.
type Known = std::collections::BTreeMap<String, Vec<Answer>>;

/// What the searches of a group have in common.
struct Group<'a> {
    plan: &'a Plan,
    scene: &'a str,
    kind: RayKind,
    base: &'a Rc<dyn Structure>,
    list_count: usize,
}

impl Group<'_> {
    /// Checks, times and keeps a group.
    fn measure(
        &self,
        members: &[Member<'_>],
        set: &Set<'_>,
        piece: &str,
        bench: &mut Bench<'_>,
        measured: &mut Measured,
    ) -> Result<(), Trouble> {
        let first = measured.rows.len();
        let (mut places, mut contestants) = (Vec::new(), Vec::new());
        let mut known = Known::default();
        for member in members {
            let mut row = self.row(member, set);
            let wrong = &mut measured.wrong;
            if let Some(contestant) = self.checked(member, set, &mut row, wrong, &mut known) {
                places.push(measured.rows.len());
                contestants.push(contestant);
            }
            measured.rows.push(row);
        }
        let all: Vec<usize> = (first..measured.rows.len()).collect();
        if all.is_empty() {
            return Ok(());
        }
        let protocol = protocol(bench.rounds, self.plan.experiment.seed);
        if bench.take_back(piece, &all, &mut measured.rows)? {
            bench.pass_over_as(&protocol, places.len() + CONTROLS);
            return Ok(());
        }
        if time(contestants, &places, &protocol, bench, &mut measured.rows)? {
            bench.keep_piece(piece, &all, &measured.rows)?;
        }
        Ok(())
    }

    /// The row of a search before anything is known of its answers.
    fn row(&self, member: &Member<'_>, set: &Set<'_>) -> Row {
        let mut row = Row {
            experiment: self.plan.experiment.id.clone(),
            record: "search".into(),
            workload: "scene-structures".into(),
            order: Order::Fixed.word().into(),
            scene: scene_name(self.scene).into(),
            ray_class: self.kind.word().into(),
            triangles: Some(set.triangles.len() as u64),
            rays: Some(set.rays.len() as u64),
            query: "ray".into(),
            generator: "pcg".into(),
            workload_hash: format!("{:016x}", set.hash),
            seed: Some(self.plan.experiment.seed),
            ..member.subject.row()
        };
        build::put(&mut row, &member.times);
        row
    }

    /// Searches once, holds the answers against the list's and the exact ones, and fills the row.
    fn checked(
        &self,
        member: &Member<'_>,
        set: &Set<'_>,
        row: &mut Row,
        wrong: &mut Vec<String>,
        known: &mut Known,
    ) -> Option<Contestant> {
        let subject = member.subject;
        if let Some(reason) = subject.lacks() {
            row.status = "skipped".into();
            row.reason = reason;
            return None;
        }
        let mut ready = subject.bind(&member.built, set.triangles, &set.rays);
        ready.put(row);
        let answers = ready.job.answers();
        let judgement = set.judge(&answers, !matches!(subject, Subject::Peer(_)));
        put_accuracy(row, &judgement.accuracy);
        let hits = answers.iter().filter(|answer| answer.triangle.is_some()).count() as u64;
        row.hits = Some(hits);
        row.outputs_hash = outputs_hash(ready.job.as_mut());
        let mut reason = judgement.wrong.filter(|_| subject.claims_exactness());
        if let Subject::General(_, leaf) = subject {
            let wanted = known.entry(leaf.axes.id()).or_insert_with(|| self.wanted(leaf, set));
            let differences = set.differences(&answers, wanted);
            row.differences = Some(differences.all);
            row.excused = Some(differences.excused);
            let lost = |ray| format!("ray {ray}: the list's answer is lost, and is no false hit");
            reason = differences.wrong.map(lost).or(reason);
        }
        if let Some(reason) = reason {
            row.status = "wrong-result".into();
            row.reason = reason;
            wrong.push(row.id.clone());
            return None;
        }
        row.status = "ok".into();
        Some(Contestant::new(row.id.clone(), Role::Subject, ready.job).with_hits(hits))
    }

    /// The list's answers for some rays, the standing structure's for the others.
    fn wanted(&self, leaf: &crate::registry::LeafForm, set: &Set<'_>) -> Vec<Answer> {
        let of = |structure: Rc<dyn Structure>, rays: &[Ray]| {
            let leaf = (leaf.prepare)(set.triangles);
            crate::job::Job::answers(&mut StructureJob::new(structure, leaf, rays, false))
        };
        let list = Box::new(List::new(set.triangles.len() as u32)) as Box<dyn Structure>;
        let count = self.list_count.min(set.rays.len());
        let listed = of(list.into(), &thinned(&set.rays, count));
        if count == set.rays.len() {
            return listed;
        }
        let mut wanted = of(Rc::clone(self.base), &set.rays);
        for (place, answer) in listed.into_iter().enumerate() {
            wanted[place * set.rays.len() / count] = answer;
        }
        wanted
    }
}

/// Times what was checked and fills its rows; whether it came to its end. Ratios refer to the first.
pub fn time(
    mut contestants: Vec<Contestant>,
    places: &[usize],
    protocol: &Protocol,
    bench: &mut Bench<'_>,
    rows: &mut [Row],
) -> Result<bool, Trouble> {
    let Some(first) = contestants.first_mut() else { return Ok(true) };
    first.role = Role::Reference;
    let empty = EmptyLoop::like(first.job.as_ref());
    contestants.push(Contestant::new("empty loop", Role::Empty, Box::new(empty)));
    contestants.push(Contestant::new("chain", Role::Chain, Box::new(Chain::default())));
    let block_ns = block_ns(&mut contestants, bench);
    let protocol = &Protocol { block_ns, ..protocol.clone() };
    let report = bench.measure_as(&mut contestants, protocol)?;
    for (place, figures) in places.iter().zip(&report.figures) {
        put_group(&mut rows[*place], figures, &report, "ok");
    }
    Ok(!report.cancelled)
}

/// A part of the longest pass of a group.
fn block_ns(contestants: &mut [Contestant], bench: &mut Bench<'_>) -> u64 {
    let mut longest = 0;
    for contestant in contestants.iter_mut() {
        let start = bench.clock.now_ns();
        std::hint::black_box(contestant.job.run(Block::whole(contestant.job.as_ref())));
        longest = longest.max(bench.clock.now_ns().saturating_sub(start));
    }
    (longest / MOST_BLOCKS).clamp(BLOCK_NS, LONGEST_NS)
}

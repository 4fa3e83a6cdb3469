//! Picture by picture: held against the exact one, then measured with every kernel in turn.

use std::rc::Rc;
use std::sync::atomic::Ordering;

use super::workload::{PicturesWorkload, Sampling};
use crate::experiment::bench::Bench;
use crate::experiment::cells::Measured;
use crate::experiment::plan::Plan;
use crate::experiment::rows::outputs_hash;
use crate::experiment::run::Trouble;
use crate::experiment::search::{leaves_of, opened, protocol, scene_name, time};
use crate::job::Job;
use crate::measure::{BuildInfo, Contestant, Order, Protocol, Role};
use crate::registry::{LeafForm, find};
use crate::render::{Compared, Exactly, Frame, FrameJob, Stage, Way, whole};
use crate::rows::of_axes;
use crate::structure::{Structure, kind};
use crate::table::Row;
use crate::workload::hash;

/// The picture from recorded answers, empty loop and chain.
const CONTROLS: usize = 3;

/// What an estimate takes for granted: so long takes a pixel of one kernel to be held against the exact
/// answer, and to be made.
const SECONDS_PER_PIXEL_CHECKED: f64 = 20e-6;
const SECONDS_PER_PIXEL: f64 = 3e-6;

/// A quarter of the usual rounds: a block is a whole picture, some milliseconds.
fn rounds(rounds: usize) -> usize {
    (rounds / 4).max(Protocol::LEAST_ROUNDS)
}

/// Blocks that are timed.
pub fn blocks(workload: &PicturesWorkload, of_profile: usize) -> usize {
    workload.pictures().count() * rounds(of_profile) * (workload.kernels.len() + CONTROLS)
}

/// Seconds of checking, and of pictures beyond blocks of the usual length.
pub fn seconds_around(workload: &PicturesWorkload, of_profile: usize) -> f64 {
    let pixels: f64 = workload.size.map(f64::from).iter().product();
    let of_picture = SECONDS_PER_PIXEL_CHECKED + SECONDS_PER_PIXEL * rounds(of_profile) as f64;
    workload.pictures().count() as f64 * workload.kernels.len() as f64 * pixels * of_picture
}

/// A row per picture and kernel, and one of the picture without any search.
///
/// # Errors
/// As making a scene, measuring and keeping.
pub fn run(
    plan: &Plan,
    workload: &PicturesWorkload,
    bench: &mut Bench<'_>,
) -> Result<Measured, Trouble> {
    let mut measured = Measured { rows: Vec::new(), figures: Vec::new(), wrong: Vec::new() };
    let leaves = leaves_of(&workload.kernels).unwrap_or_default();
    for (structure, scene, sampling) in workload.pictures() {
        if bench.cancel.load(Ordering::Relaxed) {
            break;
        }
        let stage = Rc::new(Stage::new(&opened(scene)?, workload.size));
        let Some(kind) = kind(structure) else { continue };
        let built: Rc<dyn Structure> = (kind.build)(&stage.triangles).into();
        let picture =
            Picture { plan, structure, scene, sampling, depth: workload.depth, stage, built };
        picture.measure(&leaves, bench, &mut measured)?;
    }
    Ok(measured)
}

/// What the kernels of a group make.
struct Picture<'a> {
    plan: &'a Plan,
    structure: &'a str,
    scene: &'a str,
    sampling: Sampling,
    depth: u32,
    stage: Rc<Stage>,
    built: Rc<dyn Structure>,
}

impl Picture<'_> {
    fn measure(
        &self,
        leaves: &[LeafForm],
        bench: &mut Bench<'_>,
        measured: &mut Measured,
    ) -> Result<(), Trouble> {
        let first = measured.rows.len();
        let (mut places, mut contestants) = (vec![first], Vec::new());
        let Some(leaf) = leaves.first() else { return Ok(()) };
        let (row, replay) = self.without_search(leaf);
        measured.rows.push(row);
        contestants.push(replay);
        for leaf in leaves {
            let mut row = self.row(leaf);
            if let Some(contestant) = self.checked(leaf, &mut row, &mut measured.wrong) {
                places.push(measured.rows.len());
                contestants.push(contestant);
            }
            measured.rows.push(row);
        }
        let all: Vec<usize> = (first..measured.rows.len()).collect();
        let piece = format!("{} in {}, {}", self.scene, self.structure, self.sampling.word());
        let protocol = protocol(rounds(bench.rounds), self.plan.experiment.seed);
        if bench.take_back(&piece, &all, &mut measured.rows)? {
            bench.pass_over_as(&protocol, leaves.len() + CONTROLS);
        } else if time(contestants, &places, &protocol, bench, &mut measured.rows)? {
            measured.rows[first..].iter_mut().for_each(put_frames);
            bench.keep_piece(&piece, &all, &measured.rows)?;
        }
        Ok(())
    }

    fn job(&self, leaf: &LeafForm) -> FrameJob {
        let (stage, built) = (Rc::clone(&self.stage), Rc::clone(&self.built));
        let triangles = (leaf.prepare)(&self.stage.triangles);
        FrameJob::new(stage, built, triangles, self.sampling.manner(self.depth))
    }

    /// The columns that all rows of a picture have.
    fn about(&self) -> Row {
        let triangles = &self.stage.triangles;
        Row {
            experiment: self.plan.experiment.id.clone(),
            workload: "scene-pictures".into(),
            order: Order::Fixed.word().into(),
            structure: self.structure.into(),
            scene: scene_name(self.scene).into(),
            variation: self.sampling.word(),
            triangles: Some(triangles.len() as u64),
            workload_hash: format!("{:016x}", hash::workload(&[], triangles)),
            seed: Some(self.plan.experiment.seed),
            build: BuildInfo::of_this_program().label(),
            ..Row::default()
        }
    }

    fn row(&self, leaf: &LeafForm) -> Row {
        let (own, about) = (of_axes(&leaf.axes), self.about());
        Row {
            id: format!("{}/{}", self.structure, own.id),
            record: "picture".into(),
            experiment: about.experiment,
            workload: about.workload,
            order: about.order,
            structure: about.structure,
            scene: about.scene,
            variation: about.variation,
            triangles: about.triangles,
            workload_hash: about.workload_hash,
            seed: about.seed,
            ..own
        }
    }

    /// The reference: the picture from recorded answers. Which kernel gave them makes no difference to
    /// the time.
    fn without_search(&self, leaf: &LeafForm) -> (Row, Contestant) {
        let mut replay = self.job(leaf).replay();
        let outputs_hash = outputs_hash(&mut replay);
        let row = Row {
            id: format!("{}/recorded", self.structure),
            kernel: "recorded".into(),
            record: "recorded".into(),
            status: "ok".into(),
            outputs_hash,
            ..self.about()
        };
        let contestant = Contestant::new(row.id.clone(), Role::Reference, Box::new(replay));
        (row, contestant)
    }

    /// Makes the picture, holds it against the exact one, and fills the row.
    fn checked(
        &self,
        leaf: &LeafForm,
        row: &mut Row,
        wrong: &mut Vec<String>,
    ) -> Option<Contestant> {
        let mut job = self.job(leaf);
        let frame = job.frame();
        put_counts(row, &frame);
        row.outputs_hash = outputs_hash(&mut job);
        let first_wrong = self.compare(&mut job, row);
        let claims = find(&leaf.axes.id()).is_some_and(crate::registry::Variant::claims_exactness);
        if let Some((pixel, way)) = first_wrong.filter(|_| claims) {
            let columns = self.stage.size()[0] as usize;
            let (column, line) = (pixel % columns, pixel / columns);
            row.status = "wrong-result".into();
            row.reason =
                format!("column {column} of row {line}: {way:?}, and no rounding explains it");
            wrong.push(row.id.clone());
            return None;
        }
        row.status = "ok".into();
        Some(Contestant::new(row.id.clone(), Role::Subject, Box::new(job) as Box<dyn Job>))
    }

    /// Counts the rays whose answers are not the exact ones; the first that rounding does not explain.
    fn compare(&self, job: &mut FrameJob, row: &mut Row) -> Option<(usize, Way)> {
        let exactly = Exactly::new(&self.stage.triangles, self.built.as_ref(), false);
        let pixels = self.stage.size().map(|side| side as usize).iter().product();
        let mut first = None;
        job.with(|stage, tracer, manner| {
            let mut compared = Compared::new(tracer, exactly, pixels);
            let frame = whole(stage, &mut compared, manner);
            let counts = Way::ALL.map(|way| compared.count(way));
            row.differences = Some(counts.iter().map(|count| count.rays).sum());
            row.excused = Some(counts.iter().map(|count| count.excused).sum());
            first = compared.first_wrong();
            frame
        });
        first
    }
}

fn put_counts(row: &mut Row, frame: &Frame) {
    let (rays, tests) = (frame.rays.all(), frame.triangles_tested);
    row.rays = Some(rays);
    row.tests = Some(tests);
    row.tests_per_ray = Some(tests as f64 / rays.max(1) as f64);
    let pixels = frame.picture.pixels().len().max(1) as f64;
    row.filled_percent = Some(frame.saved() as f64 / pixels * 100.0);
}

/// What follows from the time of a picture and its ratio to one without any search.
fn put_frames(row: &mut Row) {
    // A million tests a second would be of pictures.
    row.mtests_per_s = None;
    row.seconds_per_frame = row.ns_per_test.map(|ns| ns * 1e-9);
    row.frames_per_s = row.ns_per_test.map(|ns| 1e9 / ns);
    if row.record == "picture" {
        let share = |ratio: f64| (1.0 - 1.0 / ratio) * 100.0;
        row.intersection_percent = row.ratio_to_reference.map(share);
    }
}

//! Whether a bounding volume pays where its test and the share that passes it say so: B + p I < I.

use std::sync::atomic::Ordering;

use super::foretold::{NOTHING, foretell};
use super::run::{protocol, time};
use super::set::{opened, scene_name};
use super::subject::leaves_of;
use super::workload::VolumesWorkload;
use crate::experiment::bench::Bench;
use crate::experiment::cells::Measured;
use crate::experiment::plan::Plan;
use crate::experiment::rows::outputs_hash;
use crate::experiment::run::Trouble;
use crate::job::Job;
use crate::measure::{Contestant, Order, Role};
use crate::registry::LeafForm;
use crate::rows::of_axes;
use crate::scene::mesh::Mesh;
use crate::scene::rays::beyond;
use crate::structure::{Best, Leaf, List, Structure, StructureJob, VOLUMES, kind};
use crate::table::Row;
use crate::workload::{Pcg, Ray, Triangle, hash, normalised, on_sphere};

/// Lines through the ball: as many as a share of them is told to a few hundredths by.
const LINES: usize = 1024;
/// The generator's stream.
const BALL: u64 = 0x4241_4c4c;
/// The list, nothing, each volume around the list, around nothing, and alone; empty loop and chain.
const CONTESTANTS: usize = 2 + 3 * VOLUMES.len() + 2;

/// Blocks that are timed.
pub fn blocks(workload: &VolumesWorkload, rounds: usize) -> usize {
    workload.triangles.len() * workload.radii.len() * rounds * CONTESTANTS
}

/// For each number of triangles and radius a group: the list, volumes around it, and volumes alone.
///
/// # Errors
/// As drawing, measuring and keeping.
pub fn run(
    plan: &Plan,
    kernel: &str,
    workload: &VolumesWorkload,
    bench: &mut Bench<'_>,
    measured: &mut Measured,
) -> Result<(), Trouble> {
    let leaf = leaves_of(&[kernel.to_owned()]).ok().and_then(|leaves| leaves.into_iter().next());
    let Some(leaf) = leaf else { return Ok(()) };
    for count in &workload.triangles {
        let scene = format!("soup:{count}");
        let mesh = opened(&scene)?;
        let triangles = mesh.list();
        for radius in &workload.radii {
            if bench.cancel.load(Ordering::Relaxed) {
                return Ok(());
            }
            let rays = lines(&mesh, *radius, plan.experiment.seed);
            let cell = Cell { plan, leaf: &leaf, scene: &scene, radius: *radius };
            cell.measure((&triangles, &rays), bench, measured)?;
        }
    }
    Ok(())
}

/// Chords of the ball around the mesh, so many times as large.
fn lines(mesh: &Mesh, radius: f64, seed: u64) -> Vec<Ray> {
    let bounds = mesh.bounds();
    let mut source = Pcg::stream(seed, BALL);
    let mut line = || {
        let (from, to) = (on_sphere(&mut source), on_sphere(&mut source));
        let origin = bounds.centre() + from.as_dvec3() * (radius * bounds.radius());
        beyond(origin.as_vec3(), normalised(to - from).as_dvec3(), &bounds)
    };
    (0..LINES).map(|_| line()).collect()
}

/// Triangles that are never tested: a search with one costs what the volume around it does. Alone, in a loop
/// of its own, a volume's test begins before the one before has ended, and seems to cost less.
struct Emptied(Box<dyn Leaf>);

impl Leaf for Emptied {
    fn is_segment(&self) -> bool {
        self.0.is_segment()
    }

    fn triangles(&self) -> usize {
        self.0.triangles()
    }

    fn bytes(&self) -> usize {
        self.0.bytes()
    }

    fn aim(&mut self, ray: &Ray) {
        self.0.aim(ray);
    }

    fn test(&mut self, _: &[u32], _: &mut Best) {}
}

struct Cell<'a> {
    plan: &'a Plan,
    leaf: &'a LeafForm,
    scene: &'a str,
    radius: f64,
}

/// A search or a volume, with the share of rays that pass it.
struct Timed {
    record: &'static str,
    structure: &'static str,
    share: Option<f64>,
    job: Box<dyn Job>,
}

impl Cell<'_> {
    fn measure(
        &self,
        (triangles, rays): (&[Triangle], &[Ray]),
        bench: &mut Bench<'_>,
        measured: &mut Measured,
    ) -> Result<(), Trouble> {
        let first = measured.rows.len();
        let (mut places, mut contestants) = (Vec::new(), Vec::new());
        let mut list_hits = None;
        for mut timed in self.all(triangles, rays) {
            let answers = timed.job.answers();
            let hits = answers.iter().filter(|answer| answer.triangle.is_some()).count() as u64;
            let mut row = self.row(&timed, (triangles, rays));
            row.hits = Some(hits);
            row.outputs_hash = outputs_hash(timed.job.as_mut());
            // No volume may lose a hit of the list.
            let is_search = timed.record == "bounded" && timed.structure != NOTHING;
            if is_search && *list_hits.get_or_insert(hits) != hits {
                row.status = "wrong-result".into();
                row.reason = "it finds another number of hits than the list".into();
                measured.wrong.push(row.id.clone());
            } else {
                row.status = "ok".into();
                let id = format!("{} {}", row.record, row.id);
                places.push(measured.rows.len());
                contestants.push(Contestant::new(id, Role::Subject, timed.job).with_hits(hits));
            }
            measured.rows.push(row);
        }
        let all: Vec<usize> = (first..measured.rows.len()).collect();
        let piece = format!("volumes {} {}", self.scene, self.radius);
        let protocol = protocol(bench.rounds, self.plan.experiment.seed);
        if bench.take_back(&piece, &all, &mut measured.rows)? {
            bench.pass_over_as(&protocol, CONTESTANTS);
        } else if time(contestants, &places, &protocol, bench, &mut measured.rows)? {
            foretell(&mut measured.rows[first..]);
            bench.keep_piece(&piece, &all, &measured.rows)?;
        }
        Ok(())
    }

    /// The list first: ratios refer to it.
    fn all(&self, triangles: &[Triangle], rays: &[Ray]) -> Vec<Timed> {
        let search = |structure: &'static str, built: Box<dyn Structure>| {
            let leaf = (self.leaf.prepare)(triangles);
            let mut job = StructureJob::new(built, leaf, rays, false);
            let share = job.counts().share_passed();
            Timed { record: "bounded", structure, share, job: Box::new(job) }
        };
        let mut all = vec![
            search("list", Box::new(List::new(triangles.len() as u32))),
            search(NOTHING, Box::new(List::new(0))),
        ];
        for volume in VOLUMES {
            let Some(kind) = kind(volume.id) else { continue };
            let bounded = search(volume.id, (kind.build)(triangles));
            let share = bounded.share;
            all.push(bounded);
            let leaf = Box::new(Emptied((self.leaf.prepare)(triangles)));
            let job = StructureJob::new((kind.build)(triangles), leaf, rays, false);
            let (record, structure) = ("emptied", volume.id);
            all.push(Timed { record, structure, share, job: Box::new(job) });
            let job = (volume.bind)(triangles, rays);
            all.push(Timed { record: "volume", structure: volume.id, share, job });
        }
        all
    }

    fn row(&self, timed: &Timed, (triangles, rays): (&[Triangle], &[Ray])) -> Row {
        let own = of_axes(&self.leaf.axes);
        Row {
            experiment: self.plan.experiment.id.clone(),
            id: format!("{}/{}", timed.structure, own.id),
            record: timed.record.into(),
            structure: timed.structure.into(),
            workload: "scene-volumes".into(),
            order: Order::Fixed.word().into(),
            scene: scene_name(self.scene).into(),
            ray_class: "random".into(),
            knob: Some(self.radius),
            knob_name: "radius of the ball".into(),
            triangles: Some(triangles.len() as u64),
            rays: Some(rays.len() as u64),
            passed_share: timed.share,
            query: "ray".into(),
            generator: "pcg".into(),
            workload_hash: format!("{:016x}", hash::workload(rays, triangles)),
            seed: Some(self.plan.experiment.seed),
            ..own
        }
    }
}

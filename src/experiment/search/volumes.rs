//! Whether a bounding volume pays where its test and the share that passes it say so: B + p I < I.

use std::sync::atomic::Ordering;

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
use crate::structure::{List, Structure, StructureJob, VOLUMES, kind};
use crate::table::Row;
use crate::workload::{Pcg, Ray, Triangle, hash, normalised, on_sphere};

/// Lines through the ball: as many as a share of them is told to a few hundredths by.
const LINES: usize = 1024;
/// The generator's stream.
const BALL: u64 = 0x4241_4c4c;
/// The list of no triangle: what a search costs with nothing in it.
const NOTHING: &str = "nothing";
/// The list, nothing, each volume around the list and alone; empty loop and chain.
const CONTESTANTS: usize = 2 + 2 * VOLUMES.len() + 2;

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
            let (share, job) = (bounded.share, (volume.bind)(triangles, rays));
            all.push(bounded);
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

/// Lower end, middle and upper end of a time.
type Time = [f64; 3];

fn time_of(row: &Row) -> Option<Time> {
    Some([row.ns_low?, row.ns_per_test?, row.ns_high?])
}

/// Writes into the rows of a group what B + p I says, and whether the clock agrees about who pays.
fn foretell(rows: &mut [Row]) {
    let of = |rows: &[Row], record: &str, structure: &str| {
        let mut own = rows.iter().filter(|row| row.record == record && row.structure == structure);
        own.next().and_then(time_of)
    };
    let (list, nothing) = (of(rows, "bounded", "list"), of(rows, "bounded", NOTHING));
    for volume in VOLUMES {
        let alone = of(rows, "volume", volume.id);
        let bounded = rows.iter_mut().filter(|row| row.record == "bounded");
        for row in bounded.filter(|row| row.structure == volume.id) {
            let (Some(list), Some(nothing), Some(alone)) = (list, nothing, alone) else { continue };
            let Some(share) = row.passed_share else { continue };
            let [low, middle, high] = foretold(list, nothing, alone, share);
            (row.predicted_low, row.predicted_high) = (Some(low), Some(high));
            row.predicted_ratio = Some(middle);
            row.pays_as_predicted =
                row.ratio_low.zip(row.ratio_high).and_then(|(own_low, own_high)| {
                    agree([own_low, own_high], [low, high]).map(u64::from)
                });
        }
    }
}

/// Time with a volume over time without: (N + B + p I) / (N + I), where N is what a search costs with
/// nothing in it, which both pay. The ends are those of the times that are worst for it, N apart: its ends
/// hardly move a quotient that has it on both sides.
fn foretold(list: Time, nothing: Time, alone: Time, share: f64) -> Time {
    let none = nothing[1];
    let at = |own: usize, other: usize| {
        let inside = (list[other] - none).max(0.0);
        (none + alone[own] + share * inside) / (none + inside)
    };
    let middle = at(1, 1);
    [at(0, 2).min(middle), middle, at(2, 0).max(middle)]
}

/// Whether two intervals are on the same side of 1; `None` where one of them is on both.
fn agree(one: [f64; 2], other: [f64; 2]) -> Option<bool> {
    let pays = |[low, high]: [f64; 2]| match () {
        () if high < 1.0 => Some(true),
        () if low > 1.0 => Some(false),
        () => None,
    };
    Some(pays(one)? == pays(other)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_foretold_ratio_is_that_of_the_lecture() {
        // N = 10, B = 5, I = 40, p = 0.25: (10 + 5 + 10) / 50.
        let time = |ns: f64| [ns - 1.0, ns, ns + 1.0];
        let [low, middle, high] = foretold(time(50.0), time(10.0), time(5.0), 0.25);
        assert_eq!(middle, 0.5);
        assert!(low < middle && middle < high);
        // All pass: the volume is paid for nothing.
        assert!(foretold(time(50.0), time(10.0), time(5.0), 1.0)[0] > 1.0);
    }

    #[test]
    fn sides_are_told_where_they_are_clear() {
        assert_eq!(agree([0.5, 0.9], [0.2, 0.99]), Some(true));
        assert_eq!(agree([1.1, 1.2], [0.2, 0.99]), Some(false));
        assert_eq!(agree([0.9, 1.2], [0.2, 0.99]), None);
        assert_eq!(agree([1.1, 1.2], [0.9, 1.3]), None);
    }

    #[test]
    fn rows_tell_what_was_foretold_and_whether_it_came() {
        let row = |record: &str, structure: &str, ns: f64, ratio: f64| Row {
            record: record.into(),
            structure: structure.into(),
            passed_share: Some(0.25),
            ns_per_test: Some(ns),
            ns_low: Some(ns),
            ns_high: Some(ns),
            ratio_low: Some(ratio),
            ratio_high: Some(ratio),
            ..Row::default()
        };
        let mut rows = vec![
            row("bounded", "list", 50.0, 1.0),
            row("bounded", NOTHING, 10.0, 0.2),
            row("bounded", "box", 26.0, 0.52),
            row("volume", "box", 5.0, 0.1),
            row("bounded", "sphere", 60.0, 1.2),
            row("volume", "sphere", 5.0, 0.1),
        ];
        foretell(&mut rows);
        assert_eq!((rows[2].predicted_ratio, rows[2].pays_as_predicted), (Some(0.5), Some(1)));
        assert_eq!((rows[4].predicted_ratio, rows[4].pays_as_predicted), (Some(0.5), Some(0)));
        assert_eq!((rows[0].predicted_ratio, rows[3].predicted_ratio), (None, None));
    }
}

//! The ways to the triangles, timed: all of them, a box around them, hierarchies.

use super::contest::{EXPERIMENT, default_variant};
use super::evidence::Saving;
use super::form::Output;
use super::situation::Paths;
use crate::experiment::{Bench, Trouble, put_group};
use crate::job::{Block, Job};
use crate::kernels::MollerTrumbore;
use crate::measure::{Chain, Contestant, Figures, Order, Protocol, Role};
use crate::policy::{Between, Compare, Early, Form, Inside, Last, Plain, Tuv, TwoSided};
use crate::rows::of_variant;
use crate::structure::{KernelLeaf, StructureJob, kind};
use crate::table::Row;
use crate::workload::{Pcg, Ray, Triangle, hash};
use std::hint::black_box;

/// The usual test, at the leaves.
type Usual =
    KernelLeaf<MollerTrumbore, Form<Early, Last, Plain, Tuv, TwoSided, Compare, Inside, Between>>;

/// Every triangle, one after the other.
pub const LIST: &str = "list";
/// The same in one box.
pub const BOXED: &str = "box";
/// Hierarchies that a plan chooses from.
pub const HIERARCHIES: [&str; 2] = ["surface", "obvhs"];
/// A list of more triangles is not timed: it takes some hundred times as long as any hierarchy.
const LONGEST_LIST: usize = 8192;
/// Tests of a pass through the list, at most, but for [`FEWEST_RAYS`]: a millisecond or less, so that a pass
/// fits between two switches of a busy machine.
const TESTS: usize = 1 << 17;
/// Rays that are timed, drawn from all.
const RAYS: usize = 256;
/// No fewer than that, however long the list is.
const FEWEST_RAYS: usize = 32;
/// A block may be between so long, ns.
const BLOCK_NS: [u64; 2] = [20_000, 100_000_000];
/// Purpose of the generator.
const PATHS: u64 = 105;

/// What was timed.
pub struct Walked {
    /// A row per structure.
    pub rows: Vec<Row>,
    /// What it says; `None` where nothing was measured.
    pub paths: Option<Paths>,
    /// Triangles that a ray is tested against in the hierarchy.
    pub tests_per_ray: f64,
}

/// What a ray's way is timed on.
struct Course<'a> {
    name: &'a str,
    rays: Vec<Ray>,
    triangles: &'a [Triangle],
    any: bool,
    seed: u64,
}

/// Who is timed, and what is known of them beforehand.
#[derive(Default)]
struct Field {
    contestants: Vec<Contestant>,
    ids: Vec<&'static str>,
    rows: Vec<Row>,
    tests_per_ray: Vec<f64>,
}

/// Times structures over all triangles; with `any`, the first hit ends a search.
///
/// # Errors
/// A group that cannot be measured.
pub fn time(
    name: &str,
    (rays, triangles): (&[Ray], &[Triangle]),
    any: bool,
    seed: u64,
    bench: &mut Bench<'_>,
) -> Result<Walked, Trouble> {
    let course = Course { name, rays: drawn(rays, triangles.len(), seed), triangles, any, seed };
    let mut field = course.field();
    let protocol = whole_passes(&mut field.contestants, bench, seed);
    let report = bench.measure_as(&mut field.contestants, &protocol)?;
    for (row, figures) in field.rows.iter_mut().zip(&report.figures) {
        put_group(row, figures, &report, "ok");
    }
    let of = |id: &str| {
        let place = field.ids.iter().position(|other| *other == id)?;
        let figures = &report.figures[place];
        figures.ns_per_test.map(|ns| (figures, ns, field.tests_per_ray[place]))
    };
    let hierarchies = HIERARCHIES.iter().filter_map(|id| of(id));
    let hierarchy = hierarchies.min_by(|a, b| a.1.total_cmp(&b.1));
    let floor = report.noise_floor.max(protocol.margin);
    let paths = hierarchy.map(|(best, _, tests)| said(best, tests, of(LIST), of(BOXED), floor));
    let tests_per_ray = paths.as_ref().map_or_else(
        || field.tests_per_ray.last().copied().unwrap_or_default(),
        |paths| paths.tests_in_hierarchy,
    );
    Ok(Walked { rows: field.rows, paths, tests_per_ray })
}

/// Some of the rays: so many that a pass through the list is short.
fn drawn(rays: &[Ray], triangles: usize, seed: u64) -> Vec<Ray> {
    let mut places = Pcg::stream(seed, PATHS).permutation(rays.len() as u32);
    let is_listed = triangles <= LONGEST_LIST;
    let fit = if is_listed { TESTS / triangles.max(1) } else { RAYS };
    places.truncate(fit.clamp(FEWEST_RAYS, RAYS));
    places.iter().map(|place| rays[*place as usize]).collect()
}

impl Course<'_> {
    /// The list, if it is not too long, the list in a box, hierarchies; the first of these twice, so that
    /// it is seen what a copy in another place of memory differs by.
    fn field(&self) -> Field {
        let lists = [LIST, BOXED].into_iter().filter(|_| self.triangles.len() <= LONGEST_LIST);
        let mut field = Field::default();
        for id in lists.chain(HIERARCHIES) {
            let Some(mut job) = self.job(id) else { continue };
            let counts = job.counts();
            field.tests_per_ray.push(counts.triangles as f64 / (counts.rays as f64).max(1.0));
            field.rows.push(self.row(id, counts.hits));
            field.ids.push(id);
            let role = if id == HIERARCHIES[0] { Role::Reference } else { Role::Subject };
            let contestant = Contestant::new(id, role, Box::new(job)).with_hits(counts.hits);
            field.contestants.push(contestant);
        }
        if let Some(copy) = self.job(HIERARCHIES[0]) {
            let id = format!("{} again", HIERARCHIES[0]);
            field.contestants.push(Contestant::new(id, Role::Placebo, Box::new(copy)));
        }
        let chain: Box<dyn Job> = Box::new(Chain::default());
        field.contestants.push(Contestant::new("chain", Role::Chain, chain));
        field
    }

    fn job(&self, id: &str) -> Option<StructureJob> {
        let structure = (kind(id)?.build)(self.triangles);
        let leaf = Box::new(Usual::new(self.triangles, false));
        Some(StructureJob::new(structure, leaf, &self.rays, self.any))
    }

    /// A row about a structure: a "test" is a ray's whole way.
    fn row(&self, id: &str, hits: u64) -> Row {
        let variant = default_variant(Output::Tuv, false, false);
        Row {
            experiment: EXPERIMENT.into(),
            workload: format!("{} through {id}", self.name),
            order: Order::Reshuffled.word().into(),
            triangles: Some(self.triangles.len() as u64),
            rays: Some(self.rays.len() as u64),
            tests: Some(self.rays.len() as u64),
            hits: Some(hits),
            query: "ray".into(),
            generator: "pcg".into(),
            workload_hash: format!("{:016x}", hash::workload(&self.rays, self.triangles)),
            seed: Some(self.seed),
            ..variant.map(of_variant).unwrap_or_default()
        }
    }
}

/// A block is a pass over all drawn rays: they differ so much that a part of them is not like another. It
/// is as long as the longest pass, and no longer: the chain fills all of it, and the longer a round is, the
/// fewer are left alone by a busy machine.
fn whole_passes(contestants: &mut [Contestant], bench: &mut Bench<'_>, seed: u64) -> Protocol {
    let mut pass_ns = |contestant: &mut Contestant| {
        let block = Block::whole(contestant.job.as_ref());
        let start = bench.clock.now_ns();
        black_box(contestant.job.run(black_box(block)));
        bench.clock.now_ns().saturating_sub(start)
    };
    let longest = contestants.iter_mut().map(&mut pass_ns).max().unwrap_or_default();
    let usual = Protocol::new(Order::Reshuffled, seed);
    let block_ns = longest.clamp(BLOCK_NS[0], BLOCK_NS[1]);
    Protocol { rounds: bench.rounds, exact_rounds: true, block_ns, ..usual }
}

/// Figures, ns, tests a ray.
type Walk<'a> = Option<(&'a Figures, f64, f64)>;

fn said(best: &Figures, tests: f64, list: Walk<'_>, boxed: Walk<'_>, floor: f64) -> Paths {
    let beside = |one: &Figures, other: &Figures| Saving::of(&one.samples, &other.samples, floor);
    // Without a hierarchy the box may still be there.
    let flat = [list, boxed].into_iter().flatten().min_by(|a, b| a.1.total_cmp(&b.1));
    Paths {
        hierarchy: best.id.clone(),
        tests_in_hierarchy: tests,
        list: flat.and_then(|(flat, ..)| beside(flat, best)),
        without_box: list.zip(boxed).and_then(|(list, boxed)| beside(list.0, boxed.0)),
    }
}

//! The ways to the triangles, timed: all of them, a box around them, hierarchies.

use super::contest::{EXPERIMENT, default_variant};
use super::evidence::Saving;
use super::form::Output;
use super::situation::Paths;
use crate::experiment::{Bench, Trouble, put_group};
use crate::job::Job;
use crate::kernels::MollerTrumbore;
use crate::measure::{Chain, Contestant, Figures, Order, Protocol, Role};
use crate::policy::{Between, Compare, Early, Form, Inside, Last, Plain, Tuv, TwoSided};
use crate::rows::of_variant;
use crate::structure::{KernelLeaf, StructureJob, kind};
use crate::table::Row;
use crate::workload::{Pcg, Ray, Triangle, hash};

/// The usual test, at the leaves.
type Usual =
    KernelLeaf<MollerTrumbore, Form<Early, Last, Plain, Tuv, TwoSided, Compare, Inside, Between>>;

/// Every triangle, one after the other.
const LIST: &str = "list";
/// The same in one box.
const BOXED: &str = "box";
/// Hierarchies that a plan chooses from.
const HIERARCHIES: [&str; 2] = ["surface", "obvhs"];
/// A list of more triangles is not timed: it takes some hundred times as long as any hierarchy.
const LONGEST_LIST: usize = 8192;
/// No pass takes longer: that many triangles and rays, some ns each.
const LONGEST_PASS_NS: u64 = 100_000_000;
/// Rays that are timed, drawn from all.
const RAYS: usize = 256;
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
    let mut places = Pcg::stream(seed, PATHS).permutation(rays.len() as u32);
    places.truncate(RAYS);
    let drawn: Vec<Ray> = places.iter().map(|place| rays[*place as usize]).collect();
    let lists = [LIST, BOXED].into_iter().filter(|_| triangles.len() <= LONGEST_LIST);
    let ids: Vec<&str> = lists.chain(HIERARCHIES).collect();
    let mut contestants: Vec<Contestant> = Vec::new();
    let (mut rows, mut tests) = (Vec::new(), Vec::new());
    for id in &ids {
        let Some(kind) = kind(id) else { continue };
        let leaf = Box::new(Usual::new(triangles, false));
        let mut job = StructureJob::new((kind.build)(triangles), leaf, &drawn, any);
        let counts = job.counts();
        tests.push(counts.triangles as f64 / (counts.rays as f64).max(1.0));
        rows.push(row(name, id, &drawn, triangles, counts.hits, seed));
        let role = if *id == HIERARCHIES[0] { Role::Reference } else { Role::Subject };
        contestants.push(Contestant::new(*id, role, Box::new(job)).with_hits(counts.hits));
    }
    let chain: Box<dyn Job> = Box::new(Chain::default());
    contestants.push(Contestant::new("chain", Role::Chain, chain));
    let report = bench.measure_as(&mut contestants, &whole_passes(bench.rounds, seed))?;
    for (row, figures) in rows.iter_mut().zip(&report.figures) {
        put_group(row, figures, &report, "ok");
    }
    let of = |id: &str| {
        let place = ids.iter().position(|other| *other == id)?;
        let figures = &report.figures[place];
        figures.ns_per_test.map(|ns| (figures, ns, tests[place]))
    };
    let first = HIERARCHIES.iter().filter_map(|id| of(id));
    let hierarchy = first.min_by(|a, b| a.1.total_cmp(&b.1));
    let paths = hierarchy
        .map(|(best, _, tests)| said(best, tests, of(LIST), of(BOXED), report.noise_floor));
    let tests_per_ray = paths.as_ref().map_or_else(
        || tests.last().copied().unwrap_or_default(),
        |paths| paths.tests_in_hierarchy,
    );
    Ok(Walked { rows, paths, tests_per_ray })
}

/// A block is a pass over all drawn rays: they differ so much that a part of them is not like another.
fn whole_passes(rounds: usize, seed: u64) -> Protocol {
    let usual = Protocol::new(Order::Reshuffled, seed);
    Protocol { rounds, exact_rounds: true, block_ns: LONGEST_PASS_NS, ..usual }
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

/// A row about a structure: a "test" is a ray's whole way.
fn row(name: &str, id: &str, rays: &[Ray], triangles: &[Triangle], hits: u64, seed: u64) -> Row {
    let variant = default_variant(Output::Tuv, false, false);
    Row {
        experiment: EXPERIMENT.into(),
        workload: format!("{name} through {id}"),
        order: Order::Reshuffled.word().into(),
        triangles: Some(triangles.len() as u64),
        rays: Some(rays.len() as u64),
        tests: Some(rays.len() as u64),
        hits: Some(hits),
        query: "ray".into(),
        generator: "pcg".into(),
        workload_hash: format!("{:016x}", hash::workload(rays, triangles)),
        seed: Some(seed),
        ..variant.map(of_variant).unwrap_or_default()
    }
}

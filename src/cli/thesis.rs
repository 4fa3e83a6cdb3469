//! The thesis program: `ray_test [DENSITY] [TRIANGLES] [REPEATS]`.

use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::ProgressBar;
use serde_json::{Value, json};

use super::arguments::{Format, Thesis};
use super::failure::Failure;
use super::show::{Sheet, print};
use super::slices::Slices;
use super::thesis_asked::{Asked, checked};
use super::{interrupt, lock, progress};
use crate::experiment::{BEYOND, Scene, beyond_prediction, put_percent_slower};
use crate::job::{Block, Job, Tally};
use crate::measure::{Clock, Order, WallClock};
use crate::registry::Variant;
use crate::table::Row;
use crate::workload::{PairSpec, Pairs, Pcg, WorkloadError};

/// Checks everything, then runs the thesis's test and prints its table.
pub fn run(arguments: &Thesis) -> Result<(), Failure> {
    let Asked { densities, chosen, count, slices } = checked(arguments)?;
    for density in &densities {
        let refused = |error: WorkloadError| Failure::Usage(error.to_string());
        spec(arguments, count, *density).check().map_err(refused)?;
    }
    let _lock = lock::take()?;
    let cancel = interrupt::flag();
    let bar = progress::bar(densities.len().saturating_mul(slices.number()));
    let mut rows = Vec::new();
    // Until a density is done there is nothing to show: drawing and checking millions of pairs need not
    // come to an end first.
    interrupt::end_at_once(true);
    for density in &densities {
        let measured = scene(arguments, count, *density, cancel).and_then(|scene| {
            if rows.is_empty() {
                warn_of_prediction(arguments.order.value(), &scene, chosen.len());
            }
            measure(arguments, &chosen, &scene, slices, (&bar, cancel))
        });
        match measured {
            Err(Failure::Interrupted) => break,
            measured => rows.extend(measured?),
        }
        interrupt::end_at_once(false);
    }
    bar.finish_and_clear();
    put_percent_slower(&mut rows);
    print(&sheet(&rows), arguments.format)?;
    if arguments.format == Format::Text && densities.len() > 1 {
        slowest(&rows)?;
    }
    if cancel.load(Ordering::Relaxed) { Err(Failure::Interrupted) } else { Ok(()) }
}

fn warn_of_prediction(order: Order, scene: &Scene, kernels: usize) {
    if order == Order::Fixed && beyond_prediction(scene, kernels) {
        say!("warning: {kernels} kernels x {} pairs {BEYOND}", scene.rays.len());
    }
}

fn spec(arguments: &Thesis, count: usize, density: f64) -> PairSpec {
    let generator = arguments.generator.value();
    PairSpec { generator, ..PairSpec::new(count, density, arguments.seed) }
}

fn scene(
    arguments: &Thesis,
    count: usize,
    density: f64,
    cancel: &AtomicBool,
) -> Result<Scene, Failure> {
    match Pairs::draw_unless(spec(arguments, count, density), cancel) {
        Err(WorkloadError::Cancelled) => Err(Failure::Interrupted),
        Err(error) => Err(Failure::Usage(error.to_string())),
        Ok(pairs) => Ok(Scene::of_pairs(pairs)),
    }
}

/// A kernel on a scene, checked: its answers are those that `expected` sums up.
struct Contender {
    job: Box<dyn Job>,
    expected: Tally,
    found: Tally,
    nanoseconds: u64,
}

/// Checks the kernels on a scene, then times all of it, in slices that take turns, so that a
/// disturbance does not fall on one kernel alone. What the timed slices found must be what was
/// checked, as often.
fn measure(
    arguments: &Thesis,
    chosen: &[(String, &'static Variant)],
    scene: &Scene,
    slices: Slices,
    (bar, cancel): (&ProgressBar, &AtomicBool),
) -> Result<Vec<Row>, Failure> {
    let mut contenders = contenders(chosen, scene, cancel)?;
    let mut clock = WallClock::new();
    let mut shuffler = Pcg::stream(arguments.seed, SHUFFLE);
    let number = contenders.len();
    for (turn, block) in slices.enumerate() {
        for place in 0..number {
            // Of a large set, a new order alone takes a second.
            if cancel.load(Ordering::Relaxed) {
                return Err(Failure::Interrupted);
            }
            let contender = &mut contenders[(turn + place) % number];
            if slices.order == Order::Reshuffled {
                let items = u32::try_from(scene.rays.len()).unwrap_or(u32::MAX);
                contender.job.permute(&shuffler.permutation(items));
            }
            let start = clock.now_ns();
            let found = contender.job.run(block);
            contender.nanoseconds += clock.now_ns() - start;
            contender.found = contender.found.plus(found);
        }
        bar.inc(1);
    }
    let timed = chosen.iter().zip(&contenders);
    if let Some(((word, _), _)) =
        timed.clone().find(|(_, one)| one.found != one.expected.times(slices.repeats))
    {
        let reason = format!("{word}: the timed tests found something else than the checked ones");
        return Err(Failure::Wrong(vec![reason]));
    }
    Ok(timed.map(|((word, variant), one)| row(word, variant, scene, slices, one)).collect())
}

fn contenders(
    chosen: &[(String, &'static Variant)],
    scene: &Scene,
    cancel: &AtomicBool,
) -> Result<Vec<Contender>, Failure> {
    let mut contenders = Vec::new();
    let mut wrong = Vec::new();
    for (word, variant) in chosen {
        if !scene.solve_unless(variant, cancel) || cancel.load(Ordering::Relaxed) {
            return Err(Failure::Interrupted);
        }
        let Some(mut job) = scene.bind(variant) else {
            return Err(Failure::Usage(format!("--kernels: '{word}' does not run on pairs")));
        };
        let judgement = scene.judge(variant, job.as_mut());
        if let Some(reason) = judgement.wrong.filter(|_| variant.claims_exactness()) {
            wrong.push(format!("{}: {reason}", variant.id()));
        }
        let expected = job.run(Block::whole(job.as_ref()));
        contenders.push(Contender { job, expected, found: Tally::default(), nanoseconds: 0 });
    }
    if wrong.is_empty() { Ok(contenders) } else { Err(Failure::Wrong(wrong)) }
}

/// The stream of the generator that permutations come from.
const SHUFFLE: u64 = 0x5448_4553_4953;

fn row(word: &str, variant: &Variant, scene: &Scene, slices: Slices, timed: &Contender) -> Row {
    let tests = scene.rays.len() as f64 * slices.repeats as f64;
    Row {
        id: variant.id(),
        kernel: word.into(),
        order: slices.order.word().into(),
        density: scene.facts.density,
        triangles: Some(scene.triangles.len() as u64),
        repeats: Some(slices.repeats),
        hits: Some(timed.expected.hits),
        seconds: Some(timed.nanoseconds as f64 * 1e-9),
        ns_per_test: Some(timed.nanoseconds as f64 / tests),
        ..Row::default()
    }
}

fn sheet(rows: &[Row]) -> Sheet {
    let columns = vec![
        "kernel",
        "density",
        "triangles",
        "repeats",
        "hits",
        "seconds",
        "ns_per_test",
        "percent_slower",
    ];
    let values = |row: &Row| -> Vec<Value> {
        vec![
            json!(row.kernel),
            json!(row.density),
            json!(row.triangles),
            json!(row.repeats),
            json!(row.hits),
            json!(row.seconds),
            json!(row.ns_per_test),
            json!(row.percent_slower),
        ]
    };
    Sheet { columns, rows: rows.iter().map(values).collect() }
}

/// The thesis's last column, a line per kernel.
fn slowest(rows: &[Row]) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    let mut said: Vec<&str> = Vec::new();
    for row in rows.iter().filter(|row| row.percent_slower.is_some()) {
        if !said.contains(&row.kernel.as_str()) {
            said.push(&row.kernel);
            writeln!(
                out,
                "{:<20} {:>6.1} % slower than the fastest, over the sweep",
                row.kernel,
                row.percent_slower.unwrap_or_default()
            )?;
        }
    }
    Ok(())
}

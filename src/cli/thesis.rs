//! The thesis program: `ray_test [DENSITY] [TRIANGLES] [REPEATS]`.

use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::ProgressBar;
use serde_json::{Value, json};

use super::arguments::{Format, Thesis};
use super::failure::Failure;
use super::show::{Sheet, print};
use super::{interrupt, progress};
use crate::experiment::{PairsWorkload, Scene, put_percent_slower};
use crate::job::{Block, Job};
use crate::measure::{Clock, Order, WallClock};
use crate::registry::{Variant, kernels, variants};
use crate::table::Row;
use crate::workload::{Pcg, QueryKind, Winding};

/// Densities of the sweep.
const SWEEP: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Tests in one timed slice, about: long against the clock, short against a pre-emption.
const SLICE_TESTS: u64 = 20_000;

/// Checks everything, then runs the thesis's test and prints its table.
pub fn run(arguments: &Thesis) -> Result<(), Failure> {
    let densities = densities(arguments.density.as_deref());
    let triangles = positive("TRIANGLES", &arguments.triangles)?;
    let repeats = positive("REPEATS", &arguments.repeats)?;
    let chosen = chosen(arguments)?;
    let work = (chosen.len() * densities.len()) as u64;
    if triangles.checked_mul(repeats).and_then(|tests| tests.checked_mul(work)).is_none() {
        return Err(Failure::Usage(format!(
            "TRIANGLES x REPEATS: {triangles} x {repeats} tests, {work} times, are more than can \
             be counted; allowed: a product below 2^64"
        )));
    }
    let scenes = densities
        .iter()
        .map(|&density| scene(arguments, triangles, density))
        .collect::<Result<Vec<_>, _>>()?;
    let mut rows = Vec::new();
    let cancel = interrupt::flag();
    let bar = progress::bar(densities.len() * usize::try_from(triangles).unwrap_or(usize::MAX));
    for scene in &scenes {
        rows.extend(measure(arguments, &chosen, scene, repeats, (&bar, cancel))?);
    }
    bar.finish_and_clear();
    put_percent_slower(&mut rows);
    print(&sheet(&rows), arguments.format)?;
    if arguments.format == Format::Text && densities.len() > 1 {
        slowest(&rows);
    }
    if cancel.load(Ordering::Relaxed) { Err(Failure::Interrupted) } else { Ok(()) }
}

/// One density, or the sweep: without a word when asked for, with a warning when the word is none.
fn densities(word: Option<&str>) -> Vec<f64> {
    let sweep = SWEEP.to_vec();
    match word {
        None | Some("all") => sweep,
        Some(word) => match word.parse::<f64>() {
            Ok(density) if (0.0..=1.0).contains(&density) => vec![density],
            _ => {
                eprintln!(
                    "warning: DENSITY: '{word}' is no number in [0, 1]; running the sweep \
                     0, 0.25, 0.5, 0.75, 1 (`all` asks for it)"
                );
                sweep
            }
        },
    }
}

fn positive(name: &str, text: &str) -> Result<u64, Failure> {
    match text.parse::<u64>() {
        Ok(number) if number > 0 => Ok(number),
        _ => Err(Failure::Usage(format!(
            "{name}: '{text}' is not allowed; allowed: a positive integer"
        ))),
    }
}

/// The kernels asked for, with the words that they were asked for by.
fn chosen(arguments: &Thesis) -> Result<Vec<(String, &'static Variant)>, Failure> {
    let mut chosen: Vec<(String, &'static Variant)> = Vec::new();
    for word in &arguments.kernels {
        let id = match word.as_str() {
            "moller" => "moller1",
            "chirkov" => "chirkov-line",
            other => other,
        };
        let Some(variant) = line_form(id, arguments.output.value()) else {
            let known: Vec<_> = kernels().iter().map(|variant| variant.about.id).collect();
            let alike = |known: &&str| strsim::jaro_winkler(word, known);
            let best = known.iter().copied().max_by(|a, b| alike(a).total_cmp(&alike(b)));
            return Err(Failure::Usage(format!(
                "--kernels: '{word}' is not allowed; allowed: moller, badouel, chirkov and {}{}",
                known.join(", "),
                best.map(|best| format!(". Did you mean '{best}'?")).unwrap_or_default()
            )));
        };
        if chosen.iter().any(|(other, _)| other == word) {
            return Err(Failure::Usage(format!("--kernels: '{word}' stands there twice")));
        }
        chosen.push((word.clone(), variant));
    }
    Ok(chosen)
}

/// A kernel's single f32 form that answers for lines, at the lowest level, divided last if it can.
fn line_form(id: &str, output: &str) -> Option<&'static Variant> {
    let fits = |variant: &&Variant| {
        let axes = &variant.axes;
        let plain = axes.precision == "f32" && axes.drive == "single" && axes.rounding == "plain";
        let usual = axes.cull == "off" && axes.tests == "compare" && axes.priced.is_empty();
        let native = axes.leading_is_native && axes.stored_is_native && axes.query == "ray";
        axes.kernel == id
            && plain
            && usual
            && native
            && axes.exit == "early"
            && axes.output == output
    };
    let mut forms: Vec<&Variant> = variants().iter().filter(fits).collect();
    forms.sort_by_key(|variant| variant.axes.division != "last");
    forms.first().copied()
}

fn scene(arguments: &Thesis, triangles: u64, density: f64) -> Result<Scene, Failure> {
    let count = usize::try_from(triangles).unwrap_or(usize::MAX);
    let workload = PairsWorkload {
        count,
        reshuffled_count: count,
        density: vec![density],
        query: QueryKind::Line,
        winding: Winding::Natural,
        generator: arguments.generator.value(),
        orders: vec![arguments.order.value()],
        seconds_of_tests: None,
    };
    Scene::pairs(&workload, density, arguments.order.value(), arguments.seed)
        .map_err(|error| Failure::Usage(error.to_string()))
}

/// Checks the kernels on a scene, then times all of it, in slices that take turns, so that a
/// disturbance does not fall on one kernel alone.
fn measure(
    arguments: &Thesis,
    chosen: &[(String, &'static Variant)],
    scene: &Scene,
    repeats: u64,
    (bar, cancel): (&ProgressBar, &AtomicBool),
) -> Result<Vec<Row>, Failure> {
    let order = arguments.order.value();
    let mut jobs: Vec<Box<dyn Job>> = Vec::new();
    let mut wrong = Vec::new();
    for (_, variant) in chosen {
        let Some(mut job) = scene.bind(variant) else { continue };
        if let Some(reason) = scene.judge(variant, job.as_mut()).wrong {
            wrong.push(format!("{}: {reason}", variant.id()));
        }
        jobs.push(job);
    }
    if !wrong.is_empty() {
        return Err(Failure::Wrong(wrong));
    }
    let mut clock = WallClock::new();
    let mut nanoseconds = vec![0u64; jobs.len()];
    let mut shuffler = Pcg::stream(arguments.seed, SHUFFLE);
    for (turn, block) in slices(order, scene.rays.len(), repeats).enumerate() {
        if cancel.load(Ordering::Relaxed) {
            return Err(Failure::Interrupted);
        }
        for place in 0..jobs.len() {
            let index = (turn + place) % jobs.len();
            if order == Order::Reshuffled {
                let items = u32::try_from(scene.rays.len()).unwrap_or(u32::MAX);
                jobs[index].permute(&shuffler.permutation(items));
            }
            let start = clock.now_ns();
            jobs[index].run(block);
            nanoseconds[index] += clock.now_ns() - start;
        }
        if order == Order::Literal {
            bar.inc(block.items as u64);
        }
    }
    let hits = |job: &mut Box<dyn Job>| job.run(Block::whole(job.as_ref())).hits;
    let timed = chosen.iter().zip(&mut jobs).zip(nanoseconds);
    Ok(timed
        .map(|(((word, variant), job), ns)| {
            row(word, variant, scene, (order, repeats), ns, hits(job))
        })
        .collect())
}

/// The stream of the generator that permutations come from.
const SHUFFLE: u64 = 0x5448_4553_4953;

/// All tests, cut into slices: windows of pairs in `literal` order, passes in the others.
fn slices(order: Order, pairs: usize, repeats: u64) -> Box<dyn Iterator<Item = Block>> {
    let repeats_of = |left: u64, most: u64| left.min(most.max(1)) as usize;
    match order {
        Order::Literal => {
            let items = (SLICE_TESTS / repeats).clamp(1, pairs as u64) as usize;
            // A pair's repeats stay in one slice as long as a call can count them.
            Box::new((0..pairs).step_by(items).map(move |first| Block {
                first,
                items: items.min(pairs - first),
                repeats: usize::try_from(repeats).unwrap_or(usize::MAX),
                literal: true,
            }))
        }
        Order::Fixed | Order::Reshuffled => {
            let most = if order == Order::Fixed { SLICE_TESTS / pairs as u64 } else { 1 };
            let mut left = repeats;
            Box::new(std::iter::from_fn(move || {
                (left > 0).then(|| {
                    let passes = repeats_of(left, most);
                    left -= passes as u64;
                    Block { first: 0, items: pairs, repeats: passes, literal: false }
                })
            }))
        }
    }
}

fn row(
    word: &str,
    variant: &Variant,
    scene: &Scene,
    (order, repeats): (Order, u64),
    ns: u64,
    hits: u64,
) -> Row {
    let tests = scene.rays.len() as f64 * repeats as f64;
    Row {
        id: variant.id(),
        kernel: word.into(),
        order: order.word().into(),
        density: scene.facts.density,
        triangles: Some(scene.triangles.len() as u64),
        repeats: Some(repeats),
        hits: Some(hits),
        seconds: Some(ns as f64 * 1e-9),
        ns_per_test: Some(ns as f64 / tests),
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
fn slowest(rows: &[Row]) {
    let mut said: Vec<&str> = Vec::new();
    for row in rows.iter().filter(|row| row.percent_slower.is_some()) {
        if !said.contains(&row.kernel.as_str()) {
            said.push(&row.kernel);
            println!(
                "{:<20} {:>6.1} % slower than the fastest, over the sweep",
                row.kernel,
                row.percent_slower.unwrap_or_default()
            );
        }
    }
}

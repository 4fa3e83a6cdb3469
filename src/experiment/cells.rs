//! One cell: variants on one scene in one order. Checked, and cut into groups that are measured together.

use std::sync::atomic::Ordering;

use super::bench::Bench;
use super::limits::least_cycles;
use super::rows::{blank, outputs_hash};
use super::run::Trouble;
use super::scene::Scene;
use super::together;
pub use crate::measure::MOST_SUBJECTS;
use crate::measure::{Contestant, Figures, Order, PLACEBOS, PREDICTED_TESTS, Role, yardsticks};
use crate::registry::{self, Variant};
use crate::rows::put_accuracy;
use crate::table::Row;

/// Reference, placebos, empty loop and chain.
pub const CONTROLS: usize = 3 + PLACEBOS;

/// What came of a cell.
pub struct Measured {
    /// A row per variant, in their order.
    pub rows: Vec<Row>,
    /// The figures behind the rows that have any, by variant id, with their samples.
    pub figures: Vec<Figures>,
    /// Ids of variants that gave a wrong answer where they claim a right one.
    pub wrong: Vec<String>,
}

/// A cell, and what came of it so far.
pub struct Cell {
    /// In which order its variants are run.
    pub order: Order,
    /// The seed of its scene, and of its positions and permutations.
    pub seed: u64,
    /// Pairs, where they may be more than a branch predictor remembers.
    pub pairs_beyond: Option<usize>,
    /// A row per variant; the figures come with the measuring.
    pub measured: Measured,
}

/// A group of a cell: what is measured in the same rounds.
pub struct Piece {
    /// Which cell it is of.
    pub cell: usize,
    /// Where the rows of its subjects stand in it.
    pub places: Vec<usize>,
    /// Those subjects, then the controls.
    pub contestants: Vec<Contestant>,
    /// The name to keep its rows under; `None` where whoever calls keeps the whole cell.
    pub name: Option<String>,
}

/// Runs one cell. Its rows are kept by whoever calls.
///
/// # Errors
/// A group that cannot be measured.
pub fn run(
    experiment: &str,
    variants: &[&'static Variant],
    reference: &'static Variant,
    scene: &Scene,
    order: Order,
    bench: &mut Bench<'_>,
) -> Result<Measured, Trouble> {
    let mut cells = Vec::new();
    let pieces = prepare(experiment, variants, reference, (scene, order), bench, None, &mut cells)?;
    together::measure(pieces, &mut cells, bench)?;
    Ok(cells.swap_remove(0).measured)
}

/// Adds a cell to `cells` and gets its groups ready. Variants of levels that this processor lacks
/// become rows with status `skipped`, wrong ones rows with status `wrong-result`, and neither is
/// timed. Those rows, and later those of each group, are kept under the name `kept_as`.
///
/// # Errors
/// Rows that cannot be kept, or that were kept and are of something else.
pub fn prepare(
    experiment: &str,
    variants: &[&'static Variant],
    reference: &'static Variant,
    (scene, order): (&Scene, Order),
    bench: &mut Bench<'_>,
    kept_as: Option<&str>,
    cells: &mut Vec<Cell>,
) -> Result<Vec<Piece>, Trouble> {
    let mut measured = Measured { rows: Vec::new(), figures: Vec::new(), wrong: Vec::new() };
    let mut ready: Vec<(usize, Contestant)> = Vec::new();
    for variant in variants {
        if bench.cancel.load(Ordering::Relaxed) {
            break;
        }
        let mut row = blank(experiment, variant, scene, order);
        match checked(variant, scene, &mut row) {
            Ok(contestant) => ready.push((measured.rows.len(), contestant)),
            Err(is_wrong) if is_wrong => measured.wrong.push(variant.id()),
            Err(_) => {}
        }
        measured.rows.push(row);
    }
    if bench.cancel.load(Ordering::Relaxed) {
        // Groups of fewer are others than those that were kept: as if the cell was not begun.
        measured.rows.clear();
        measured.wrong.clear();
        ready.clear();
    } else if let Some(cell) = kept_as {
        let timed = |place: &usize| ready.iter().any(|(other, _)| other == place);
        let untimed: Vec<usize> = (0..measured.rows.len()).filter(|place| !timed(place)).collect();
        bench.keep_untimed(&format!("{cell}, not timed"), &untimed, &mut measured.rows)?;
    }
    let mut pieces = Vec::new();
    for (number, group) in groups(ready, variants).into_iter().enumerate() {
        let (places, mut contestants): (Vec<usize>, Vec<Contestant>) = group.into_iter().unzip();
        let name = kept_as.map(|cell| format!("{cell}, group {number}"));
        if let Some(name) = &name
            && bench.take_back(name, &places, &mut measured.rows)?
        {
            bench.pass_over(places.len());
            continue;
        }
        add_controls(&mut contestants, reference, scene);
        pieces.push(Piece { cell: cells.len(), places, contestants, name });
    }
    cells.push(Cell::new(scene, order, measured));
    Ok(pieces)
}

impl Cell {
    /// A cell with rows that are not measured yet, or taken back from before.
    pub fn new(scene: &Scene, order: Order, measured: Measured) -> Self {
        let pairs_beyond = beyond_prediction(scene, 1).then_some(scene.rays.len());
        Cell { order, seed: scene.facts.seed, pairs_beyond, measured }
    }
}

/// Groups of at most [`MOST_SUBJECTS`], cut between kernels where that is possible, so that the
/// forms of a kernel are measured in the same rounds. Single rays and packets apart: a packet of
/// sixteen rays is the least that a group with it can replay, and that many tests of each single
/// form are more than a branch predictor remembers.
fn groups(
    ready: Vec<(usize, Contestant)>,
    variants: &[&'static Variant],
) -> Vec<Vec<(usize, Contestant)>> {
    let (singles, packets): (Vec<_>, Vec<_>) =
        ready.into_iter().partition(|(place, _)| variants[*place].lanes == 1);
    let mut groups = cut(singles, variants);
    groups.extend(cut(packets, variants));
    groups
}

fn cut(
    ready: Vec<(usize, Contestant)>,
    variants: &[&'static Variant],
) -> Vec<Vec<(usize, Contestant)>> {
    let kernel = |place: usize| variants[place].axes.kernel;
    let mut groups: Vec<Vec<(usize, Contestant)>> = Vec::new();
    let runs = ready.chunk_by(|(a, _), (b, _)| kernel(*a) == kernel(*b)).map(<[_]>::len);
    let runs: Vec<usize> = runs.collect();
    let mut ready = ready.into_iter();
    let mut room = 0;
    for run in runs {
        // A kernel with more forms than a group has places fills up what is left of the last one.
        if run > room && run <= MOST_SUBJECTS {
            room = 0;
        }
        for member in ready.by_ref().take(run) {
            if room == 0 {
                groups.push(Vec::new());
                room = MOST_SUBJECTS;
            }
            room -= 1;
            if let Some(group) = groups.last_mut() {
                group.push(member);
            }
        }
    }
    groups
}

/// Binds and judges a variant. `Err(true)` is a wrong answer, `Err(false)` one that cannot run.
fn checked(variant: &'static Variant, scene: &Scene, row: &mut Row) -> Result<Contestant, bool> {
    let skip = |row: &mut Row, reason: String| {
        row.status = "skipped".into();
        row.reason = reason;
        Err(false)
    };
    if !(variant.available)() {
        return skip(row, format!("no {}", variant.axes.level));
    }
    if !scene.is_nearest() && (variant.axes.query == "point") != (scene.facts.query == "point") {
        return skip(row, format!("it answers another query than {}", scene.facts.query));
    }
    let Some(mut job) = scene.bind(variant) else {
        return skip(row, format!("it does not run on {}", scene.facts.workload));
    };
    let judgement = scene.judge(variant, job.as_mut());
    let hits = job.answers().iter().filter(|answer| answer.triangle.is_some()).count() as u64;
    put_accuracy(row, &judgement.accuracy);
    row.hits = Some(hits);
    row.outputs_hash = outputs_hash(job.as_mut());
    let inexact = !variant.claims_exactness();
    row.status = if inexact { "inexact" } else { "ok" }.into();
    match judgement.wrong {
        Some(reason) if !inexact => {
            row.status = "wrong-result".into();
            row.reason = reason;
            Err(true)
        }
        _ => {
            let contestant = Contestant::new(variant.id(), Role::Subject, job).with_hits(hits);
            Ok(contestant.with_limits(variant.lanes, least_cycles(variant)))
        }
    }
}

/// Says so where a set that is replayed may be, or was seen to be, more than the branch predictor
/// remembers of it between two turns of a kernel.
pub fn mark_forgotten(row: &mut Row, pairs_beyond: Option<usize>) {
    if let Some(times) = row.solo_ratio.filter(|times| *times > MOST_OVER_SOLO) {
        row.reason = format!("{times:.2} times the time alone: {BEYOND}");
    } else if let Some(pairs) = pairs_beyond {
        row.reason = format!("{pairs} pairs {BEYOND}");
    }
}

/// Time among others over time alone that is still put down to noise: the medians were within 3 %
/// of each other where nothing was forgotten, and 1.1 to 3 times apart where it was.
const MOST_OVER_SOLO: f64 = 1.1;

/// Said of rows in `fixed` order whose branches may not all be remembered.
pub const BEYOND: &str = "may be more than the branch predictor remembers: not purely `fixed`";

/// Whether replaying pairs with so many kernels in turn may be more than a predictor holds.
pub fn beyond_prediction(scene: &Scene, kernels: usize) -> bool {
    !scene.is_nearest() && scene.rays.len().saturating_mul(kernels) > PREDICTED_TESTS
}

/// Reference, placebo, empty loop and chain. A subject that is the reference is marked as such;
/// a reference or placebo that is not right about the scene is left out, like any other.
fn add_controls(contestants: &mut Vec<Contestant>, reference: &'static Variant, scene: &Scene) {
    let id = reference.id();
    if let Some(own) = contestants.iter_mut().find(|contestant| contestant.id == id) {
        own.role = Role::Reference;
    } else {
        contestants.extend(control(reference, Role::Reference, scene));
    }
    let copies = registry::placebos().iter().filter(|copy| copy.is_copy_of(reference));
    for copy in copies.take(PLACEBOS) {
        contestants.extend(control(copy, Role::Placebo, scene));
    }
    let yardsticks = contestants.first().map(|first| yardsticks(first.job.as_ref()));
    contestants.extend(yardsticks.into_iter().flatten());
}

/// A variant as a control; `None` if it cannot run here or is not right about the scene.
pub fn control(variant: &'static Variant, role: Role, scene: &Scene) -> Option<Contestant> {
    let mut row = blank("", variant, scene, Order::Fixed);
    let contestant = checked(variant, scene, &mut row).ok()?;
    Some(Contestant { role, ..contestant })
}

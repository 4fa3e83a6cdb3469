//! One cell: variants on one scene in one order. Checked, then measured together.

use std::sync::atomic::{AtomicBool, Ordering};

use super::keep::Keep;
use super::rows::{blank, put_figures, put_interrupted, put_judgement};
use super::run::Trouble;
use super::scene::Scene;
use crate::measure::{
    Chain, Clock, Contestant, Disturbance, EmptyLoop, Figures, GroupReport, Order, Progress,
    Protocol, ProtocolError, Role, Status, Surroundings, measure_group,
};
use crate::registry::{self, Variant};
use crate::table::Row;

/// A variant may be in one group with so many others: with the controls they stay within what a
/// branch predictor holds of a replayed set.
pub const MOST_SUBJECTS: usize = 12;

/// Copies of the reference in a group; several, since copies differ by where they lie.
const PLACEBOS: usize = 2;

/// Reference, placebos, empty loop and chain.
pub const CONTROLS: usize = 3 + PLACEBOS;

/// What a cell is measured with.
pub struct Bench<'a> {
    /// Rounds of every group.
    pub rounds: usize,
    /// Tells the time.
    pub clock: &'a mut dyn Clock,
    /// Tells whether a round was disturbed.
    pub disturbance: &'a mut dyn Disturbance,
    /// Called with the number of blocks done since it was last called.
    pub progress: &'a mut dyn FnMut(usize),
    /// Once true, nothing more is begun.
    pub cancel: &'a AtomicBool,
    /// Where rows go as soon as they are final.
    pub keep: &'a mut dyn Keep,
}

impl Bench<'_> {
    /// Measures a group in this many rounds and tells the progress.
    ///
    /// # Errors
    /// A group that cannot be measured.
    pub fn measure(
        &mut self,
        contestants: &mut [Contestant],
        order: Order,
        seed: u64,
    ) -> Result<GroupReport, ProtocolError> {
        let protocol = Protocol { rounds: self.rounds, ..Protocol::new(order, seed) };
        let mut done = 0;
        let mut tell = |progress: Progress| {
            (self.progress)(progress.done_blocks.saturating_sub(done));
            done = progress.done_blocks;
        };
        let mut surroundings = Surroundings {
            clock: self.clock,
            disturbance: self.disturbance,
            progress: &mut tell,
            cancel: self.cancel,
        };
        measure_group(contestants, &protocol, &mut surroundings)
    }
}

/// What came of a cell.
pub struct Measured {
    /// A row per variant, in their order.
    pub rows: Vec<Row>,
    /// The figures behind the rows that have any, by variant id, with their samples.
    pub figures: Vec<Figures>,
    /// Ids of variants that gave a wrong answer where they claim a right one.
    pub wrong: Vec<String>,
}

/// Runs a cell. Variants of levels that this processor lacks become rows with status `skipped`,
/// wrong ones rows with status `wrong-result`, and neither is timed. The rows of each group are
/// kept under the name `cell`; where that is `None`, whoever calls keeps the whole.
///
/// # Errors
/// A group that cannot be measured or kept.
pub fn run(
    experiment: &str,
    variants: &[&'static Variant],
    reference: &'static Variant,
    scene: &Scene,
    order: Order,
    bench: &mut Bench<'_>,
    cell: Option<&str>,
) -> Result<Measured, Trouble> {
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
    if let Some(cell) = cell.filter(|_| !bench.cancel.load(Ordering::Relaxed)) {
        let timed = |place: &usize| ready.iter().any(|(other, _)| other == place);
        let untimed: Vec<usize> = (0..measured.rows.len()).filter(|place| !timed(place)).collect();
        bench.keep_untimed(&format!("{cell}, not timed"), &untimed, &mut measured.rows)?;
    }
    for (number, group) in groups(ready, variants).into_iter().enumerate() {
        if bench.cancel.load(Ordering::Relaxed) {
            group.iter().for_each(|(place, _)| put_interrupted(&mut measured.rows[*place]));
            continue;
        }
        let piece = cell.map(|cell| format!("{cell}, group {number}"));
        time(group, reference, scene, order, bench, &mut measured, piece.as_deref())?;
    }
    Ok(measured)
}

/// Groups of at most [`MOST_SUBJECTS`], cut between kernels where that is possible, so that the
/// forms of a kernel are measured in the same rounds.
fn groups(
    ready: Vec<(usize, Contestant)>,
    variants: &[&'static Variant],
) -> Vec<Vec<(usize, Contestant)>> {
    let kernel = |place: usize| variants[place].axes.kernel;
    let mut left: Vec<usize> = ready.iter().map(|(place, _)| *place).collect();
    let mut groups: Vec<Vec<(usize, Contestant)>> = Vec::new();
    let mut room = 0;
    for (place, contestant) in ready {
        let begins = groups
            .last()
            .and_then(|group| group.last())
            .is_none_or(|(other, _)| kernel(*other) != kernel(place));
        let run = left.iter().take_while(|other| kernel(**other) == kernel(place)).count();
        if room == 0 || (begins && run > room && run <= MOST_SUBJECTS) {
            groups.push(Vec::new());
            room = MOST_SUBJECTS;
        }
        left.remove(0);
        room -= 1;
        if let Some(group) = groups.last_mut() {
            group.push((place, contestant));
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
    put_judgement(row, &judgement, hits);
    let inexact = !variant.claims_exactness();
    row.status = if inexact { "inexact" } else { "ok" }.into();
    match judgement.wrong {
        Some(reason) if !inexact => {
            row.status = "wrong-result".into();
            row.reason = reason;
            Err(true)
        }
        _ => Ok(Contestant::new(variant.id(), Role::Subject, job).with_hits(hits)),
    }
}

/// Measures one group and writes its figures into the rows, or takes the rows that were kept.
fn time(
    group: Vec<(usize, Contestant)>,
    reference: &'static Variant,
    scene: &Scene,
    order: Order,
    bench: &mut Bench<'_>,
    measured: &mut Measured,
    piece: Option<&str>,
) -> Result<(), Trouble> {
    let (places, mut contestants): (Vec<usize>, Vec<Contestant>) = group.into_iter().unzip();
    if let Some(piece) = piece
        && bench.take_back(piece, &places, &mut measured.rows)?
    {
        bench.pass_over(places.len());
        return Ok(());
    }
    add_controls(&mut contestants, reference, scene);
    let subjects = contestants.len();
    let report = bench.measure(&mut contestants, order, scene.facts.seed)?;
    for (place, figures) in places.iter().zip(report.figures) {
        let row = &mut measured.rows[*place];
        let ok = std::mem::take(&mut row.status);
        put_figures(row, &figures, &ok);
        if figures.status == Status::Ok {
            row.ratio_placebo = report.placebo_floor.map(f64::exp);
            row.empty_loop_share = figures.empty_loop_ratio;
            if order == Order::Fixed && beyond_prediction(scene, subjects) {
                row.reason = format!("{subjects} kernels x {} pairs {BEYOND}", scene.rays.len());
            }
        }
        measured.figures.push(figures);
    }
    // The rows of this group are final now, if nothing cut its measuring short.
    if let Some(piece) = piece.filter(|_| !bench.cancel.load(Ordering::Relaxed)) {
        bench.keep_piece(piece, &places, &measured.rows)?;
    }
    Ok(())
}

/// Tests that a predictor is sure to hold of a replayed set: what one core of 2025 held, as long as
/// nobody has measured this machine's.
const PREDICTED_TESTS: usize = 16_000;

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
    if let Some(first) = contestants.first() {
        let empty = EmptyLoop::like(first.job.as_ref());
        contestants.push(Contestant::new("empty loop", Role::Empty, Box::new(empty)));
    }
    contestants.push(Contestant::new("chain", Role::Chain, Box::new(Chain::default())));
}

fn control(variant: &'static Variant, role: Role, scene: &Scene) -> Option<Contestant> {
    let mut row = blank("", variant, scene, Order::Fixed);
    let contestant = checked(variant, scene, &mut row).ok()?;
    Some(Contestant { role, ..contestant })
}

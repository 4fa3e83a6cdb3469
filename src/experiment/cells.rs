//! One cell: variants on one scene in one order. Checked, then measured together.

use std::sync::atomic::AtomicBool;

use super::rows::{blank, put_figures, put_judgement};
use super::scene::Scene;
use crate::measure::{
    Chain, Clock, Contestant, Disturbance, EmptyLoop, Figures, Order, Progress, Protocol,
    ProtocolError, Role, Surroundings, measure_group,
};
use crate::registry::{self, Variant};
use crate::table::Row;

/// A variant may be in one group with so many others: with the controls they stay within what a
/// branch predictor holds of a replayed set.
pub const MOST_SUBJECTS: usize = 12;

/// Reference, placebo, empty loop and chain.
pub const CONTROLS: usize = 4;

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

/// Kernels that claim no exactness; their wrong decisions are counted, and they are timed.
const INEXACT: &[&str] = &["angle-sum"];

/// Runs a cell. Variants of levels that this processor lacks become rows with status `skipped`,
/// wrong ones rows with status `wrong-result`, and neither is timed.
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
) -> Result<Measured, ProtocolError> {
    let mut measured = Measured { rows: Vec::new(), figures: Vec::new(), wrong: Vec::new() };
    let mut ready: Vec<(usize, Contestant)> = Vec::new();
    for variant in variants {
        let mut row = blank(experiment, variant, scene, order);
        match checked(variant, scene, &mut row) {
            Ok(contestant) => ready.push((measured.rows.len(), contestant)),
            Err(is_wrong) if is_wrong => measured.wrong.push(variant.id()),
            Err(_) => {}
        }
        measured.rows.push(row);
    }
    while !ready.is_empty() {
        let rest = ready.split_off(ready.len().min(MOST_SUBJECTS));
        let group = std::mem::replace(&mut ready, rest);
        time(group, reference, scene, order, bench, &mut measured)?;
    }
    Ok(measured)
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
    let inexact = INEXACT.contains(&variant.axes.kernel);
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

/// Measures one group and writes its figures into the rows.
fn time(
    group: Vec<(usize, Contestant)>,
    reference: &'static Variant,
    scene: &Scene,
    order: Order,
    bench: &mut Bench<'_>,
    measured: &mut Measured,
) -> Result<(), ProtocolError> {
    let (places, mut contestants): (Vec<usize>, Vec<Contestant>) = group.into_iter().unzip();
    add_controls(&mut contestants, reference, scene);
    let protocol = Protocol { rounds: bench.rounds, ..Protocol::new(order, scene.facts.seed) };
    let mut done = 0;
    let mut tell = |progress: Progress| {
        (bench.progress)(progress.done_blocks.saturating_sub(done));
        done = progress.done_blocks;
    };
    let report = measure_group(
        &mut contestants,
        &protocol,
        &mut Surroundings {
            clock: bench.clock,
            disturbance: bench.disturbance,
            progress: &mut tell,
            cancel: bench.cancel,
        },
    )?;
    for (place, figures) in places.into_iter().zip(report.figures) {
        let row = &mut measured.rows[place];
        let ok = std::mem::take(&mut row.status);
        put_figures(row, &figures, &ok);
        row.ratio_placebo = report.placebo_floor.map(f64::exp);
        measured.figures.push(figures);
    }
    Ok(())
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
    if id == registry::REFERENCE {
        contestants.extend(
            registry::placebos().first().and_then(|copy| control(copy, Role::Placebo, scene)),
        );
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

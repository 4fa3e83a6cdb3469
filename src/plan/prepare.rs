//! What preparing a triangle costs, and from how many tests on it pays.

use super::contest::{Timed, form};
use super::evidence::Saving;
use super::situation::Preparing;
use crate::experiment::{Bench, Cost, Costs, Trouble, crossing};
use crate::measure::{Contestant, Figures, Order, Role, yardsticks};
use crate::registry::Variant;
use crate::workload::Triangle;

/// Preparing of what variants store, by what is stored.
#[derive(Default)]
pub struct Stores(Vec<(String, Cost)>);

impl Stores {
    /// Preparing a triangle for a variant, ns; what stores the vertices prepares nothing.
    pub fn of(&self, variant: &Variant) -> Option<Cost> {
        if variant.axes.stored == "vertices" {
            return Some(Cost::default());
        }
        let wanted = store(variant);
        self.0.iter().find(|(store, _)| *store == wanted).map(|(_, cost)| *cost)
    }
}

/// What a variant stores, in words.
fn store(variant: &Variant) -> String {
    let axes = &variant.axes;
    format!("{} {} {}", axes.kernel, axes.stored, axes.precision)
}

/// Times the preparing of what the variants store, side by side.
///
/// # Errors
/// A group that cannot be measured.
pub fn time(
    variants: &[&'static Variant],
    triangles: &[Triangle],
    seed: u64,
    bench: &mut Bench<'_>,
) -> Result<Stores, Trouble> {
    let mut contestants: Vec<Contestant> = Vec::new();
    for variant in variants.iter().filter(|variant| variant.axes.stored != "vertices") {
        let id = store(variant);
        if contestants.iter().all(|other| other.id != id)
            && let Some(bind) = variant.preparing
        {
            contestants.push(Contestant::new(id, Role::Subject, bind(triangles)));
        }
    }
    let Some(first) = contestants.first() else { return Ok(Stores::default()) };
    let yardsticks = yardsticks(first.job.as_ref());
    contestants.extend(yardsticks);
    let report = bench.measure(&mut contestants, Order::Fixed, seed)?;
    let of = |figures: &Figures| Some((figures.id.clone(), cost(figures)?));
    Ok(Stores(report.figures.iter().filter_map(of).collect()))
}

/// Median and interval of a time, ns.
fn cost(figures: &Figures) -> Option<Cost> {
    Some(Cost { median: figures.ns_per_test?, low: figures.ns_low?, high: figures.ns_high? })
}

/// The fastest test that prepares beside the fastest that does not, of those that were timed together.
pub fn worth(
    timed: &Timed,
    variants: &[&'static Variant],
    stores: &Stores,
    tests_per_triangle: f64,
) -> Option<Preparing> {
    let fastest = |prepares: bool| {
        let of = |variant: &&'static Variant| {
            let figures = timed.of(&variant.id())?;
            let costs = Costs { prepare: stores.of(variant)?, test: cost(figures)? };
            (form(variant)?.prepares == prepares).then_some((*variant, figures, costs))
        };
        let by_test = |a: &Costs, b: &Costs| a.test.median.total_cmp(&b.test.median);
        variants.iter().filter_map(of).min_by(|a, b| by_test(&a.2, &b.2))
    };
    let (variant, with, own) = fastest(true)?;
    let (_, without, other) = fastest(false)?;
    let share = own.prepare.median / tests_per_triangle;
    let prepared: Vec<f64> = with.samples.iter().map(|ns| ns + share).collect();
    Some(Preparing {
        with: variant.id(),
        prepare_ns: own.prepare.median,
        pays_from: crossing(own, other).map(|crossing| crossing.rays),
        saving: Saving::of(&without.samples, &prepared, timed.floor),
    })
}

//! Which of all forms are worth a closer look, and these as the choice sees them.

use super::contest::{Timed, form};
use super::form::Form;
use super::pieces::PIECES;
use super::settle::{Entry, Finals};
use crate::experiment::cells::MOST_SUBJECTS;
use crate::registry::Variant;

/// So many of the forms that waste least go on.
const LEAST: usize = 4;
/// So many of the fastest forms go on.
const FASTEST: usize = 3;

/// A form of the heats.
struct Ranked {
    /// Time beside the reference's, with its share of preparing.
    cost: f64,
    form: Form,
    variant: &'static Variant,
}

/// Forms of the heats that go on to the finals, no more than can be timed together: the default, the
/// fastest of those that waste least, the fastest of all, and of those that leave out, or do, each piece.
/// `share` is what preparing adds to a test, ns; `waste` counts what a form need not do.
pub fn finalists(
    heats: &Timed,
    variants: &[&'static Variant],
    default: &'static Variant,
    share: &dyn Fn(&Variant) -> f64,
    waste: &dyn Fn(&Form) -> usize,
) -> Vec<&'static Variant> {
    let fastest = ranked(heats, variants, share);
    let mut least: Vec<&Ranked> = fastest.iter().collect();
    // Stable: of those that waste as little, the fastest come first.
    least.sort_by_key(|one| waste(&one.form));
    let mut order: Vec<&'static Variant> = vec![default];
    order.extend(least.iter().take(LEAST).map(|one| one.variant));
    order.extend(fastest.iter().take(FASTEST).map(|one| one.variant));
    for done_by in PIECES.iter().filter_map(|piece| piece.done_by) {
        for wanted in [true, false] {
            let first = least.iter().find(|one| done_by(&one.form) == wanted);
            order.extend(first.map(|one| one.variant));
        }
    }
    let mut finals: Vec<&'static Variant> = Vec::new();
    for variant in order {
        let is_new = !finals.iter().any(|other| std::ptr::eq(*other, variant));
        if is_new && finals.len() < MOST_SUBJECTS {
            finals.push(variant);
        }
    }
    finals.sort_by_key(|variant| variant.axes.kernel);
    finals
}

/// The forms that were timed, the fastest first.
fn ranked(
    heats: &Timed,
    variants: &[&'static Variant],
    share: &dyn Fn(&Variant) -> f64,
) -> Vec<Ranked> {
    let one = |variant: &&'static Variant| {
        let figures = heats.of(&variant.id())?;
        // Between groups only the ratio to the reference can be compared.
        let ratio = figures.ratio_to_reference.map_or(1.0, |ratio| ratio.estimate);
        let cost = ratio * (1.0 + share(variant) / figures.ns_per_test?);
        Some(Ranked { cost, form: form(variant)?, variant })
    };
    let mut ranked: Vec<Ranked> = variants.iter().filter_map(one).collect();
    ranked.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    ranked
}

/// The finals as the choice sees them; `None` where the default could not be timed.
pub fn finals(
    timed: &Timed,
    variants: &[&'static Variant],
    default: &'static Variant,
    share: &dyn Fn(&Variant) -> f64,
) -> Option<Finals> {
    let entry = |variant: &&'static Variant| {
        let times = with_share(timed, variant, share)?;
        Some(Entry { form: form(variant)?, times, again: None })
    };
    let entries: Vec<Entry> = variants.iter().filter_map(entry).collect();
    let default = entries.iter().position(|entry| entry.form.id == default.id())?;
    Some(Finals { entries, default, floor: timed.floor })
}

/// Times of a test in each round, ns, each with its share of preparing.
pub fn with_share(
    timed: &Timed,
    variant: &Variant,
    share: &dyn Fn(&Variant) -> f64,
) -> Option<Vec<f64>> {
    let share = share(variant);
    Some(timed.of(&variant.id())?.samples.iter().map(|ns| ns + share).collect())
}

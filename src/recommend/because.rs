//! The sentences that say why.

use super::arena::{Arena, Ranked};
use super::evidence::Leaks;
use super::found::{Cost, Found, folders};
use super::place::{counted, figure, percent, place, setting};
use super::settings::{elsewhere, without};
use serde_json::Value;

/// Everything that speaks for the variant, with figures and rows, the weightiest first.
pub(super) fn sentences(found: &Found<'_>) -> Vec<String> {
    let all = [
        Some(fastest(found)),
        next(found),
        other_kernel(found),
        Some(order(found)),
        scale(found),
        other_precision(found),
        preparing(found),
        watertight(found),
        tolerance(found),
        elsewhere(found),
        without(found),
        (!found.left_out.is_empty()).then(|| format!("Left out: {}.", found.left_out)),
    ];
    all.into_iter().flatten().collect()
}

/// `[h-7, nearest-random, reshuffled]`
fn at(one: &Ranked<'_>) -> String {
    format!("[{}]", place(one.candidate.row))
}

fn fastest(found: &Found<'_>) -> String {
    let (best, arena) = (found.best(), found.arena());
    let row = best.candidate.row;
    let mut figures = Vec::new();
    if let (Some(ratio), Some(low), Some(high)) =
        (row.ratio_to_reference, row.ratio_low, row.ratio_high)
    {
        let reference = arena.reference(row).map_or("the reference", |row| &row.id);
        figures.push(format!(
            "{} of the time of {reference} ({} to {})",
            figure(ratio),
            figure(low),
            figure(high)
        ));
    }
    figures.extend(row.cycles_per_test.map(|cycles| format!("{} cycles", figure(cycles))));
    figures.extend(row.ns_per_test.map(|ns| format!("{} ns a test", figure(ns))));
    let which = match arena.ranked.len() {
        1 => "the only form that fits".to_owned(),
        forms => format!(
            "the fastest of {forms} forms of {} that fit",
            counted(arena.kernels(), "kernel")
        ),
    };
    format!("{} takes {}: {which} {}.", row.id, figures.join(", "), at(best))
}

fn costs(other: &Ranked<'_>, best: &Ranked<'_>) -> String {
    let cost = Cost::of(other, best);
    let (share, interval) =
        (percent(cost.share), format!("{} to {}", percent(cost.low), percent(cost.high)));
    if cost.is_measurable {
        return format!("costs {share} ({interval})");
    }
    let floor = figure(cost.floor * 100.0);
    if cost.low > 0.0 {
        format!(
            "costs nothing that can be measured ({share}, {interval}; copies of one kernel differ \
             by {floor} %)"
        )
    } else {
        format!("costs nothing that can be measured ({share}, {interval})")
    }
}

fn next(found: &Found<'_>) -> Option<String> {
    let Some(next) = found.arena().ranked.get(1) else {
        return Some("Nothing else that was timed there fits.".to_owned());
    };
    Some(format!(
        "The next best, {}, {} {}.",
        next.candidate.row.id,
        costs(next, found.best()),
        at(next)
    ))
}

/// What the best form of another kernel costs, where the next best is of the same one.
fn other_kernel(found: &Found<'_>) -> Option<String> {
    let (_, other) = found.other_kernel().filter(|(place, _)| *place > 1)?;
    let (id, costs) = (&other.candidate.row.id, costs(other, found.best()));
    Some(format!("The best of another kernel, {id}, {costs} {}.", at(other)))
}

fn order(found: &Found<'_>) -> String {
    let row = found.arena().row();
    let needs = found.question.needs.word();
    let why = match row.order.as_str() {
        "reshuffled" => "every pass in a new order, so that no outcome can be foreseen",
        "fixed" => "outcomes that a branch predictor may know by heart; no order reshuffled fits",
        _ => "each pair many times in a row, every branch foreseen; no other order fits",
    };
    format!("Ranked by [{}]: {why}. Needed: {needs}.", setting(row))
}

fn scale(found: &Found<'_>) -> Option<String> {
    let experiments = found.arena().experiments();
    let apart = found.arena().apart.len();
    let mut sentence = format!(
        "Experiments {} time the same rays and triangles; they are brought to one scale by the forms \
         that they share.",
        experiments.join(", ")
    );
    if apart > 0 {
        sentence += &format!(" {} timed apart are not ranked.", counted(apart, "form"));
    }
    (experiments.len() > 1 || apart > 0).then_some(sentence)
}

fn other_precision(found: &Found<'_>) -> Option<String> {
    if found.question.precision.is_some() {
        return None;
    }
    let precision = &found.best().candidate.row.precision;
    let asked = format!("Either precision was allowed (--precision decides); this is {precision}.");
    // Where both were timed, the best of the two against each other.
    let best_in = |arena: &'_ Arena<'_>, is_own: bool| {
        let is_it = |one: &&Ranked<'_>| (one.candidate.row.precision == *precision) == is_own;
        arena.ranked.iter().position(|one| is_it(&one))
    };
    let both = found.arenas.iter().find_map(|arena| {
        let (own, other) = (best_in(arena, true)?, best_in(arena, false)?);
        Some((&arena.ranked[own], &arena.ranked[other]))
    });
    let Some((own, other)) = both else {
        return Some(format!("{asked} Nowhere do forms of both fit."));
    };
    let row = other.candidate.row;
    Some(format!(
        "{asked} The best in {}, {}, {} over {} {}.",
        row.precision,
        row.id,
        costs(other, own),
        own.candidate.row.id,
        at(other)
    ))
}

fn preparing(found: &Found<'_>) -> Option<String> {
    let rays = found.question.rays_per_triangle?;
    let row = found.best().candidate.row;
    let over = format!("With {} per triangle", counted(usize::try_from(rays).ok()?, "ray"));
    if let (Some(preparing), Some(test)) = (found.best().candidate.preparing, row.cycles_per_test) {
        let cycles = preparing.cycles[0];
        let total = cycles / rays as f64 + test;
        return Some(format!(
            "{over}, preparing ({} cycles, {} [{}]) and testing cost {} cycles a ray.",
            figure(cycles),
            preparing.row.id,
            place(preparing.row),
            figure(total)
        ));
    }
    Some(match (found.tells_preparing, row.stored == "vertices") {
        (true, _) => format!("{over} it has nothing to prepare."),
        (false, true) => format!(
            "{over} it cannot lose by preparing, since it stores the corners as they come; what \
             preparing costs is not among the rows (experiment precompute)."
        ),
        (false, false) => format!(
            "{over} preparing is taken to cost nothing: what it does cost is not among the rows \
             (experiment precompute)."
        ),
    })
}

fn watertight(found: &Found<'_>) -> Option<String> {
    let kernel = &found.best().candidate.row.kernel;
    Some(match found.best().candidate.leaks? {
        Leaks::Counted(_, rays, row) => format!(
            "{kernel} is watertight, and lost none of {rays} rays at closed meshes ({} [{}]).",
            row.id,
            place(row)
        ),
        _ => format!(
            "{kernel} is watertight by its construction; no row counts the rays that it loses \
             (`ray_test stability` makes them)."
        ),
    })
}

fn tolerance(found: &Found<'_>) -> Option<String> {
    let (error, row) = found.best().candidate.error?;
    let tolerance = found.question.tolerance?;
    Some(format!(
        "One hit in a hundred errs by more than {} in a weight, {} are allowed ({} [{}]).",
        figure(error),
        figure(tolerance),
        row.id,
        place(row)
    ))
}

/// Where the rows are from, and what they were measured on.
pub(super) fn measured_on(found: &Found<'_>) -> String {
    let folders = folders(found.results);
    let sources = found.results.sources.iter();
    let facts = sources.filter_map(|source| {
        let text = |pointer: &str| source.environment.pointer(pointer).and_then(Value::as_str);
        let (processor, date) = (text("/machine/processor")?, text("/date").unwrap_or_default());
        Some(format!(" on {processor}, {date}").trim_end_matches([',', ' ']).to_owned())
    });
    format!("Rows from {folders}, measured{}.", facts.collect::<Vec<_>>().join(" and"))
}

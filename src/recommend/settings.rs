//! What the other arenas say of the variant that one arena chose.

use super::arena::Ranked;
use super::found::{Cost, Found};
use super::place::{counted, figure, percent, place};

/// So many settings are named where another form is ahead.
const MOST_NAMED: usize = 3;

/// Whether the choice holds where other rays, densities or orders were timed: a sentence, or none
/// if the variant was timed nowhere else beside others.
pub(super) fn elsewhere(found: &Found<'_>) -> Option<String> {
    let id = &found.best().candidate.row.id;
    let others = found.arenas.iter().skip(1).filter(|arena| arena.ranked.len() > 1);
    let others = others.filter_map(|arena| Some((&arena.ranked[0], arena.find(id)?)));
    let others: Vec<(&Ranked<'_>, Cost)> =
        others.map(|(first, own)| (first, Cost::of(own, first))).collect();
    if others.is_empty() {
        return None;
    }
    let mut behind: Vec<&(&Ranked<'_>, Cost)> =
        others.iter().filter(|(_, cost)| cost.is_measurable).collect();
    let total = counted(others.len(), "other setting");
    if behind.is_empty() {
        return Some(format!("It is the fastest, or level with it, in {total} as well."));
    }
    behind.sort_by(|a, b| b.1.share.total_cmp(&a.1.share));
    let named = behind.iter().take(MOST_NAMED).map(|(first, cost)| {
        let row = first.candidate.row;
        format!("{} over {} [{}]", percent(cost.share), row.id, place(row))
    });
    let named: Vec<String> = named.collect();
    Some(format!(
        "The ranking depends on the setting: in {} of {total} another form is faster; there it costs {}.",
        behind.len(),
        named.join("; ")
    ))
}

/// What leads where the variant was not timed, on other rays and triangles of the same kind in the
/// same order: a sentence, or none.
pub(super) fn without(found: &Found<'_>) -> Option<String> {
    let best = found.best().candidate.row;
    let others = found.arenas.iter().skip(1).filter(|arena| {
        let row = arena.row();
        let alike = (&row.workload, &row.order) == (&best.workload, &best.order);
        alike && arena.ranked.len() > 1 && arena.find(&best.id).is_none()
    });
    let named = others.take(MOST_NAMED).map(|arena| {
        let row = arena.row();
        let ratio = row.ratio_to_reference.zip(arena.reference(row));
        let ratio = ratio.map(|(ratio, reference)| {
            format!(" with {} of the time of {}", figure(ratio), reference.id)
        });
        format!("{}{} [{}]", row.id, ratio.unwrap_or_default(), place(row))
    });
    let named: Vec<String> = named.collect();
    let sentence =
        format!("On other triangles, where it was not timed, the fastest is {}.", named.join("; "));
    (!named.is_empty()).then_some(sentence)
}

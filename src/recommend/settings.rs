//! What the other arenas say of the variant that one arena chose.

use super::answer::{Cost, Found};
use super::arena::Ranked;
use super::place::{counted, percent, place};

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

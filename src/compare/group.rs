//! What the rows of a group say together.

use std::collections::HashMap;

use super::side::Side;
use super::time::{halves, is_reference, ln_quotient, positive, stands};
use crate::stats::median;
use crate::table::Row;

/// Experiment, workload, order, density (bits), and the listing where a row is about one of its
/// codes: there each listing is measured against its own code 0.
type Group = (String, String, String, Option<u64>, String);

fn group(row: &Row) -> Group {
    let listing = if row.code.is_some() { row.id.clone() } else { String::new() };
    let density = row.density.map(f64::to_bits);
    (row.experiment.clone(), row.workload.clone(), row.order.clone(), density, listing)
}

/// How the references of two sides relate, and what stood beside them, group by group.
pub(super) struct References {
    /// Cycles per test of the reference, in the base and in the new side.
    cycles: [HashMap<Group, f64>; 2],
    /// Rows that both sides have and that are not the reference.
    others: HashMap<Group, Others>,
}

/// ln of what became of the rows of a group, new over base: one each.
#[derive(Default)]
struct Others {
    cycles: Vec<f64>,
    /// Ratios to the reference, by either half of the rounds.
    halves: [Vec<f64>; 2],
}

impl References {
    /// Of two sides and the rows that both have.
    pub fn of(base: &Side, new: &Side, pairs: &[(&Row, &Row)]) -> Self {
        References { cycles: [cycles(base), cycles(new)], others: others(pairs) }
    }

    /// ln of what a row's reference became in cycles, new over base.
    pub fn drift(&self, row: &Row) -> Option<f64> {
        let [base, new] = self.cycles.each_ref().map(|cycles| cycles.get(&group(row)));
        Some(new?.ln() - base?.ln())
    }

    /// Whether a group was measured on a machine in the same state, as far as that shows: its
    /// reference, or the middle one of its other rows, takes as many cycles as before, within
    /// `threshold` (ln). For the reference itself only the others can tell.
    pub fn steady(&self, row: &Row, threshold: f64) -> bool {
        let others = self.others.get(&group(row)).and_then(|others| median(&others.cycles));
        let reference = if is_reference(row) { None } else { self.drift(row) };
        let mut known = [reference, others].into_iter().flatten().peekable();
        known.peek().is_none() || known.any(|drift| drift.abs() <= threshold)
    }

    /// ln of what a row that is the reference itself became in terms of the others, by either half
    /// of the rounds. `None` where it has no others.
    pub fn against_others(&self, row: &Row) -> Option<(f64, f64)> {
        let [first, second] = &self.others.get(&group(row))?.halves;
        Some((-median(first)?, -median(second)?))
    }
}

/// The reference may be no row; each row tells of it. A group of many rows was measured in several
/// parts, each with the reference in it; the median is the reference of all.
fn cycles(side: &Side) -> HashMap<Group, f64> {
    let mut cycles: HashMap<Group, Vec<f64>> = HashMap::new();
    for row in side.rows().filter(|row| stands(row) && row.price.is_none()) {
        let figures = (positive(row.cycles_per_test), positive(row.ratio_to_reference));
        if let (Some(own), Some(ratio)) = figures {
            cycles.entry(group(row)).or_default().push(own / ratio);
        }
    }
    cycles.into_iter().filter_map(|(group, all)| Some((group, median(&all)?))).collect()
}

fn others(pairs: &[(&Row, &Row)]) -> HashMap<Group, Others> {
    let mut others: HashMap<Group, Others> = HashMap::new();
    for (base, new) in pairs {
        if !stands(base) || !stands(new) || base.price.is_some() || is_reference(base) {
            continue;
        }
        let of_group = others.entry(group(new)).or_default();
        of_group.cycles.extend(ln_quotient(base.cycles_per_test, new.cycles_per_test));
        if let Some((first, second)) = halves(base, new) {
            of_group.halves[0].push(first);
            of_group.halves[1].push(second);
        }
    }
    others
}

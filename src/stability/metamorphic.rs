//! The same cases again, transformed so that no decision may change: checks without an oracle.

use super::draw::Draw;
use super::families::{find, near_edge};
use super::family::{Family, Transform, Work, segment_of};
use super::forms::Form;
use super::precision::power_of_two;
use super::rows;
use super::sweep::Setting;
use crate::oracle::Query;
use crate::table::Row;
use std::sync::atomic::{AtomicBool, Ordering};

/// The rows of a setting: one a form. `None` once cancelled, which is looked at before every form.
pub fn rows_of(
    family: &Family,
    transform: Transform,
    setting: &Setting,
    forms: &[Form],
    cancel: &AtomicBool,
) -> Option<Vec<Row>> {
    let mut draw = Draw::new(setting.seed, family.id, setting.knob, setting.precision);
    let queries: Vec<Query> =
        (0..setting.count).map(|_| query(transform, &mut draw, setting.knob)).collect();
    let usual = |form: &&Form| form.precision == setting.precision && !form.flushes();
    let row = |form: &Form| {
        if cancel.load(Ordering::Relaxed) {
            return None;
        }
        let mut row = rows::of_setting(family, setting, form);
        put(&mut row, form, &queries, (transform, setting.knob), &draw);
        Some(row)
    };
    forms.iter().filter(usual).map(row).collect()
}

/// Benign cases to be scaled, cases near an edge to be turned.
fn query(transform: Transform, draw: &mut Draw, knob: f64) -> Query {
    let hit = draw.chance(0.5);
    match (transform, find("benign").map(|family| family.work)) {
        (Transform::Scale, Some(Work::Aimed(benign))) => benign(draw, 0.0, hit),
        _ => near_edge(draw, knob, hit),
    }
}

fn put(row: &mut Row, form: &Form, queries: &[Query], how: (Transform, f64), draw: &Draw) {
    let (mut hits, mut decisions, mut weights) = (0, 0, 0);
    for query in queries {
        let query = if form.asked.is_segment { segment_of(query, draw) } else { *query };
        let before = (form.asked.ask)(&query);
        let after = (form.asked.ask)(&transformed(&query, how));
        let same_bits = |a: f64, b: f64| a.to_bits() == b.to_bits();
        hits += u64::from(before.triangle.is_some());
        if before.triangle != after.triangle {
            decisions += 1;
        } else if before.triangle.is_some() {
            let same = same_bits(before.u, after.u) && same_bits(before.v, after.v);
            weights += u64::from(!same);
        }
    }
    row.cases = Some(queries.len() as u64);
    row.hits = Some(hits);
    row.metamorphic_decisions = Some(decisions);
    // A turn changes what u and v are, or the order in which they are summed.
    row.metamorphic_uv = (how.0 == Transform::Scale).then_some(weights);
}

fn transformed(query: &Query, (transform, knob): (Transform, f64)) -> Query {
    let each = |change: &dyn Fn([f64; 3]) -> [f64; 3]| Query {
        origin: change(query.origin),
        direction: change(query.direction),
        end: query.end.map(&change),
        triangle: query.triangle.map(&change),
        ..*query
    };
    match transform {
        Transform::Scale => each(&|p| p.map(|x| x * power_of_two(knob as i32))),
        Transform::Axes => each(&|[x, y, z]| [z, x, y]),
        Transform::Vertices => {
            let [a, b, c] = query.triangle;
            Query { triangle: [b, c, a], ..*query }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::classify;
    use crate::stability::Precision;

    #[test]
    fn no_transform_changes_the_exact_answer() {
        let mut draw = Draw::new(1, "test", 0.0, Precision::F32);
        for _ in 0..300 {
            let hit = draw.chance(0.5);
            let query = near_edge(&mut draw, 4.0, hit);
            for how in
                [(Transform::Scale, 20.0), (Transform::Axes, 0.0), (Transform::Vertices, 0.0)]
            {
                let after = transformed(&query, how);
                assert_eq!(classify(&query), classify(&after));
                assert_ne!(query, after);
            }
        }
    }
}

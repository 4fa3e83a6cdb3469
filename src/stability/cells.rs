//! One setting of a family's knob: every form on the same cases.

use super::asking::found;
use super::draw::Draw;
use super::family::{Case, Family};
use super::forms::Form;
use super::precision::Precision;
use super::rows;
use super::sweep::Setting;
use crate::table::Row;
use std::sync::atomic::{AtomicBool, Ordering};

/// Cases that are drawn between two looks at whether it is cancelled.
const CASES_AT_ONCE: usize = 1_000;

/// Condition numbers of the hits of a setting: what rounding the inputs alone may do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Conditioning {
    /// 99th percentile of the condition number of t relative to t.
    pub t_p99: Option<f64>,
    /// 99th percentile of the largest absolute condition number of a weight.
    pub weights_p99: Option<f64>,
}

/// The rows of one setting: one a form. Forms that flush subnormal numbers are asked in families
/// of small numbers alone. `None` once cancelled, which is looked at while cases are drawn and before
/// every form.
pub fn rows_of(
    family: &Family,
    setting: &Setting,
    forms: &[Form],
    cancel: &AtomicBool,
) -> Option<Vec<Row>> {
    let precision = setting.precision;
    let is_small = ["tiny", "subnormal"].contains(&family.id);
    let forms: Vec<&Form> = forms
        .iter()
        .filter(|form| form.precision == precision && (is_small || !form.flushes()))
        .collect();
    let segments = forms.iter().any(|form| form.asked.is_segment);
    let cases = drawn(family, setting, segments, cancel)?;
    let attained = cases.iter().filter(|case| case.attained).count();
    let share = attained as f64 / cases.len().max(1) as f64;
    let conditioning = conditioning(&cases);
    let row = |form: &&Form| {
        if cancel.load(Ordering::Relaxed) {
            return None;
        }
        let mut row = rows::of_setting(family, setting, form);
        rows::put_conditioning(&mut row, conditioning);
        let (ask, is_segment) = (form.asked.ask, form.asked.is_segment);
        rows::put_found(&mut row, &found(ask, is_segment, form.reported(), &cases));
        row.attained_share = Some(share);
        Some(row)
    };
    forms.iter().map(row).collect()
}

/// The cases of a setting, the same as if they were drawn in one go; `None` once cancelled.
fn drawn(
    family: &Family,
    setting: &Setting,
    segments: bool,
    cancel: &AtomicBool,
) -> Option<Vec<Case>> {
    let mut draw = Draw::new(setting.seed, family.id, setting.knob, setting.precision);
    let mut cases = Vec::new();
    for first in (0..setting.count).step_by(CASES_AT_ONCE) {
        if cancel.load(Ordering::Relaxed) {
            return None;
        }
        let number = CASES_AT_ONCE.min(setting.count - first);
        cases.extend(family.cases(&mut draw, setting.knob, number, segments));
    }
    Some(cases)
}

/// The rows of one setting of a family of single cases; none of other families, and none once
/// cancelled. `seed` and `count` are those of the cases.
pub fn errors_at(
    (family, knob): (&Family, f64),
    precision: Precision,
    (seed, count): (u64, usize),
    forms: &[Form],
    cancel: &AtomicBool,
) -> Vec<Row> {
    let setting = Setting { precision, knob, seed, count, class: None };
    rows_of(family, &setting, forms, cancel).unwrap_or_default()
}

fn conditioning(cases: &[Case]) -> Conditioning {
    let hits = || cases.iter().map(|case| &case.truth).filter(|truth| truth.exact.class.is_hit());
    let t = hits().map(|truth| truth.condition.kappa_t / truth.exact.t.abs());
    let weights = hits().map(|truth| {
        let kappa = &truth.condition;
        kappa.kappa_u.max(kappa.kappa_v).max(kappa.kappa_w)
    });
    Conditioning { t_p99: p99(t.collect()), weights_p99: p99(weights.collect()) }
}

/// The 99th percentile of the finite values, to the nearest rank.
fn p99(mut values: Vec<f64>) -> Option<f64> {
    values.retain(|value| value.is_finite());
    values.sort_unstable_by(f64::total_cmp);
    let last = values.len().checked_sub(1)?;
    values.get((last as f64 * 0.99).round() as usize).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::Query;
    use crate::stability::find;

    #[test]
    fn cases_are_the_same_as_in_one_go_and_none_once_cancelled() {
        let family = find("grazing").expect("it is one");
        let (precision, knob, seed) = (Precision::F32, 1.0, 3);
        let count = 2 * CASES_AT_ONCE + 1;
        let setting = Setting { precision, knob, seed, count, class: None };
        let queries = |cases: Vec<Case>| -> Vec<Query> {
            cases.into_iter().map(|case| case.truth.query).collect()
        };
        let drawn =
            |cancel: bool| drawn(&family, &setting, false, &AtomicBool::new(cancel)).map(queries);
        let mut draw = Draw::new(seed, family.id, knob, precision);
        assert_eq!(drawn(false), Some(queries(family.cases(&mut draw, knob, count, false))));
        assert_eq!(drawn(true), None);
    }
}

//! One setting of a family's knob: every form on the same cases.

use super::asking::found;
use super::draw::Draw;
use super::family::{Case, Family};
use super::forms::Form;
use super::precision::Precision;
use super::rows;
use super::sweep::Setting;
use crate::table::Row;

/// Condition numbers of the hits of a setting: what rounding the inputs alone may do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Conditioning {
    /// 99th percentile of the condition number of t relative to t.
    pub t_p99: Option<f64>,
    /// 99th percentile of the largest absolute condition number of a weight.
    pub weights_p99: Option<f64>,
}

/// The rows of one setting: one a form. Forms that flush subnormal numbers are asked in families
/// of small numbers alone.
pub fn rows_of(family: &Family, setting: &Setting, forms: &[Form]) -> Vec<Row> {
    let precision = setting.precision;
    let is_small = ["tiny", "subnormal"].contains(&family.id);
    let forms: Vec<&Form> = forms
        .iter()
        .filter(|form| form.precision == precision && (is_small || !form.flushes()))
        .collect();
    let segments = forms.iter().any(|form| form.asked.is_segment);
    let mut draw = Draw::new(setting.seed, family.id, setting.knob, precision);
    let cases = family.cases(&mut draw, setting.knob, setting.count, segments);
    let attained = cases.iter().filter(|case| case.attained).count();
    let share = attained as f64 / cases.len().max(1) as f64;
    let conditioning = conditioning(&cases);
    let row = |form: &&Form| {
        let mut row = rows::of_setting(family, setting, form);
        rows::put_conditioning(&mut row, conditioning);
        let (ask, is_segment) = (form.asked.ask, form.asked.is_segment);
        rows::put_found(&mut row, &found(ask, is_segment, form.reported(), &cases));
        row.attained_share = Some(share);
        row
    };
    forms.iter().map(row).collect()
}

/// The rows of one setting of a family of single cases; none of other families.
pub fn errors_at(
    family: &Family,
    knob: f64,
    precision: Precision,
    seed: u64,
    count: usize,
    forms: &[Form],
) -> Vec<Row> {
    rows_of(family, &Setting { precision, knob, seed, count, class: None }, forms)
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

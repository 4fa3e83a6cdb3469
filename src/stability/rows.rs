//! Rows of the sweep.

use super::asking::Found;
use super::cells::Conditioning;
use super::family::Family;
use super::forms::Form;
use super::sweep::Setting;
use crate::rows::{of_axes, put_accuracy};
use crate::table::Row;

/// The value of the column `experiment`, and the folder of the results.
pub const EXPERIMENT: &str = "stability";

/// The columns of a form alone.
pub fn of_form(form: &Form) -> Row {
    Row {
        experiment: EXPERIMENT.into(),
        form: form.name.clone(),
        status: "ok".into(),
        ..of_axes(&form.asked.axes)
    }
}

/// The columns of a form at a setting of a family's knob.
pub fn of_setting(family: &Family, setting: &Setting, form: &Form) -> Row {
    Row {
        record: family.work.record().into(),
        workload: family.id.into(),
        family: family.id.into(),
        knob: Some(setting.knob),
        seed: Some(setting.seed),
        ..of_form(form)
    }
}

/// Puts in what rounding the inputs may do.
pub fn put_conditioning(row: &mut Row, conditioning: Conditioning) {
    row.kappa_t_p99 = conditioning.t_p99;
    row.kappa_b_p99 = conditioning.weights_p99;
}

/// Puts in what a form did.
pub fn put_found(row: &mut Row, found: &Found) {
    let accuracy = &found.accuracy;
    put_accuracy(row, accuracy);
    row.tests = Some(accuracy.cases);
    row.cases = Some(accuracy.cases);
    row.exact_hits = Some(accuracy.exact_hits);
    row.hits = Some(found.hits);
    row.hits_of_not_finite = Some(found.hits_of_nothing);
    row.err_t_p50_rel = accuracy.t_relative.p50;
    row.err_t_p99_rel = accuracy.t_relative.p99;
}

//! What the rows of a sweep come to: knees, and leaks over all meshes.

use super::family::Family;
use super::forms::Form;
use super::leaks::Tally;
use super::limit;
use super::precision::Precision;
use super::rows;
use super::shots::RayClass;
use crate::table::Row;

/// What the row without a kernel is called: the exact answer to inputs that are off by a rounding.
pub const INPUTS: &str = "(inputs off by a rounding)";

/// For every family with a knob that gets harder and every form the first setting at which it
/// fails: where the 99th percentile of the relative error of t, or of the error of the weights,
/// exceeds 1e-3 (f32) or 1e-9 (f64), or more than 1000 decisions in a million are deep in the
/// wrong. Before the forms of a precision stands the knee of the problem itself: where a rounding
/// of the inputs does as much.
pub fn knees(families: &[Family], forms: &[Form], rows: &[Row]) -> Vec<Row> {
    let mut knees = Vec::new();
    for family in families.iter().filter(|family| family.has_knee()) {
        for precision in Precision::ALL {
            let of_family: Vec<&Row> = rows
                .iter()
                .filter(|row| row.family == family.id && row.precision == precision.name())
                .collect();
            let Some(first) = of_family.first() else { continue };
            let knobs = (family.knobs)(precision);
            let inputs: Vec<&Row> =
                of_family.iter().copied().filter(|row| row.id == first.id).collect();
            let blank = Row {
                experiment: rows::EXPERIMENT.into(),
                form: INPUTS.into(),
                precision: precision.name().into(),
                status: "ok".into(),
                build: first.build.clone(),
                ..Row::default()
            };
            let exceeds = |row: &Row| inputs_fail(row, precision);
            knees.extend(knee(blank, family, &knobs, &inputs, &exceeds));
            for form in forms.iter().filter(|form| form.precision == precision) {
                let id = form.asked.id();
                let mine: Vec<&Row> =
                    of_family.iter().copied().filter(|row| row.id == id).collect();
                if !mine.is_empty() {
                    let fails = |row: &Row| fails(row, precision);
                    knees.extend(knee(rows::of_form(form), family, &knobs, &mine, &fails));
                }
            }
        }
    }
    knees
}

/// `None` where a setting is missing: what was interrupted has no knee yet.
fn knee(
    blank: Row,
    family: &Family,
    knobs: &[f64],
    rows: &[&Row],
    fails: &dyn Fn(&Row) -> bool,
) -> Option<Row> {
    let at = |knob: &f64| rows.iter().find(|row| row.knob == Some(*knob));
    if !knobs.iter().all(|knob| at(knob).is_some()) {
        return None;
    }
    let place = knobs.iter().position(|knob| at(knob).is_some_and(|row| fails(row)));
    Some(Row {
        record: "knee".into(),
        workload: family.id.into(),
        family: family.id.into(),
        knob_name: family.knob.into(),
        seed: rows.first().and_then(|row| row.seed),
        knee: place.map(|place| knobs[place]),
        knee_share: Some(place.map_or(1.0, |place| place as f64 / knobs.len() as f64)),
        ..blank
    })
}

fn fails(row: &Row, precision: Precision) -> bool {
    let deep = row.deep_false_hits.unwrap_or(0) + row.deep_false_misses.unwrap_or(0);
    let errors = [row.err_t_p99_rel, row.err_b_p99];
    limit::fails(errors, deep, row.cases.unwrap_or(0), precision)
}

fn inputs_fail(row: &Row, precision: Precision) -> bool {
    let limit = precision.knee_error() / precision.unit_roundoff();
    [row.kappa_t_p99, row.kappa_b_p99].into_iter().flatten().any(|kappa| kappa > limit)
}

/// For every form and class of rays, leaks and double hits over all meshes and offsets.
pub fn leaks(forms: &[Form], rows: &[Row]) -> Vec<Row> {
    let mut sums = Vec::new();
    for form in forms {
        let id = form.asked.id();
        for class in RayClass::ALL.map(RayClass::word) {
            let is_mine =
                |row: &&Row| row.record == "rays" && row.id == id && row.ray_class == class;
            let mine: Vec<&Row> = rows.iter().filter(is_mine).collect();
            let Some(first) = mine.first() else { continue };
            let mut sum = Row {
                record: "leaks".into(),
                workload: "closed-meshes".into(),
                ray_class: class.into(),
                seed: first.seed,
                ..rows::of_form(form)
            };
            Tally::of(&mine).put(&mut sum);
            sums.push(sum);
        }
    }
    sums
}

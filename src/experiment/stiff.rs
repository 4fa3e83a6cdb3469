//! Errors of the variants on stiff families, beside their times on random pairs; no clock.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::Deserialize;

use crate::registry::{Variant, asked_with_peers};
use crate::spread::on_all_cores;
use crate::stability::{Family, Form, Precision, errors_at, families, find};
use crate::table::Row;

/// Stiff families, each at one setting of its knob.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StiffWorkload {
    /// Cases of each family.
    pub cases: usize,
    /// The knob of each, by its id.
    pub knobs: BTreeMap<String, f64>,
}

impl StiffWorkload {
    /// Refuses what can be seen to be wrong before anything runs.
    pub(super) fn validate(&self) -> Result<(), String> {
        super::workload::in_range("stiff.cases", self.cases, 1)?;
        for (id, knob) in &self.knobs {
            let family = find(id).ok_or_else(|| {
                let known: Vec<&str> = families().iter().map(|family| family.id).collect();
                format!("workload.stiff.knobs: there is no family '{id}'; {}", known.join(", "))
            })?;
            let range = |precision: Precision| {
                let knobs = (family.knobs)(precision);
                Some((*knobs.first()?, *knobs.last()?))
            };
            for (first, last) in Precision::ALL.into_iter().filter_map(range) {
                if !(first..=last).contains(knob) {
                    return Err(format!(
                        "workload.stiff.knobs.{id}: {knob} is not allowed; allowed: {first} to {last}"
                    ));
                }
            }
        }
        Ok(())
    }
}

/// A row per family and variant; none for variants that cannot be asked one question. Ends early,
/// with fewer, once cancelled.
pub fn rows(
    experiment: &str,
    variants: &[&'static Variant],
    workload: &StiffWorkload,
    seed: u64,
    cancel: &AtomicBool,
) -> Vec<Row> {
    let ids: Vec<String> = variants.iter().map(|variant| variant.id()).collect();
    let forms = asked_with_peers().filter(|form| ids.contains(&form.id()));
    let forms: Vec<Form> = forms.filter_map(Form::of).collect();
    let settings: Vec<(Family, f64, Precision)> = workload
        .knobs
        .iter()
        .flat_map(|(id, knob)| Precision::ALL.map(|precision| (id, *knob, precision)))
        .filter_map(|(id, knob, precision)| Some((find(id)?, knob, precision)))
        .collect();
    let rows = on_all_cores(settings.len(), |place| {
        let (family, knob, precision) = &settings[place];
        if cancel.load(Ordering::Relaxed) {
            return Vec::new();
        }
        errors_at(family, *knob, *precision, seed, workload.cases, &forms)
    });
    let named = |row: Row| Row { experiment: experiment.into(), ..row };
    rows.into_iter().flatten().map(named).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::select;

    fn workload(id: &str, knob: f64) -> StiffWorkload {
        StiffWorkload { cases: 300, knobs: BTreeMap::from([(id.to_owned(), knob)]) }
    }

    #[test]
    fn a_row_for_each_precision_whose_needle_is_worse_than_its_mild_one() {
        let pattern = "^wald/(f32|f64)/single/sse2/early/last/plain/tuv$".to_owned();
        let variants = select(&[pattern]).expect("it matches");
        let error = |knob: f64| -> Vec<Option<f64>> {
            let rows = rows("x", &variants, &workload("needle", knob), 1, &AtomicBool::new(false));
            assert_eq!(rows.len(), 2);
            assert!(rows.iter().all(|row| row.workload == "needle" && row.experiment == "x"));
            rows.iter().map(|row| row.err_b_p99).collect()
        };
        let (mild, stiff) = (error(0.0), error(2.0));
        assert!(mild.iter().zip(&stiff).all(|(mild, stiff)| mild.is_some() && stiff > mild));
    }

    #[test]
    fn families_and_knobs_that_there_are_not_are_refused() {
        assert_eq!(workload("needle", 4.0).validate(), Ok(()));
        let unknown = workload("noodle", 4.0).validate().expect_err("no family");
        assert!(unknown.contains("noodle") && unknown.contains("needle"), "{unknown}");
        let beyond = workload("needle", 99.0).validate().expect_err("beyond");
        assert!(beyond.contains("allowed: 0 to 8"), "{beyond}");
    }
}

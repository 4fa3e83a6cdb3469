//! Errors of the variants on stiff families, beside their times on random pairs; no clock.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::Deserialize;

use super::clock_free::Placed;
use crate::registry::{Variant, asked_with_peers};
use crate::shard::Shard;
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

/// A setting of a family, with the tasks that are about it.
type Setting = (Family, f64, Precision, Vec<(usize, Form)>);

/// A row per family and variant; none for variants that cannot be asked one question. A task is a
/// setting and a form. Ends early, with fewer, once cancelled.
pub fn rows(
    experiment: &str,
    variants: &[&'static Variant],
    workload: &StiffWorkload,
    seed: u64,
    shard: Shard,
    cancel: &AtomicBool,
) -> Vec<Placed> {
    let mut settings = settings(variants, workload);
    let mine = shard.range(settings.iter().map(|(.., tasks)| tasks.len()).sum());
    for (.., tasks) in &mut settings {
        tasks.retain(|(task, _)| mine.contains(task));
    }
    // Nobody draws the cases of a setting of which another has all forms.
    settings.retain(|(.., tasks)| !tasks.is_empty());
    let rows = on_all_cores(settings.len(), |place| {
        let (family, knob, precision, tasks) = &settings[place];
        if cancel.load(Ordering::Relaxed) {
            return Vec::new();
        }
        let forms: Vec<Form> = tasks.iter().map(|(_, form)| form.clone()).collect();
        let rows = errors_at((family, *knob), *precision, (seed, workload.cases), &forms, cancel);
        let placed = |row: Row| {
            let task = tasks.iter().find(|(_, form)| form.asked.id() == row.id)?.0;
            Some((task as u64, Row { experiment: experiment.into(), ..row }))
        };
        rows.into_iter().filter_map(placed).collect()
    });
    rows.into_iter().flatten().collect()
}

/// Every setting with its tasks, numbered through.
fn settings(variants: &[&'static Variant], workload: &StiffWorkload) -> Vec<Setting> {
    let ids: Vec<String> = variants.iter().map(|variant| variant.id()).collect();
    let forms = asked_with_peers().filter(|form| ids.contains(&form.id()));
    let forms: Vec<Form> = forms.filter_map(Form::of).collect();
    let mut number = 0..;
    let mut settings = Vec::new();
    for (id, knob) in &workload.knobs {
        for precision in Precision::ALL {
            let Some(family) = find(id) else { continue };
            let of_precision = forms.iter().filter(|form| form.precision == precision).cloned();
            let tasks = of_precision.zip(number.by_ref()).map(|(form, task)| (task, form));
            let tasks = tasks.collect();
            settings.push((family, *knob, precision, tasks));
        }
    }
    settings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::select;

    fn workload(id: &str, knob: f64) -> StiffWorkload {
        StiffWorkload { cases: 300, knobs: BTreeMap::from([(id.to_owned(), knob)]) }
    }

    fn of_shard(
        variants: &[&'static Variant],
        workload: &StiffWorkload,
        shard: &str,
    ) -> Vec<Placed> {
        let shard = shard.parse().expect("a share");
        rows("x", variants, workload, 1, shard, &AtomicBool::new(false))
    }

    #[test]
    fn shares_together_are_the_whole_and_know_their_places() {
        let pattern = "^(wald|moller-trumbore|chirkov)/(f32|f64)/single/sse2/early/last/plain/tuv$"
            .to_owned();
        let variants = select(&[pattern]).expect("it matches");
        let mut workload = workload("needle", 3.0);
        workload.knobs.insert("tiny".into(), 3.0);
        let whole = of_shard(&variants, &workload, "1/1");
        let parts = ["1/4", "2/4", "3/4", "4/4"].map(|shard| of_shard(&variants, &workload, shard));
        assert_eq!(whole.len(), 2 * 2 * 3);
        assert_eq!(parts.concat(), whole);
        assert!(whole.is_sorted_by_key(|(task, _)| *task));
    }

    #[test]
    fn a_row_for_each_precision_whose_needle_is_worse_than_its_mild_one() {
        let pattern = "^wald/(f32|f64)/single/sse2/early/last/plain/tuv$".to_owned();
        let variants = select(&[pattern]).expect("it matches");
        let error = |knob: f64| -> Vec<Option<f64>> {
            let rows = of_shard(&variants, &workload("needle", knob), "1/1");
            assert_eq!(rows.len(), 2);
            assert!(rows.iter().all(|(_, row)| row.workload == "needle" && row.experiment == "x"));
            rows.iter().map(|(_, row)| row.err_b_p99).collect()
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

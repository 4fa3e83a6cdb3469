//! Errors of hits (thesis H, illustration 11): each form against the exact answer, and against
//! Moeller-Trumbore in f64 as the thesis has it; no clock.
//!
//! Random hits, none left out for being delicate, so the mean relative errors have no limit as hits
//! are added (`Accuracy::t_mean_relative`): a row per seed shows how far they scatter.

use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, Ordering};

use super::clock_free::Placed;
use super::scene::reported;
use super::workload::ErrorsWorkload;
use crate::accuracy::{Accuracy, Measures, Truth};
use crate::oracle::{Class, Exact, Query, classify};
use crate::registry::{Asked, Variant, asked, asked_with_peers};
use crate::rows::{of_variant, put_accuracy};
use crate::shard::Shard;
use crate::spread::on_all_cores;
use crate::table::Row;
use crate::workload::{Pcg, Ray, Triangle, hash, random_pair};

/// What the errors of a row are against (column `err_against`).
const EXACT: &str = "exact";
/// The thesis's reference.
const IN_DOUBLE: &str = "moller-trumbore-f64";

/// The hits of a seed with what answers to them are compared with: exact, and the reference's.
struct Hits {
    count: usize,
    hash: u64,
    rays: [Vec<Truth>; 2],
    segments: [Vec<Truth>; 2],
}

/// How many tasks there are: one for each seed and variant.
pub fn tasks(variants: &[&'static Variant], workload: &ErrorsWorkload) -> usize {
    workload.seeds * variants.len()
}

/// Two rows per seed and variant, one against each of the two references; variants that are not a
/// form of [`asked_with_peers`] have one without figures. Ends early, with fewer seeds, once cancelled.
pub fn rows(
    experiment: &str,
    variants: &[&'static Variant],
    workload: &ErrorsWorkload,
    seed: u64,
    shard: Shard,
    cancel: &AtomicBool,
) -> Vec<Placed> {
    let mine = shard.range(tasks(variants, workload));
    let mut rows = Vec::new();
    for number in 0..workload.seeds {
        let first = number * variants.len();
        let of_seed = first.max(mine.start)..(first + variants.len()).min(mine.end);
        // Nobody draws the hits of a seed of which another has all variants.
        if of_seed.is_empty() || cancel.load(Ordering::Relaxed) {
            continue;
        }
        let variants = &variants[of_seed.start - first..of_seed.end - first];
        let seed = seed.wrapping_add(number as u64);
        let found = of_seed_rows(experiment, variants, workload.hits, seed);
        let placed = of_seed.zip(found);
        rows.extend(
            placed.flat_map(|(task, rows)| rows.into_iter().map(move |row| (task as u64, row))),
        );
    }
    rows
}

/// The rows of one seed, by variant.
fn of_seed_rows(
    experiment: &str,
    variants: &[&'static Variant],
    hits: usize,
    seed: u64,
) -> Vec<Vec<Row>> {
    let forms: Vec<Option<&Asked>> = variants.iter().map(|variant| form_of(variant)).collect();
    let hits = Hits::draw(hits, seed);
    // Index 2 i + r: variant i against reference r.
    let found = on_all_cores(2 * forms.len(), |task| {
        forms[task / 2].map(|form| hits.measure(form, variants[task / 2], task % 2))
    });
    let row = |(variant, found): (&&'static Variant, &[Option<Accuracy>])| {
        let blank = Row {
            experiment: experiment.into(),
            workload: "errors-random".into(),
            query: "ray".into(),
            generator: "pcg".into(),
            seed: Some(seed),
            tests: Some(hits.count as u64),
            workload_hash: format!("{:016x}", hits.hash),
            ..of_variant(variant)
        };
        of_form(variant, blank, found)
    };
    variants.iter().zip(found.chunks(2)).map(row).collect()
}

fn of_form(variant: &Variant, blank: Row, found: &[Option<Accuracy>]) -> Vec<Row> {
    let [Some(exact), Some(in_double)] = found else {
        let reason = "it has no form that answers one question".to_owned();
        return vec![Row { status: "skipped".into(), reason, ..blank }];
    };
    let row = |against: &str, accuracy: &Accuracy| {
        let mut row = Row {
            status: if variant.claims_exactness() { "ok" } else { "inexact" }.into(),
            err_against: against.into(),
            hits: Some(accuracy.cases - accuracy.false_misses),
            ..blank.clone()
        };
        put_accuracy(&mut row, accuracy);
        // Only hits were asked for.
        (row.false_hits, row.deep_false_hits) = (None, None);
        row
    };
    let ratio = |a: Option<f64>, b: Option<f64>| Some(a? / b?).filter(|ratio| ratio.is_finite());
    let err_ratio_to_exact = ratio(in_double.mean_relative, exact.mean_relative);
    vec![row(EXACT, exact), Row { err_ratio_to_exact, ..row(IN_DOUBLE, in_double) }]
}

/// The form of [`asked_with_peers`] that is a variant's.
fn form_of(variant: &Variant) -> Option<&'static Asked> {
    asked_with_peers().find(|form| form.id() == variant.id())
}

/// Moeller-Trumbore in f64, divided first.
fn in_double() -> &'static Asked {
    static FORM: LazyLock<&Asked> = LazyLock::new(|| {
        let is_it = |form: &&Asked| {
            let axes = &form.axes;
            (axes.kernel, axes.precision, axes.division, axes.rounding)
                == ("moller-trumbore", "f64", "first", "plain")
        };
        asked().iter().find(is_it).expect("it is one of the forms")
    });
    &FORM
}

impl Hits {
    fn draw(count: usize, seed: u64) -> Self {
        let mut source = Pcg::new(seed);
        let (mut rays, mut triangles) = (Vec::with_capacity(count), Vec::with_capacity(count));
        while rays.len() < count {
            let (ray, triangle) = random_pair(&mut source);
            if classify(&Query::of(&ray, &triangle)).is_hit() {
                rays.push(ray);
                triangles.push(triangle);
            }
        }
        let hash = hash::workload(&rays, &triangles);
        let solved = |query: fn(&Ray, &Triangle) -> Query| {
            let both = on_all_cores(count, |i| {
                let exact = Truth::of_query(query(&rays[i], &triangles[i]));
                let reference = of_reference(&exact);
                (exact, reference)
            });
            let (exact, reference) = both.into_iter().unzip();
            [exact, reference]
        };
        let (segments, rays) = (solved(Query::of_segment), solved(Query::of));
        Hits { count, hash, rays, segments }
    }

    fn measure(&self, form: &Asked, variant: &Variant, reference: usize) -> Accuracy {
        let truths = if form.is_segment { &self.segments } else { &self.rays };
        let mut measures = Measures::new(reported(variant));
        for (exact, truth) in truths[0].iter().zip(&truths[reference]) {
            measures.add(truth, &(form.ask)(&exact.query));
        }
        measures.finish()
    }
}

/// What the reference says, in place of the exact answer.
fn of_reference(truth: &Truth) -> Truth {
    let answer = (in_double().ask)(&truth.query);
    let class = if answer.triangle.is_some() { truth.exact.class } else { Class::Outside };
    let (t, u, v) = (answer.t, answer.u, answer.v);
    let w = (1.0 - u) - v;
    let exact = Exact { class, t, u, v, w, t_lo: 0.0, u_lo: 0.0, v_lo: 0.0, w_lo: 0.0 };
    Truth { exact, ..truth.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::select;

    fn measured(pattern: &str) -> Vec<Row> {
        let variants = select(&[pattern.to_owned()]).expect("it matches");
        let workload = ErrorsWorkload { hits: 400, seeds: 2 };
        let never = AtomicBool::new(false);
        let placed = rows("errors", &variants, &workload, 7, Shard::WHOLE, &never);
        placed.into_iter().map(|(_, row)| row).collect()
    }

    #[test]
    fn shares_together_are_the_whole_and_know_their_places() {
        let variants =
            select(&["^(wald|chirkov)/f32/(single|packet4)/sse2/early/last/plain/tuv$".to_owned()]);
        let variants = variants.expect("it matches");
        let workload = ErrorsWorkload { hits: 50, seeds: 2 };
        let never = AtomicBool::new(false);
        let of = |shard: &str| {
            let shard = shard.parse().expect("a share");
            rows("errors", &variants, &workload, 7, shard, &never)
        };
        let whole = of("1/1");
        let parts = ["1/3", "2/3", "3/3"].map(of);
        assert!(parts.iter().all(|part| !part.is_empty()));
        assert_eq!(parts.concat(), whole);
        assert!(whole.is_sorted_by_key(|(task, _)| *task));
    }

    #[test]
    fn the_reference_has_no_error_against_itself_and_some_against_the_truth() {
        let rows = measured("^moller-trumbore/f64/single/sse2/early/first/plain/tuv$");
        assert_eq!(rows.len(), 4);
        for pair in rows.chunks(2) {
            assert_eq!(
                (pair[0].err_against.as_str(), pair[1].err_against.as_str()),
                (EXACT, IN_DOUBLE)
            );
            assert!(
                pair[0].err_tuv_mean_rel > Some(1e-17) && pair[0].err_tuv_mean_rel < Some(1e-12)
            );
            assert_eq!((pair[1].err_max_rel, pair[1].err_ratio_to_exact), (Some(0.0), Some(0.0)));
            assert_eq!((pair[0].err_cases, pair[0].false_misses), (Some(400), Some(0)));
        }
        assert_eq!([rows[0].seed, rows[2].seed], [Some(7), Some(8)]);
        assert_ne!(rows[0].err_tuv_mean_rel, rows[2].err_tuv_mean_rel);
    }

    #[test]
    fn for_single_precision_the_two_references_are_as_good_as_each_other() {
        for row in measured("^(wald|chirkov)/f32/single/sse2/early/last/plain/tuv$").chunks(2) {
            assert!(row[0].err_tuv_mean_rel > Some(1e-8), "{:?}", row[0]);
            let ratio = row[1].err_ratio_to_exact.expect("both have errors");
            // u64 / u32 is 2e-9; the errors of few hits are that much apart at most.
            assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_rows() {
        let once = || measured("^(chirkov|angle-sum)/f32/single/sse2/early/last/plain/tuv?$");
        assert_eq!(once(), once());
    }

    #[test]
    fn a_form_that_answers_no_single_question_is_skipped() {
        let rows = measured("^wald/f32/packet4/sse2/early/last/plain/tuv$");
        assert!(rows.iter().all(|row| row.status == "skipped" && row.err_cases.is_none()));
        assert_eq!(rows.len(), 2);
    }
}

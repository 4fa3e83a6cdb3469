//! Which kernel is taken: what `recommend` names, and how it is shown.

use super::*;
use crate::recommend::{RecommendError, recommend};
use crate::report::answers::{Answer, answers, needs};

const SINGLE: &str = "single rays";
const WATERTIGHT: &str = "single rays, none lost between triangles";

fn answer_of(results: &Results, need: &str, known: &[KnownVariant]) -> Option<Answer> {
    answers(results, None, known).into_iter().find(|answer| answer.need == need)
}

fn answer(rows: Vec<Row>, need: &str) -> Option<Answer> {
    let results = results(rows, &[]);
    let known = known(&results);
    answer_of(&results, need, &known)
}

/// Rows of several places, drives and precisions, in which rules that are not the same would differ.
fn many() -> Vec<Row> {
    let mut rows = Vec::new();
    for (index, workload) in ["nearest-random", "nearest-coherent", "pairs"].iter().enumerate() {
        for (kernel, ns) in [("a", 3.0), ("b", 2.0), ("c", 2.5), ("d", 4.0)] {
            for (drive, precision, gain) in [
                ("single", "f32", 1.0),
                ("packet8", "f32", 0.2),
                ("packet8-common-origin", "f32", 0.1),
                ("single", "f64", 1.5),
                ("packet4", "f64", 0.4),
            ] {
                let turned = if index == 1 { 6.0 - ns } else { ns };
                let row = timed(kernel, gain * turned);
                rows.push(Row {
                    id: format!("{kernel}/{precision}/{drive}/sse2/early/last/plain/tuv"),
                    experiment: format!("experiment-{index}"),
                    workload: (*workload).into(),
                    workload_hash: (*workload).into(),
                    drive: drive.into(),
                    precision: precision.into(),
                    prepare_cycles_per_triangle: Some(10.0 * ns),
                    cycles_per_test: Some(3.0 * gain * turned),
                    ..row
                });
            }
        }
    }
    rows
}

#[test]
fn every_answer_is_what_recommend_names_for_the_same_rows() {
    let rows = many();
    let results = results(rows, &[]);
    let mut known = known(&results);
    for variant in &mut known {
        variant.available = true;
        variant.watertight = ["a/", "d/"].iter().any(|kernel| variant.id.starts_with(kernel));
    }
    let shown = answers(&results, None, &known);
    assert_eq!(shown.len(), needs().len());
    for (answer, (need, question)) in shown.iter().zip(needs()) {
        let named = recommend(&results, &question, &known).expect("something fits");
        assert_eq!((answer.need.as_str(), &answer.variant), (need, &named.variant));
        // All but the last sentence, which says where the rows lie.
        assert_eq!(answer.because[..], named.because[..named.because.len() - 1]);
        let asked = format!("ray_test recommend{}", question.arguments());
        assert_eq!(answer.command, asked);
    }
    let variants: std::collections::BTreeSet<&String> =
        shown.iter().map(|answer| &answer.variant).collect();
    assert!(variants.len() >= 5, "the rows tell the questions apart: {variants:?}");
}

#[test]
fn where_recommend_names_nothing_there_is_no_answer() {
    let results = results(vec![timed("a", 2.0)], &[]);
    let known = known(&results);
    let answered: Vec<String> =
        answers(&results, None, &known).into_iter().map(|answer| answer.need).collect();
    for (need, question) in needs() {
        // On the processor that measured, every variant is.
        let here: Vec<KnownVariant> =
            known.iter().map(|one| KnownVariant { available: true, ..one.clone() }).collect();
        let named = recommend(&results, &question, &here);
        let fits = !matches!(named, Err(RecommendError::NothingFits { .. }));
        assert_eq!(answered.iter().any(|other| other == need), fits, "{need}");
    }
    assert!(answers(&results, None, &[]).is_empty(), "nothing is known of the variants");
}

#[test]
fn the_fastest_has_its_figures_and_the_next_kernel_its_price() {
    let error = Row {
        workload: "errors-random".into(),
        err_against: "exact".into(),
        err_b_p99: Some(3e-7),
        ns_per_test: None,
        order: String::new(),
        ..timed("b", 1.0)
    };
    let mut slower = timed("b", 2.4);
    slower.id += "/leading=inside";
    let rows = vec![timed("a", 3.0), timed("b", 2.0), slower, timed("c", 2.5), error];
    let answer = answer(rows, SINGLE).unwrap();
    assert!(answer.variant.starts_with("b/"));
    assert_eq!((answer.time.as_str(), answer.error.as_str()), ("2.00 [1.98, 2.02]", "3.00e-7"));
    assert_eq!(answer.speed, "500 [495, 505]");
    // The next of another kernel, not the next form of the same. 2.475 / 2.02 and 2.525 / 1.98
    let next = "c/f32/single/sse2/early/last/plain/tuv, 25 % slower [23 %, 28 %]";
    assert_eq!(answer.runner_up, next);
    assert_eq!(answer.cell, "nearest-random, order reshuffled");
    assert_eq!(answer.command, "ray_test recommend --precision f32");
}

#[test]
fn what_cannot_be_told_apart_is_said_to_be_so() {
    let close = answer(vec![timed("a", 2.0), timed("b", 2.01)], SINGLE).unwrap();
    assert!(close.runner_up.contains("no difference that can be measured"), "{close:?}");
    // 10 % apart, and copies of one kernel 20 %.
    let noisy = |kernel, ns| Row { noise_floor: Some(0.2), ..timed(kernel, ns) };
    let close = answer(vec![noisy("a", 2.0), noisy("b", 2.2)], SINGLE).unwrap();
    let words = "10 % slower, less than copies of one kernel differ by (20 %)";
    assert!(close.runner_up.ends_with(words), "{close:?}");
}

#[test]
fn the_watertight_one_says_what_it_lost_and_how_it_bears_stiff_cases() {
    let swept = |kernel: &str, record: &str| Row {
        record: record.into(),
        form: kernel.into(),
        ns_per_test: None,
        ..timed(kernel, 1.0)
    };
    let knee = |kernel: &str, knee: Option<f64>| Row { knee, ..swept(kernel, "knee") };
    let leaks =
        |kernel: &str, lost| Row { leaks: Some(lost), cases: Some(1000), ..swept(kernel, "leaks") };
    let rows = vec![
        leaks("a", 0),
        leaks("b", 0),
        leaks("c", 3),
        knee("b", None),
        knee("b", Some(3.0)),
        knee("d", None),
        knee("d", None),
        knee("e", None),
        timed("a", 1.0),
        timed("b", 2.0),
        timed("c", 1.5),
    ];
    let results = results(rows, &[]);
    let mut known = known(&results);
    assert!(answer_of(&results, WATERTIGHT, &known).is_none());
    for variant in &mut known {
        variant.watertight = !variant.id.starts_with("a/");
    }
    let found = answer_of(&results, WATERTIGHT, &known).unwrap();
    assert!(found.variant.starts_with("b/"), "{found:?}");
    let note = "lost 0 of 1000 rays at closed meshes and \
                bears 1 of 2 families of stiff cases to the end (the best: d, 2)";
    assert_eq!(found.note, note);
    // Without knees, stiff cases of other experiments tell; nobody has seen c lose a ray then.
    let wrong = Row { deep_false_hits: Some(2), ..swept("c", "cases") };
    let mut cases = results;
    cases.chapters[0].rows.retain(|row| row.record.is_empty());
    cases.chapters[0].rows.extend([wrong, swept("c", "cases"), swept("c", "cases")]);
    let found = answer_of(&cases, WATERTIGHT, &known).unwrap();
    assert!(found.variant.starts_with("c/"), "{found:?}");
    assert_eq!(
        found.note,
        "bears 2 of 3 families of stiff cases to the end (no kernel bears more)"
    );
}

#[test]
fn every_answer_comes_with_its_reasons_and_its_command() {
    let results = results(vec![timed("a", 2.0), timed("b", 3.0)], &[]);
    let page = html(&results, &[]);
    assert!(page.contains("<code>ray_test recommend --precision f32</code>"));
    assert!(page.contains("the fastest of 2 forms of 2 kernels that fit"));
    assert!(markdown(&results, &[]).contains("`ray_test recommend --precision f32`"));
}

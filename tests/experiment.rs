//! Experiments from TOML to rows, on a clock that tells what it is told.
#![cfg(feature = "cli")]

mod support;

use ray_test::experiment::Outcome;
use ray_test::table::Row;
use support::{Memory, OfRun, attempt, plan, run_until};

/// Runs an experiment in 16 rounds.
fn rows(text: &str, cancelled: bool) -> Outcome {
    run_until(text, if cancelled { 0 } else { usize::MAX }, &mut Memory::default())
}

fn pairs(variants: &str, more: &str) -> String {
    format!(
        "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
         variants = [{variants}]\n{more}\n[workload]\nkind = 'pairs'\ncount = 40\n\
         reshuffled_count = 40\ndensity = [0.25, 0.5]\norders = ['literal', 'fixed', 'reshuffled']\n\
         seconds_of_tests = 1000.0\n"
    )
}

#[test]
fn a_row_for_every_variant_density_and_order() {
    let outcome = rows(&pairs("'^moller[01]/f32/single/sse2/early/[a-z]+/plain/t$'", ""), false);
    assert_eq!(outcome.rows.len(), 2 * 2 * 3);
    assert!(outcome.wrong.is_empty() && !outcome.interrupted);
    for row in &outcome.rows {
        assert_eq!((row.status.as_str(), row.experiment.as_str()), ("ok", "test"), "{row:?}");
        assert_eq!(row.hits, row.density.map(|density| (density * 40.0) as u64));
        assert_eq!(
            (row.false_hits, row.false_misses, row.nan_outputs),
            (Some(0), Some(0), Some(0))
        );
        assert!(row.ns_per_test.is_some_and(|ns| ns > 0.0));
        // Seconds are those of the number of tests that was asked for.
        let seconds = row.ns_per_test.map(|ns| ns * 1000.0 * 1e-9);
        assert_eq!(row.seconds, seconds);
        assert!(row.percent_slower.is_some_and(|percent| percent >= 0.0));
    }
}

#[test]
fn what_cannot_run_is_skipped_with_its_reason() {
    let patterns = "'^moller1/f32/single/sse2/early/last/plain/t$', '^keidy/.*/query=point$'";
    let outcome = rows(&pairs(patterns, ""), false);
    let skipped: Vec<&Row> = outcome.rows.iter().filter(|row| row.status == "skipped").collect();
    assert!(!skipped.is_empty());
    for row in skipped {
        assert_eq!(row.ns_per_test, None);
        assert!(row.reason.contains("query"), "{}", row.reason);
    }
}

/// A listing tests no t, so it is wrong about segments that end before the triangle or begin behind
/// it: about 3 % of the misses. It makes a test of the check that stands before the clock.
#[test]
fn a_wrong_kernel_is_never_timed() {
    let segments = pairs("'^moller1/f32/single/sse2/early/last/plain/t$'", "")
        .replacen("count = 40\n", "query = 'segment'\ncount = 1000\n", 1)
        .replace("reshuffled_count = 40\n", "reshuffled_count = 1000\n");
    let outcome = rows(&segments, false);
    assert_eq!(outcome.wrong, ["moller1/f32/single/sse2/early/last/plain/t"]);
    for row in &outcome.rows {
        assert_eq!(row.status, "wrong-result");
        assert_eq!((row.ns_per_test, row.min_ns, row.rounds), (None, None, None));
        assert!(!row.reason.is_empty());
    }
}

#[test]
fn packets_find_what_single_rays_find() {
    let text = "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
        variants = ['^wald/f32/(single|packet4)/sse2/(early|full)/last/plain/(hit|tuv|surface)$']\n\
        [workload]\nkind = 'nearest'\ntriangles = 20\nrays = 16\nreshuffled_rays = 32\n\
        orders = ['fixed', 'reshuffled']\n";
    let outcome = rows(text, false);
    assert_eq!(outcome.rows.len(), 2 * (2 * 3 + 2));
    for order in ["fixed", "reshuffled"] {
        let of: Vec<&Row> = outcome.rows.iter().filter(|row| row.order == order).collect();
        assert!(of.iter().all(|row| row.status == "ok" && row.hits == of[0].hits), "{of:?}");
        let rays = if order == "fixed" { 16 } else { 32 };
        assert!(of.iter().all(|row| row.tests == Some(20 * rays) && row.density.is_none()));
    }
}

#[test]
fn prices_need_the_literal_form_and_both_others() {
    let all = "'^moller1/f32/single/sse2/early/last/plain/t(/priced=dot(-control)?)?$'";
    let outcome = rows(&pairs(all, ""), false);
    let priced: Vec<&Row> = outcome.rows.iter().filter(|row| row.price.is_some()).collect();
    assert_eq!(priced.len(), 2 * 3);
    assert!(priced.iter().all(|row| row.priced == "dot" && row.kernel == "moller1"));
    let without = "'^moller1/f32/single/sse2/early/last/plain/t/priced=dot(-control)?$'";
    assert!(rows(&pairs(without, ""), false).rows.iter().all(|row| row.price.is_none()));
}

#[test]
fn codes_are_counted_and_add_up() {
    let text = "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
        variants = ['^(moller1|badouel)/f32/single/sse2/early/[a-z]+/plain/t$']\n[workload]\n\
        kind = 'codes'\npairs = 20000\ntimed_pairs = 50\norders = ['literal', 'fixed']\n";
    let outcome = rows(text, false);
    for kernel in ["moller1", "badouel"] {
        for order in ["literal", "fixed"] {
            let of = |row: &&Row| row.kernel == kernel && row.order == order;
            let rows: Vec<&Row> = outcome.rows.iter().filter(of).collect();
            assert!(rows.len() >= 3, "{kernel} {order}: {} codes", rows.len());
            assert_eq!(rows.iter().filter_map(|row| row.calls).sum::<u64>(), 20_000);
            assert!(rows.iter().all(|row| row.status == "ok" && row.ns_per_test.is_some()));
        }
    }
}

#[test]
fn a_cancelled_run_begins_nothing() {
    let outcome = rows(&pairs("'^moller1/f32/single/sse2/early/last/plain/t$'", ""), true);
    assert!(outcome.interrupted && outcome.rows.is_empty());
}

/// On a clock that only counts its readings, a run that went on has even the times of one that was
/// never interrupted.
#[test]
fn an_interrupted_run_goes_on_where_it_was() {
    let two_groups = "'^(moller[0-3]|badouel|wald)/f32/single/sse2/early/[a-z]+/plain/t(uv)?$', \
        '^keidy/f32/single/sse2/early/last/plain/tuv/query=point$'";
    let priced = "'^moller1/f32/single/sse2/early/last/plain/t(/priced=dot(-control)?)?$'";
    for text in [pairs(two_groups, ""), pairs(priced, "")] {
        let mut whole = Memory::default();
        let undisturbed = run_until(&text, usize::MAX, &mut whole);
        assert_eq!(
            whole.0.iter().map(|(_, rows)| rows.len()).sum::<usize>(),
            undisturbed.rows.len()
        );
        for blocks in [1, 100, 300, 700] {
            let mut memory = Memory::default();
            let interrupted = run_until(&text, blocks, &mut memory);
            assert!(interrupted.interrupted && memory.0.len() < whole.0.len(), "{blocks}");
            assert_eq!(memory.0, whole.0[..memory.0.len()], "{blocks}");
            let unmeasured = interrupted.rows.iter().filter(|row| row.status == "not-measured");
            assert!(unmeasured.clone().all(|row| row.reason.starts_with("interrupted")));
            // Interrupted again at once, it has what it had before.
            let again = run_until(&text, 0, &mut memory);
            let ids = |rows: &[Row]| rows.iter().map(|row| row.id.clone()).collect::<Vec<_>>();
            let kept: Vec<Row> = memory.0.iter().flat_map(|(_, rows)| rows.clone()).collect();
            assert!(again.interrupted && ids(&again.rows) == ids(&kept), "{blocks}");
            let gone_on = run_until(&text, usize::MAX, &mut memory);
            assert!(gone_on.rows == undisturbed.rows && !gone_on.interrupted, "{blocks}");
            assert!(memory.0 == whole.0, "{blocks}");
        }
    }
}

/// Priced forms of a test of rays have nothing to say about points; that is known, and kept.
#[test]
fn what_cannot_be_priced_is_kept_as_well() {
    let text = "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
        variants = ['^moller1/f32/single/sse2/early/last/plain/t(/priced=dot(-control)?)?$']\n\
        [workload]\nkind = 'points'\ndensity = [0.5]\norders = ['fixed']\ncount = 40\n";
    let mut memory = Memory::default();
    let rows = run_until(text, usize::MAX, &mut memory).rows;
    assert!(rows.len() == 3 && rows.iter().all(|row| row.status == "skipped"), "{rows:?}");
    assert_eq!(memory.0, [("cell 0 fixed 0.5".to_owned(), rows.clone())]);
    assert!(run_until(text, usize::MAX, &mut memory).rows == rows);
}

#[test]
fn rows_of_another_workload_are_refused() {
    let text = pairs("'^moller1/f32/single/sse2/early/last/plain/t$'", "");
    let mut memory = Memory::default();
    run_until(&text, usize::MAX, &mut memory);
    memory.0[0].1[0].workload_hash = "f00d".into();
    let refused = attempt(&text, 16, usize::MAX, &mut OfRun::new(&mut memory));
    let refused = refused.err().expect("another workload").to_string();
    for part in ["test", "cell 0", "workload_hash", "'f00d'", "now '"] {
        assert!(refused.contains(part), "no '{part}' in: {refused}");
    }
}

#[test]
fn wrong_configs_are_refused_with_where_what_and_what_is_allowed() {
    let good = pairs("'^moller1/f32/single/sse2/early/last/plain/t$'", "");
    let refused = |text: &str, parts: &[&str]| {
        let message = plan(text).map(|_| ()).expect_err("it is wrong");
        for part in parts.iter().chain(&["test.toml"]) {
            assert!(message.contains(part), "no '{part}' in: {message}");
        }
    };
    let shared = "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
                  variants = ['^moller-trumbore/f32/packet[0-9]+-common-origin/']\n[workload]\n\
                  kind = 'nearest'\nrays = 64\norders = ['fixed']\n";
    refused(shared, &["workload.coherence", "random", "coherent", "common-origin"]);
    refused(&good.replace("0.25", "1.25"), &["workload.density", "1.25", "0 to 1"]);
    refused(&good.replace("0.25", "nan"), &["workload.density", "NaN", "0 to 1"]);
    refused(&good.replace("count = 40", "count = 0"), &["workload.count", "0", "1 to"]);
    refused(&good.replace("'fixed'", "'sorted'"), &["sorted", "literal"]);
    refused(&good.replace("^moller1", "^mollar1"), &["matches no variant", "list variants"]);
    refused(&good.replace("^moller1", "(moller1"), &["no regular expression"]);
    refused(&good.replace("why", "reason"), &["reason"]);
    refused(&good.replace("id = 'test'", "id = '../test'"), &["id", "../test", "lower-case"]);
    refused(&format!("reference = 'none'\n{good}"), &["reference", "none"]);
    refused(&format!("feature = 'piers'\n{good}"), &["feature", "piers", "peers"]);
}

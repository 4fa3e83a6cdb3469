//! What cannot be compared.

use super::*;

fn keys(comparison: &Comparison) -> Vec<&'static str> {
    comparison.refused.iter().map(|refusal| refusal.key).collect()
}

#[test]
fn another_setting_is_refused_by_its_name() {
    type Setter = fn(&mut Row);
    let cases: [(&str, Setter); 11] = [
        ("order", |row| row.order = "literal".into()),
        ("density", |row| row.density = Some(0.25)),
        ("workload", |row| row.workload = "pairs-ray".into()),
        ("level", |row| row.level = "avx2".into()),
        ("level", |row| {
            (row.level, row.id) = ("avx2".into(), row.id.replace("/sse2/", "/avx2/"));
        }),
        ("generator", |row| row.generator = "msvc".into()),
        ("triangles", |row| row.triangles = Some(10)),
        ("seed", |row| row.seed = Some(2)),
        ("query", |row| row.query = "segment".into()),
        ("winding", |row| row.winding = "mixed".into()),
        ("workload_hash", |row| row.workload_hash = "0bad".into()),
    ];
    for (key, change) in cases {
        let comparison = at_3_percent(&base(), &with(change));
        assert_eq!(comparison.verdict, Verdict::Refused, "{key}");
        let found = keys(&comparison);
        assert!(!found.is_empty() && found.iter().all(|found| *found == key), "{key}: {found:?}");
        assert!(comparison.regressions.is_empty());
    }
}

#[test]
fn another_run_is_refused_by_its_name_and_values() {
    let with = |change: fn(&mut RunFile)| {
        let mut side = base();
        change(&mut side.sources[0].run);
        at_3_percent(&base(), &side).refused
    };
    let refused = with(|run| run.seed = 2);
    assert_eq!(refused.len(), 1);
    let values = (refused[0].key, refused[0].base.as_deref(), refused[0].new.as_deref());
    assert_eq!(values, ("seed", Some("1"), Some("2")));
    let refused = with(|run| run.environment["testbed_id"] = "elsewhere".into());
    assert_eq!(refused[0].key, "testbed_id");
    let refused = with(|run| run.workload_hash = "other".into());
    assert_eq!(refused[0].key, "workload_hash");
    let refused = with(|run| run.environment["build"]["debug_assertions"] = true.into());
    assert_eq!(refused[0].key, "debug_assertions");
    let refused = with(|run| {
        run.seed = 2;
        run.environment = serde_json::Value::Null;
    });
    let keys: Vec<_> = refused.iter().map(|refusal| (refusal.key, &refusal.new)).collect();
    let two = Some("2".to_owned());
    assert_eq!(keys, [("testbed_id", &None), ("debug_assertions", &None), ("seed", &two)]);
}

#[test]
fn what_says_nothing_about_the_time_is_ignored() {
    let mut side = base();
    let environment = &mut side.sources[0].run.environment;
    environment["date"] = "tomorrow".into();
    environment["load_average"] = 7.into();
    environment["machine"]["cpu_mhz"] = 1.into();
    environment["build"]["commit"] = "other".into();
    side.sources[0].run.rows.iter_mut().for_each(|row| row.rounds = Some(1024));
    assert_eq!(at_3_percent(&base(), &side).verdict, Verdict::Same);
}

#[test]
fn rows_that_one_side_lacks_are_listed() {
    let fewer = |keep: fn(&Row) -> bool| side(rows().into_iter().filter(keep).collect());
    let without = fewer(|row| row.id != SUBJECT);
    let comparison = at_3_percent(&base(), &without);
    assert_eq!(comparison.verdict, Verdict::Same);
    assert_eq!((comparison.missing.len(), comparison.added.len()), (2, 0));
    assert_eq!(comparison.missing[0].id, SUBJECT);
    let comparison = at_3_percent(&without, &base());
    assert_eq!((comparison.missing.len(), comparison.added.len()), (0, 2));
    // The file's hash is over fewer rows then, and says nothing.
    let mut shorter = fewer(|row| row.order == "fixed");
    shorter.sources[0].run.workload_hash = "shorter".into();
    assert_eq!(at_3_percent(&base(), &shorter).verdict, Verdict::Same);
}

#[test]
fn one_variant_under_another_order_only_is_refused() {
    let mut rows = rows();
    rows.retain(|row| row.id != SUBJECT || row.order == "fixed");
    let base = side(rows.clone());
    for row in rows.iter_mut().filter(|row| row.id == SUBJECT) {
        row.order = "literal".into();
    }
    let comparison = at_3_percent(&base, &side(rows));
    assert_eq!(keys(&comparison), ["order"]);
    assert!(comparison.refused[0].place.contains(SUBJECT));
}

#[test]
fn nothing_in_common_is_refused() {
    let other = with(|row| row.experiment = "h-5".into());
    assert_eq!(keys(&at_3_percent(&base(), &other)), ["experiment"]);
    let other = with(|row| row.id = format!("x{}", row.id));
    assert_eq!(keys(&at_3_percent(&base(), &other)), ["id"]);
    let other = with(|row| row.code = Some(3));
    assert_eq!(keys(&at_3_percent(&base(), &other)), ["cell"]);
}

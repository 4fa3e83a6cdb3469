//! Forms that are asked without a clock: their names, and a plain hit.

use std::collections::BTreeSet;

use ray_test::oracle::Query;
use ray_test::registry::{Asked, asked, find};
use ray_test::stability::{Form, forms};

const HIT: Query = Query {
    origin: [1.0, 2.0, 0.0],
    direction: [0.0, 0.0, 4.0],
    end: None,
    triangle: [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0]],
    t_min: 0.0,
    t_max: f64::INFINITY,
};

#[test]
fn all_are_named_once_and_as_the_timed_forms_are() {
    let ids: BTreeSet<String> = asked().iter().map(Asked::id).collect();
    assert_eq!(ids.len(), asked().len());
    for id in &ids {
        // In f64, single rays are timed in their usual form only.
        let unusual = id.contains("/fused/") || id.contains("/tests=");
        // And no processor is set to flush.
        let untimed = id.contains("/f64/") && unusual || id.ends_with("/subnormals=flushed");
        assert_eq!(find(id).is_none(), untimed, "{id}");
    }
}

#[test]
fn all_find_a_plain_hit_and_its_place() {
    for asked in asked() {
        let answer = (asked.ask)(&HIT);
        assert_eq!(answer.triangle, Some(0), "{}", asked.id());
        assert_eq!(answer.t, 0.5, "{}", asked.id());
        let miss = Query { origin: [3.0, 2.0, 0.0], ..HIT };
        assert_eq!((asked.ask)(&miss).triangle, None, "{}", asked.id());
    }
}

#[test]
fn forms_are_named_by_what_is_unusual_about_them() {
    let all = forms(&[], None).unwrap();
    assert!(all.iter().any(|form| form.name == "moller-trumbore"));
    for (index, form) in all.iter().enumerate() {
        let same = |other: &Form| other.name == form.name && other.precision == form.precision;
        assert!(!all[..index].iter().any(same), "{}", form.name);
    }
    let wanted = ["moller-trumbore/f32/single/sse2/early/first/plain/tuv".to_owned()];
    if cfg!(any(target_arch = "x86", target_arch = "x86_64")) {
        let one = forms(&wanted, None).unwrap();
        assert_eq!(
            one.iter().map(|form| form.name.as_str()).collect::<Vec<_>>(),
            ["moller-trumbore first"]
        );
    }
    let unknown = forms(&["molar".to_owned()], None).map(|_| ()).unwrap_err();
    assert_eq!(unknown.word, "molar");
}

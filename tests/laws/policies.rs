//! Law 1: policies agree.

use super::cases;
use super::exact::reset;
use super::forms::{groups, same};

/// Every form of a group against its first, hits and t, u and v.
#[test]
fn policies_agree_in_exact_arithmetic() {
    let groups = groups();
    let forms: usize = groups.iter().map(|group| group.forms.len()).sum();
    let (mut hits, mut compared) = (0, 0);
    for case in cases::all() {
        for group in &groups {
            let (ray, corners) = (case.ray(group.from_zero), case.triangle());
            let first = group.forms[0].1(&ray, &corners);
            hits += usize::from(first.is_some());
            for (axes, run) in &group.forms[1..] {
                let answer = run(&ray, &corners);
                compared += 1;
                assert!(
                    same(&first, &answer),
                    "{} {} {}: {} {first:?}, {axes} {answer:?}, from zero: {}, {case:?}",
                    group.kernel,
                    group.stored,
                    group.tests,
                    group.forms[0].0,
                    group.from_zero,
                );
            }
            reset();
        }
    }
    println!(
        "{} groups, {forms} forms, {compared} comparisons, {hits} hits of first forms",
        groups.len()
    );
    assert!(groups.iter().all(|group| group.forms.len() >= 4), "a group has nothing to compare");
    assert!(hits >= 10_000, "{hits} hits");
}

//! What counts as slower.

use super::*;

#[test]
fn a_run_is_the_same_as_itself() {
    let comparison = at_3_percent(&base(), &base());
    assert_eq!(comparison.verdict, Verdict::Same);
    assert_eq!((comparison.cells, comparison.not_judged), (6, 0));
    // Also where its own intervals are wider than the threshold: it is one measurement.
    let wide = with(|row| row.ratio_high = row.ratio_high.map(|high| high * 1.2));
    assert_eq!(at_3_percent(&wide, &wide).verdict, Verdict::Same);
}

#[test]
fn a_small_change_is_the_same() {
    let new = with(|row| slow(row, 1.01));
    assert_eq!(at_3_percent(&base(), &new).verdict, Verdict::Same);
    let strict = compare(&base(), &new, "0.005".parse().unwrap());
    assert_eq!(strict.verdict, Verdict::Regressed);
}

#[test]
fn a_slower_kernel_is_named() {
    let new = with(|row| {
        if row.id == SUBJECT && row.order == "fixed" {
            slow(row, 1.05);
        }
    });
    let comparison = at_3_percent(&base(), &new);
    assert_eq!(comparison.verdict, Verdict::Regressed);
    assert_eq!(figures(&comparison.regressions), [(SUBJECT, "cycles_per_test")]);
    let Finding { place, change } = &comparison.regressions[0];
    assert_eq!((place.order.as_str(), place.density), ("fixed", Some(0.5)));
    assert!((change.ratio.unwrap() - 1.05).abs() < 1e-12);
    // Both runs have 0.998 to 1.003 of their estimates.
    assert!((change.low.unwrap() - 1.05 * 0.998 / 1.003).abs() < 1e-12);
    assert!((change.high.unwrap() - 1.05 * 1.003 / 0.998).abs() < 1e-12);
    assert!(comparison.improvements.is_empty() && comparison.unresolved.is_empty());
}

#[test]
fn a_ratio_is_enough_and_cycles_alone_are_not() {
    let no_cycles = |row: &mut Row| {
        row.cycles_per_test = None;
        if row.id == SUBJECT {
            scale_ratio(row, 1.05);
        }
    };
    let comparison = at_3_percent(&with(|row| row.cycles_per_test = None), &with(no_cycles));
    assert_eq!(figures(&comparison.regressions), [(SUBJECT, "ratio_to_reference"); 2]);
    // The reference's own time shows in cycles only.
    assert_eq!(comparison.not_judged, 2);
    let no_ratio = |factor: f64| {
        move |row: &mut Row| {
            (row.ratio_to_reference, row.ratio_first_half) = (None, None);
            if row.id == SUBJECT {
                scale_cycles(row, factor);
            }
        }
    };
    let comparison = at_3_percent(&with(no_ratio(1.0)), &with(no_ratio(1.05)));
    assert_eq!(figures(&comparison.unresolved), [(SUBJECT, "cycles_per_test"); 2]);
    let neither = with(|row| (row.ratio_to_reference, row.cycles_per_test) = (None, None));
    let comparison = at_3_percent(&base(), &neither);
    assert_eq!((comparison.verdict, comparison.not_judged), (Verdict::Same, 6));
}

#[test]
fn one_half_confirms_nothing() {
    let new = with(|row| {
        if row.id == SUBJECT {
            let first = row.ratio_first_half;
            slow(row, 1.05);
            row.ratio_first_half = first;
        }
    });
    let comparison = at_3_percent(&base(), &new);
    assert_eq!(comparison.verdict, Verdict::Unresolved);
    assert_eq!(figures(&comparison.unresolved), [(SUBJECT, "cycles_per_test"); 2]);
    let no_halves = with(|row| {
        slow(row, 1.05);
        row.ratio_first_half = None;
        row.cycles_second_half = None;
    });
    assert!(at_3_percent(&base(), &no_halves).regressions.is_empty());
}

#[test]
fn a_faster_reference_makes_no_other_slower() {
    let new = with(|row| {
        if row.id == REFERENCE {
            scale_cycles(row, 1.0 / 1.05);
        } else {
            scale_ratio(row, 1.05);
        }
    });
    let comparison = at_3_percent(&base(), &new);
    assert_eq!(comparison.verdict, Verdict::Improved);
    assert_eq!(figures(&comparison.improvements), [(REFERENCE, "cycles_per_test"); 2]);
    // The reference need not be a row.
    let without = |side: Side| {
        let mut rows: Vec<Row> = side.rows().cloned().collect();
        rows.retain(|row| row.id != REFERENCE);
        super::side(rows)
    };
    assert_eq!(at_3_percent(&without(base()), &without(new)).verdict, Verdict::Same);
}

#[test]
fn a_slower_reference_is_slower_itself() {
    let new = with(|row| {
        if row.id == REFERENCE {
            scale_cycles(row, 1.05);
        } else {
            scale_ratio(row, 1.0 / 1.05);
        }
    });
    let comparison = at_3_percent(&base(), &new);
    assert_eq!(figures(&comparison.regressions), [(REFERENCE, "cycles_per_test"); 2]);
    assert!(comparison.improvements.is_empty());
    let unknown = |side: &Side| {
        let mut side = side.clone();
        side.sources[0].run.rows.iter_mut().for_each(|row| row.cycles_first_half = None);
        side
    };
    let comparison = at_3_percent(&unknown(&base()), &unknown(&new));
    assert_eq!(comparison.verdict, Verdict::Unresolved);
    let alone = |side: Side| {
        let mut rows: Vec<Row> = side.rows().cloned().collect();
        rows.retain(|row| row.id == REFERENCE);
        super::side(rows)
    };
    assert_eq!(at_3_percent(&alone(base()), &alone(new)).verdict, Verdict::Unresolved);
}

#[test]
fn a_group_that_is_slower_as_a_whole_is_not_confirmed() {
    // It may as well be the machine: every ratio is what it was.
    let comparison = at_3_percent(&base(), &with(|row| scale_cycles(row, 1.5)));
    assert_eq!(comparison.verdict, Verdict::Unresolved);
    assert_eq!(comparison.unresolved.len(), 6);
    // Nor is one that suffers more than the others do.
    let unequal = with(|row| {
        scale_cycles(row, 1.5);
        if row.id == SUBJECT {
            slow(row, 1.1);
        }
    });
    assert!(at_3_percent(&base(), &unequal).regressions.is_empty());
    // It is where most of the others stayed what they were, whatever the reference did.
    let two = with(|row| match row.id.as_str() {
        REFERENCE => scale_cycles(row, 0.9),
        SUBJECT => {
            slow(row, 1.1);
            scale_ratio(row, 1.0 / 0.9);
        }
        _ => scale_ratio(row, 1.0 / 0.9),
    });
    let third = |mut side: Side| {
        let rows = &mut side.sources[0].run.rows;
        let more: Vec<Row> =
            rows.iter().filter(|row| row.id.starts_with("plucker")).cloned().collect();
        rows.extend(more.into_iter().map(|row| Row { id: "keidy".into(), ..row }));
        side
    };
    let comparison = at_3_percent(&third(base()), &third(two));
    assert_eq!(figures(&comparison.regressions), [(SUBJECT, "cycles_per_test"); 2]);
}

#[test]
fn nanoseconds_judge_nothing() {
    let comparison = at_3_percent(&base(), &with(|row| row.ns_per_test = Some(1e6)));
    assert_eq!(comparison.verdict, Verdict::Same);
}

#[test]
fn below_the_noise_floor_nothing_is_slower_and_nothing_the_same() {
    let noisy = |factor: f64| {
        with(move |row| {
            row.noise_floor = Some(0.08);
            slow(row, factor);
        })
    };
    assert_eq!(at_3_percent(&base(), &noisy(1.05)).verdict, Verdict::Unresolved);
    assert_eq!(at_3_percent(&base(), &noisy(1.1)).verdict, Verdict::Regressed);
    // Where the column is missing, the placebo speaks, and the noisier run counts.
    let placebo = with(|row| {
        row.ratio_placebo = Some(1.0 / 1.08);
        slow(row, 1.05);
    });
    assert_eq!(at_3_percent(&base(), &placebo).verdict, Verdict::Unresolved);
    assert_eq!(at_3_percent(&placebo, &base()).verdict, Verdict::Unresolved);
}

#[test]
fn a_wide_interval_tells_neither() {
    let new = with(|row| {
        if row.id == SUBJECT {
            row.ratio_high = row.ratio_to_reference.map(|ratio| ratio * 1.05);
            scale_cycles(row, 1.001);
        }
    });
    let comparison = at_3_percent(&base(), &new);
    assert_eq!(comparison.verdict, Verdict::Unresolved);
    assert_eq!(figures(&comparison.unresolved), [(SUBJECT, "cycles_per_test"); 2]);
}

#[test]
fn swapped_sides_mirror() {
    let new = with(|row| {
        if row.id == SUBJECT {
            slow(row, 1.05);
        } else if row.id != REFERENCE {
            slow(row, 0.9);
        }
    });
    let (there, back) = (at_3_percent(&base(), &new), at_3_percent(&new, &base()));
    assert_eq!((there.regressions.len(), there.improvements.len()), (2, 2));
    let mirrors = |a: &[Finding], b: &[Finding]| {
        let inverse =
            |a: Option<f64>, b: Option<f64>| (a.unwrap() * b.unwrap() - 1.0).abs() < 1e-12;
        figures(a) == figures(b)
            && a.iter().zip(b).all(|(a, b)| {
                let (a, b) = (&a.change, &b.change);
                inverse(a.ratio, b.ratio) && inverse(a.low, b.high) && inverse(a.high, b.low)
            })
    };
    assert!(mirrors(&there.regressions, &back.improvements));
    assert!(mirrors(&there.improvements, &back.regressions));
}

#[test]
fn the_worst_comes_first() {
    let new = with(|row| {
        if row.id == SUBJECT {
            slow(row, if row.order == "fixed" { 1.05 } else { 1.5 });
        }
    });
    let comparison = at_3_percent(&base(), &new);
    let orders: Vec<_> = comparison.regressions.iter().map(|found| &found.place.order).collect();
    assert_eq!(orders, ["reshuffled", "fixed"]);
}

#[test]
fn codes_have_a_reference_for_each_listing() {
    let of = |id: &str, code: u64, cycles: f64, ratio: f64| {
        let mut row = Row { code: Some(code), ..row(id, "fixed", ratio) };
        scale_cycles(&mut row, cycles / (20.0 * ratio));
        row
    };
    // The hit of listing b gets slower. Mixed up with a's, its reference would seem steady, and
    // its other code faster.
    let rows = |slower: f64| {
        let b = [of("b", 0, 100.0 * slower, 1.0), of("b", 1, 50.0, 0.5 / slower)];
        [of("a", 0, 10.0, 1.0), of("a", 1, 5.0, 0.5), of("a", 2, 4.0, 0.4)].into_iter().chain(b)
    };
    let comparison = at_3_percent(&side(rows(1.0).collect()), &side(rows(1.5).collect()));
    assert_eq!(figures(&comparison.regressions), [("b", "cycles_per_test")]);
    assert!(comparison.improvements.is_empty() && comparison.unresolved.is_empty());
}

#[test]
fn what_was_not_timed_is_not_judged() {
    let new = with(|row| {
        slow(row, 1.5);
        row.status = "skipped".into();
    });
    let comparison = at_3_percent(&base(), &new);
    assert_eq!((comparison.verdict, comparison.not_judged), (Verdict::Same, 6));
    let priced = with(|row| row.price = Some(0.1));
    assert_eq!(at_3_percent(&priced, &priced).not_judged, 6);
}

#[test]
fn thresholds() {
    let of = |text: &str| text.parse::<Threshold>().map(Threshold::percent);
    for (text, percent) in [("3%", 3.0), ("3 %", 3.0), ("0.03", 3.0), ("0.5%", 0.5), ("1000%", 1e3)]
    {
        assert_eq!(of(text), Ok(percent), "{text}");
    }
    for text in ["", "%", "0", "0%", "-3%", "3", "1001%", "NaN", "inf", "nan%", "three", "3%%"] {
        assert_eq!(of(text), Err(ThresholdError), "{text}");
    }
    assert_eq!("3%".parse::<Threshold>().unwrap().to_string(), "3%");
}

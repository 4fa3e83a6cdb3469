//! Medians, intervals, tests and ratios of any numbers.

use super::unit;
use ray_test::stats::{
    CONFIDENCE, Verdict, binomial_half, decide, holm, log_ratios, median, normal_quantile,
    paired_ratio, sign_interval, sign_test,
};
use ray_test::workload::Pcg;

const TURNS: usize = 300;

/// Times with ties, outliers and, where that is asked for, signs.
fn values(pcg: &mut Pcg, signed: bool) -> Vec<f64> {
    let count = 1 + pcg.below(80) as usize;
    let ties = pcg.below(2) == 0;
    let one = |pcg: &mut Pcg| {
        let far = if pcg.below(20) == 0 { 1e6 } else { 1.0 };
        let value = if ties { (1 + pcg.below(5)) as f64 } else { 1.0 + unit(pcg) };
        let sign = if signed && pcg.below(2) == 0 { -1.0 } else { 1.0 };
        value * far * sign
    };
    (0..count).map(|_| one(pcg)).collect()
}

fn shuffled(values: &[f64], pcg: &mut Pcg) -> Vec<f64> {
    let mut other = values.to_vec();
    pcg.shuffle(&mut other);
    other
}

#[test]
fn order_does_not_matter_and_a_power_of_two_is_only_a_unit() {
    let mut pcg = Pcg::new(41);
    for _ in 0..TURNS {
        let given = values(&mut pcg, true);
        let other = shuffled(&given, &mut pcg);
        let scaled: Vec<f64> = given.iter().map(|value| value * 1024.0).collect();
        let middle = median(&given).expect("finite values");
        assert_eq!(median(&other), Some(middle));
        assert_eq!(median(&scaled), Some(middle * 1024.0));
        let interval = sign_interval(&given);
        assert_eq!(sign_interval(&other), interval);
        let unscaled =
            sign_interval(&scaled).map(|scaled| [scaled.low / 1024.0, scaled.high / 1024.0]);
        assert_eq!(unscaled, interval.map(|interval| [interval.low, interval.high]));
        let hypothesis = given[pcg.below(given.len() as u64) as usize];
        assert_eq!(sign_test(&other, hypothesis), sign_test(&given, hypothesis));
        assert_eq!(sign_test(&scaled, hypothesis * 1024.0), sign_test(&given, hypothesis));
    }
}

#[test]
fn a_median_lies_between_its_ends_and_in_its_interval() {
    let mut pcg = Pcg::new(42);
    for _ in 0..TURNS {
        let given = values(&mut pcg, true);
        let middle = median(&given).expect("finite values");
        let (least, most) =
            given.iter().fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(*x), b.max(*x)));
        assert!(least <= middle && middle <= most, "{given:?}");
        assert_eq!(sign_interval(&given).is_some(), given.len() >= 6);
        if let Some(interval) = sign_interval(&given) {
            assert!(
                least <= interval.low && interval.high <= most && interval.contains(middle),
                "{given:?}"
            );
        }
        let p = sign_test(&given, middle).expect("finite values");
        assert!((0.0..=1.0).contains(&p) && p > 1.0 - CONFIDENCE, "{p} of {given:?}");
    }
}

#[test]
fn the_interval_is_what_the_test_does_not_reject_and_farther_is_never_likelier() {
    let mut pcg = Pcg::new(43);
    for _ in 0..TURNS {
        let given = values(&mut pcg, true);
        let middle = median(&given).expect("finite values");
        let mut steps: Vec<f64> =
            given.iter().flat_map(|value| [*value, value * 1.001 + 1e-3]).collect();
        steps.sort_by(f64::total_cmp);
        let tested: Vec<(f64, f64)> = steps
            .iter()
            .map(|step| (*step, sign_test(&given, *step).expect("finite values")))
            .collect();
        for (step, p) in &tested {
            let inside = sign_interval(&given).is_none_or(|interval| interval.contains(*step));
            assert_eq!(inside, *p > 1.0 - CONFIDENCE, "{step} with {p} of {given:?}");
        }
        for pair in tested.windows(2) {
            let [(a, below), (b, above)] = [pair[0], pair[1]];
            assert!(b > middle || below <= above, "{a} and {b} of {given:?}");
            assert!(a < middle || above <= below, "{a} and {b} of {given:?}");
        }
    }
}

#[test]
fn a_binomial_grows_to_one_and_its_halves_mirror_each_other() {
    for n in [1, 2, 5, 6, 64, 257, 1024] {
        let mut before = 0.0;
        for k in 0..=n {
            let p = binomial_half(k, n);
            assert!(before <= p && p <= 1.0, "{k} of {n}");
            if k < n {
                assert!((p + binomial_half(n - 1 - k, n) - 1.0).abs() < 1e-9, "{k} of {n}: {p}");
            }
            before = p;
        }
        assert!((before - 1.0).abs() < 1e-12);
    }
}

#[test]
fn holm_never_lowers_keeps_the_order_and_stays_a_probability() {
    let mut pcg = Pcg::new(44);
    for _ in 0..TURNS {
        let count = pcg.below(30) as usize;
        let raw: Vec<f64> =
            (0..count).map(|_| unit(&mut pcg).powi(1 + pcg.below(20) as i32)).collect();
        let adjusted = holm(&raw).expect("probabilities");
        assert_eq!(adjusted.len(), raw.len());
        for (p, q) in raw.iter().zip(&adjusted) {
            assert!(p <= q && *q <= 1.0 && *q <= p * count as f64 + 1.0);
            for (other, adjusted) in raw.iter().zip(&adjusted) {
                assert!(p > other || q <= adjusted, "{raw:?}");
            }
        }
        let mut places: Vec<usize> = (0..count).collect();
        pcg.shuffle(&mut places);
        let moved: Vec<f64> = places.iter().map(|place| raw[*place]).collect();
        let expected: Vec<f64> = places.iter().map(|place| adjusted[*place]).collect();
        assert_eq!(holm(&moved), Some(expected));
    }
}

#[test]
fn a_ratio_turned_round_is_its_inverse_and_has_no_unit() {
    let mut pcg = Pcg::new(45);
    for _ in 0..TURNS {
        let above = values(&mut pcg, false);
        let below: Vec<f64> = above.iter().map(|_| 1.0 + unit(&mut pcg)).collect();
        let (ratio, turned) = (paired_ratio(&above, &below), paired_ratio(&below, &above));
        assert_eq!(ratio.is_some(), above.len() >= 6);
        let (Some(ratio), Some(turned)) = (ratio, turned) else { continue };
        let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
        assert!(close(ratio.estimate, 1.0 / turned.estimate));
        assert!(close(ratio.low, 1.0 / turned.high) && close(ratio.high, 1.0 / turned.low));
        assert!(
            ratio.low <= ratio.estimate
                && ratio.estimate <= ratio.high
                && ratio.contains(ratio.estimate)
        );
        let scaled = |values: &[f64]| values.iter().map(|value| value * 8.0).collect::<Vec<_>>();
        // Logarithms are taken of each, so that the unit is left out but for rounding.
        let other = paired_ratio(&scaled(&above), &scaled(&below)).expect("as many");
        assert!(close(other.estimate, ratio.estimate));
        assert!(close(other.low, ratio.low) && close(other.high, ratio.high));
        let same = paired_ratio(&above, &above).expect("as many");
        assert_eq!([same.estimate, same.low, same.high], [1.0; 3]);
    }
}

#[test]
fn what_is_not_finite_or_not_positive_has_no_figure() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let values = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, bad];
        assert_eq!(median(&values), None);
        assert_eq!(sign_interval(&values), None);
        assert_eq!(sign_test(&values, 1.0), None);
        assert_eq!(holm(&values), None);
        assert_eq!(log_ratios(&values, &[1.0; 7]), None);
        assert_eq!(normal_quantile(bad), None);
    }
    for bad in [0.0, -1.0] {
        assert_eq!(log_ratios(&[bad; 7], &[1.0; 7]), None);
        assert_eq!(log_ratios(&[1.0; 7], &[bad; 7]), None);
    }
    assert_eq!(log_ratios(&[1.0; 7], &[1.0; 6]), None);
}

#[test]
fn nothing_is_called_different_that_is_not_outside_the_margin() {
    let mut pcg = Pcg::new(46);
    for _ in 0..100 {
        let family: Vec<_> = (0..1 + pcg.below(8))
            .filter_map(|_| {
                let shift = 1.0 + (unit(&mut pcg) - 0.5) * 0.2;
                let above: Vec<f64> =
                    (0..64).map(|_| shift * (1.0 + 0.01 * unit(&mut pcg))).collect();
                let below: Vec<f64> = (0..64).map(|_| 1.0 + 0.01 * unit(&mut pcg)).collect();
                Some((paired_ratio(&above, &below)?, log_ratios(&above, &below)?))
            })
            .collect();
        let margin = unit(&mut pcg) * 0.05;
        let decisions = decide(&family, margin).expect("sound figures");
        assert_eq!(decisions.len(), family.len());
        for ((ratio, _), decision) in family.iter().zip(&decisions) {
            match decision.verdict {
                Verdict::Faster => assert!(ratio.estimate < 1.0),
                Verdict::Slower => assert!(ratio.estimate > 1.0),
                Verdict::Same | Verdict::Unresolved { .. } => {}
            }
            assert!((0.0..=1.0).contains(&decision.p_value));
        }
    }
}

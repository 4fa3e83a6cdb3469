//! Groups that take turns.

use super::*;
use std::sync::atomic::Ordering;

/// Two groups: few rounds of the second for each of the first.
fn groups(script: &Script, rounds: [usize; 2]) -> ([Vec<Contestant>; 2], [Protocol; 2]) {
    let with = |rounds| Protocol { rounds, exact_rounds: true, ..protocol(Order::Fixed) };
    ([usual(script, 1000), usual(script, 200)], rounds.map(with))
}

/// Measures them, and tells the number of the group of each block, in the order of time.
fn measure_both(
    script: &Script,
    rounds: [usize; 2],
    progress: &mut dyn FnMut(Progress),
    cancel: &AtomicBool,
) -> Vec<GroupReport> {
    let ([mut one, mut other], protocols) = groups(script, rounds);
    let both = vec![
        Group { contestants: &mut one, protocol: &protocols[0] },
        Group { contestants: &mut other, protocol: &protocols[1] },
    ];
    let clock = &mut script.clock.clone();
    let (counters, forget, ruler) = (&mut NoCounters, &mut Remember, &mut NoRuler);
    let disturbance = &mut Undisturbed;
    let mut surroundings =
        Surroundings { clock, disturbance, counters, forget, ruler, progress, cancel };
    measure_groups(both, &mut surroundings).expect("groups that can be measured")
}

#[test]
fn rounds_of_all_are_spread_over_the_whole_time() {
    let script = Script::default();
    let reports = measure_both(&script, [20, 40], &mut |_| {}, &AtomicBool::new(false));
    assert_eq!((reports[0].rounds, reports[1].rounds), (20, 40));
    let times = |report: &GroupReport| -> Vec<u64> {
        report.trace.iter().map(|round| round.at_ns).collect()
    };
    let [few, many] = [times(&reports[0]), times(&reports[1])];
    for (number, at) in few.iter().enumerate() {
        // One of the first, then two of the second.
        let before = many.iter().filter(|other| *other < at).count();
        assert_eq!(before, 2 * number);
    }
}

#[test]
fn figures_are_those_of_a_group_alone() {
    let script = Script::default();
    let reports = measure_both(&script, [20, 40], &mut |_| {}, &AtomicBool::new(false));
    let script = Script::default();
    let ([mut one, mut other], protocols) = groups(&script, [20, 40]);
    let alone =
        [measure(&mut one, &protocols[0], &script), measure(&mut other, &protocols[1], &script)];
    for (report, alone) in reports.iter().zip(&alone) {
        for (figures, alone) in report.figures.iter().zip(&alone.figures) {
            assert_eq!(figures, alone);
        }
    }
}

#[test]
fn what_slows_the_machine_for_a_while_is_seen_by_both_alike() {
    let script = Script::default();
    let slowness = Rc::clone(&script.slowness);
    // Three times as slow over the second half of all blocks.
    let mut progress = |p: Progress| {
        slowness.set(if 2 * p.done_blocks < p.total_blocks { 1 } else { 3 });
    };
    let reports = measure_both(&script, [20, 40], &mut progress, &AtomicBool::new(false));
    for report in &reports {
        let slow = report.figures[0].samples.iter().filter(|ns| **ns > 8.0).count();
        assert_eq!(2 * slow, report.rounds);
    }
}

#[test]
fn progress_is_that_of_all_of_them() {
    let script = Script::default();
    let mut seen = Vec::new();
    let mut progress = |p: Progress| seen.push((p.done_blocks, p.total_blocks));
    measure_both(&script, [8, 16], &mut progress, &AtomicBool::new(false));
    let all = 5 * (8 + 16);
    assert_eq!(seen, (1..=all).map(|done| (done, all)).collect::<Vec<_>>());
}

#[test]
fn all_of_them_end_with_the_present_block() {
    let script = Script::default();
    let cancel = AtomicBool::new(false);
    let mut progress = |p: Progress| {
        if p.done_blocks == 5 * 3 * 9 + 2 {
            cancel.store(true, Ordering::Relaxed);
        }
    };
    let reports = measure_both(&script, [20, 40], &mut progress, &cancel);
    assert!(reports.iter().all(|report| report.cancelled));
    // Nine turns, and what was cut short of the tenth counts for nothing.
    assert_eq!((reports[0].rounds, reports[1].rounds), (9, 18));
}

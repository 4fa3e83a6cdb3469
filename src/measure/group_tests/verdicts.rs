//! What is said of a contestant: verdicts, guards, cycles, cold calls.

use super::*;
use crate::stats::Verdict;

fn word(report: &GroupReport, id: &str) -> Option<&'static str> {
    let figures = report.figures.iter().find(|f| f.id == id).expect("is there");
    figures.decision.map(|decision| decision.verdict.word())
}

#[test]
fn every_verdict_is_reached() {
    let script = Script::default();
    let others = [
        ("slower", Role::Subject, 1020),
        ("faster", Role::Subject, 980),
        ("same", Role::Subject, 1005),
    ];
    let report = measure(&mut with(&script, &others), &protocol(Order::Fixed), &script);
    for (id, ..) in others {
        assert_eq!(word(&report, id), Some(id));
    }
    for control in ["reference", "chain", "empty"] {
        assert_eq!(word(&report, control), None);
    }
    assert_eq!(report.noise_floor, 0.002);
}

#[test]
fn few_rounds_of_a_wavering_contestant_decide_nothing() {
    let script = Script::default();
    let mut group = with(&script, &[("wavering", Role::Subject, 1010)]);
    let mut last = 0;
    let slowness = Rc::clone(&script.slowness);
    slowness.set(100);
    // Every block takes up to 4 % more or less than the one before it.
    let mut progress = |p: Progress| {
        last = (last * 7 + p.done_blocks as u64 * 3 + 1) % 9;
        slowness.set(96 + last);
    };
    let never = AtomicBool::new(false);
    let few = Protocol { rounds: 8, ..Protocol::new(Order::Fixed, 3) };
    let report = measure_with(&mut group, &few, &script, &mut Undisturbed, &mut progress, &never);
    let decision = report.figures[3].decision.expect("has a ratio");
    assert!(
        matches!(decision.verdict, Verdict::Unresolved { more_rounds: Some(1..) }),
        "{decision:?}"
    );
}

#[test]
fn no_difference_below_what_copies_differ_by() {
    let script = Script::default();
    // A copy that lies badly: 3 % slower. A subject 2 % slower says nothing then.
    let others = [("copy", Role::Placebo, 1030), ("subject", Role::Subject, 1020)];
    let report = measure(&mut with(&script, &others), &protocol(Order::Fixed), &script);
    assert!((report.noise_floor - 0.03).abs() < 1e-9);
    assert_eq!(word(&report, "subject"), Some("same"));
    let others = [("copy", Role::Placebo, 1030), ("subject", Role::Subject, 1040)];
    let report = measure(&mut with(&script, &others), &protocol(Order::Fixed), &script);
    assert_eq!(word(&report, "subject"), Some("slower"));
}

#[test]
fn swapping_two_contestants_inverts_the_ratio_and_the_verdict() {
    let script = Script::default();
    let ratio = |reference: u64, subject_ns: u64| {
        let mut group = with(&script, &[("subject", Role::Subject, subject_ns)]);
        group[0] =
            subject("reference", Role::Reference, ScriptedJob::new(&script, 100, reference)).0;
        let report = measure(&mut group, &protocol(Order::Fixed), &script);
        (report.figures[3].ratio_to_reference.expect("has one"), word(&report, "subject"))
    };
    let ((forth, slower), (back, faster)) = (ratio(1000, 1100), ratio(1100, 1000));
    assert!((forth.estimate * back.estimate - 1.0).abs() < 1e-12);
    assert_eq!((slower, faster), (Some("slower"), Some("faster")));
}

#[test]
fn scaling_all_times_changes_no_ratio_and_no_verdict() {
    let others = [("subject", Role::Subject, 1015), ("copy", Role::Placebo, 1001)];
    let [once, thrice] = [1, 3].map(|scale| {
        let script = Script::default();
        script.slowness.set(scale);
        let report = measure(&mut with(&script, &others), &protocol(Order::Fixed), &script);
        let figures = &report.figures[3];
        (figures.ratio_to_reference, figures.decision, figures.cycles_per_test, report.noise_floor)
    });
    assert_eq!(once, thrice);
}

#[test]
fn what_takes_no_longer_than_the_empty_loop_is_invalid() {
    let script = Script::default();
    let others = [("gone", Role::Subject, 1)];
    let report = measure(&mut with(&script, &others), &protocol(Order::Fixed), &script);
    assert_eq!(report.figures[3].status, Status::Invalid(Invalid::LikeNothing));
    assert_eq!((report.figures[3].ns_per_test, report.figures[3].decision), (None, None));
}

#[test]
fn what_takes_less_than_its_operations_is_invalid() {
    let script = Script::default();
    let mut group = with(&script, &[("bounded", Role::Subject, 1000)]);
    // The chain's step of 500 ns is two cycles, so a test is four.
    group[3].least_cycles = 4.5;
    let report = measure(&mut group, &protocol(Order::Fixed), &script);
    let wanted = Invalid::TooFast { cycles: 4.0, least: 4.5 };
    assert_eq!(report.figures[3].status, Status::Invalid(wanted));
    group[3].least_cycles = 3.9;
    let report = measure(&mut group, &protocol(Order::Fixed), &script);
    assert_eq!(report.figures[3].status, Status::Ok);
}

#[test]
fn work_that_does_not_grow_with_the_repeats_is_invalid() {
    let script = Script::default();
    let mut group = with(&script, &[]);
    let mut folded = ScriptedJob::new(&script, 100, 0);
    folded.once_ns = 40_000;
    group.push(subject("folded", Role::Subject, folded).0);
    let report = measure(&mut group, &protocol(Order::Fixed), &script);
    let status = &report.figures[3].status;
    assert!(matches!(status, Status::Invalid(Invalid::NoMoreForMore { .. })), "{status:?}");
}

#[test]
fn a_set_that_is_forgotten_between_two_turns_is_seen() {
    let script = Script::default();
    let mut group = with(&script, &[("remembers", Role::Subject, 1000)]);
    // Three passes before each block teach the one, and not the other.
    for (id, learned_in) in [("learns", 3), ("forgets", 4)] {
        let mut job = ScriptedJob::new(&script, 100, 1000);
        job.learned_in = learned_in;
        group.push(subject(id, Role::Subject, job).0);
    }
    let report = measure(&mut group, &protocol(Order::Fixed), &script);
    let ratios: Vec<_> = report.figures[3..].iter().map(|figures| figures.solo_ratio).collect();
    assert_eq!(ratios, [Some(1.0), Some(1.0), Some(2.0)]);
    let literal = measure(&mut group, &protocol(Order::Literal), &script);
    assert!(literal.figures.iter().all(|figures| figures.solo_ratio.is_none()));
}

#[test]
fn a_cold_block_is_one_item_after_everything_was_forgotten() {
    struct Log(Vec<String>);
    impl Forget for Log {
        fn forget(&mut self, id: &str) {
            self.0.push(id.to_owned());
        }
    }
    let script = Script::default();
    let (contestant, calls) = subject("one", Role::Subject, ScriptedJob::new(&script, 50, 7));
    let (other, _) = subject("other", Role::Reference, ScriptedJob::new(&script, 50, 7));
    let mut log = Log(Vec::new());
    let cold = Protocol { pace: Pace::Cold, ..protocol(Order::Reshuffled) };
    let mut surroundings = Surroundings {
        clock: &mut script.clock.clone(),
        disturbance: &mut Undisturbed,
        counters: &mut NoCounters,
        forget: &mut log,
        ruler: &mut NoRuler,
        progress: &mut |_| {},
        cancel: &AtomicBool::new(false),
    };
    let report = measure_group(&mut [contestant, other], &cold, &mut surroundings);
    let report = report.expect("can be measured");
    assert_eq!(report.figures[0].samples, [7.0; 20]);
    assert_eq!((log.0.len(), log.0.iter().filter(|id| *id == "one").count()), (40, 20));
    let blocks = timed_blocks(&calls);
    let firsts: Vec<usize> = blocks.iter().map(|block| block.first).collect();
    assert_eq!(firsts, (0..20).collect::<Vec<_>>());
    assert!(blocks.iter().all(|block| (block.items, block.repeats) == (1, 1)));
}

#[test]
fn a_round_that_the_clock_and_the_cycles_disagree_on_is_dropped() {
    let script = Script::default();
    let mut group = with(&script, &[("subject", Role::Subject, 1000)]);
    let slowness = Rc::clone(&script.slowness);
    slowness.set(10);
    // The whole twelfth round runs at two thirds of the speed.
    let mut progress =
        |p: Progress| slowness.set(if (44..48).contains(&p.done_blocks) { 15 } else { 10 });
    let never = AtomicBool::new(false);
    let fixed = protocol(Order::Fixed);
    let report = measure_with(&mut group, &fixed, &script, &mut Undisturbed, &mut progress, &never);
    assert_eq!((report.rounds, report.dirty_rounds), (20, 1));
    assert_eq!(report.figures[3].samples, [10_000.0; 20]);
}

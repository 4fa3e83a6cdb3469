//! Figures, rounds that are dropped, contestants that fail.

use super::*;
use std::sync::atomic::Ordering;

/// Counts one disturbance at each of the readings listed (from 0; two readings a round).
struct DisturbedAt {
    readings: Vec<usize>,
    next: usize,
    count: u64,
}

impl DisturbedAt {
    fn readings(readings: &[usize]) -> Self {
        DisturbedAt { readings: readings.to_vec(), next: 0, count: 5 }
    }
}

impl Disturbance for DisturbedAt {
    fn count(&mut self) -> Option<u64> {
        self.count += u64::from(self.readings.contains(&self.next));
        self.next += 1;
        Some(self.count)
    }
}

#[test]
fn figures_come_out_exactly_in_every_order() {
    for order in [Order::Literal, Order::Fixed, Order::Reshuffled] {
        let script = Script::default();
        let report = measure(&mut usual(&script, 1000), &protocol(order), &script);
        let figures = |id: &str| report.figures.iter().find(|f| f.id == id).expect("is there");
        assert_eq!((report.rounds, report.dirty_rounds), (20, 0));
        let slow = figures("slow");
        assert_eq!(slow.status, Status::Ok, "{order}");
        assert_eq!(slow.samples, [8.0; 20], "{order}");
        assert_eq!((slow.ns_per_test, slow.min_ns), (Some(8.0), Some(8.0)));
        assert_eq!((slow.ns_low, slow.ns_high), (Some(8.0), Some(8.0)));
        assert_eq!(slow.cycles_per_test, Some(16.0));
        assert_eq!(slow.empty_loop_ratio, Some(0.125));
        assert!(is_near(slow.ratio_to_reference, 2.0));
        assert!(is_near(slow.ratio_first_half, 2.0) && is_near(slow.ratio_second_half, 2.0));
        assert!(is_near(figures("placebo").ratio_to_reference, 1.0));
        assert_eq!(figures("chain").cycles_per_test, Some(2.0));
        assert_eq!(figures("chain").ratio_to_reference, None);
        assert_eq!(report.placebo_floor, Some(0.0));
    }
}

#[test]
fn tests_of_an_item_share_its_time() {
    let script = Script::default();
    let job = ScriptedJob::new(&script, 48, 512).with_tests_per_item(256);
    let mut group = [subject("nearest", Role::Subject, job).0];
    let report = measure(&mut group, &protocol(Order::Fixed), &script);
    assert_eq!(report.figures[0].ns_per_test, Some(2.0));
    // Four windows.
    assert_eq!(report.figures[0].tests_per_block, 12 * 256 * report.figures[0].repeats as u64);
    assert_eq!(report.figures[0].ratio_to_reference, None);
}

#[test]
fn drift_common_to_all_changes_no_ratio() {
    let script = Script::default();
    let mut group = usual(&script, 1000);
    let slowness = Rc::clone(&script.slowness);
    // A machine that gets slower by 1 % of its first speed from round to round.
    slowness.set(100);
    let mut progress = |p: Progress| slowness.set(100 + (p.done_blocks / 5) as u64);
    let never = AtomicBool::new(false);
    let report = measure_with(
        &mut group,
        &protocol(Order::Fixed),
        &script,
        &mut Undisturbed,
        &mut progress,
        &never,
    );
    let slow = &report.figures[2];
    assert_eq!((slow.min_ns, slow.samples[19]), (Some(8.0 * 100.0), 8.0 * 119.0));
    assert!(is_near(slow.ratio_to_reference, 2.0));
    assert_eq!(slow.cycles_per_test, Some(16.0));
}

#[test]
fn wrong_tally_withholds_the_figures() {
    let script = Script::default();
    let mut group = usual(&script, 1000);
    let mut wrong = ScriptedJob::new(&script, 1000, 1);
    wrong.wrong_from = Some(40);
    let (contestant, calls) = subject("wrong", Role::Subject, wrong);
    group.push(contestant);
    let report = measure(&mut group, &protocol(Order::Fixed), &script);
    let figures = &report.figures[5];
    assert!(matches!(figures.status, Status::Invalid(Invalid::Tally { round }) if round > 0));
    assert_eq!((figures.ns_per_test, figures.ratio_to_reference), (None, None));
    assert!(figures.samples.is_empty());
    // It was not run again, and nobody else suffered.
    assert_eq!(timed_blocks(&calls).len(), 41);
    assert!(report.figures[..5].iter().all(|f| f.status == Status::Ok && f.samples.len() == 24));
}

#[test]
fn wrong_number_of_hits_is_never_timed() {
    let script = Script::default();
    let (right, _) = subject("right", Role::Subject, ScriptedJob::new(&script, 100, 4));
    let (wrong, calls) = subject("wrong", Role::Subject, ScriptedJob::new(&script, 100, 4));
    let mut group = [right.with_hits(50), wrong.with_hits(49)];
    let report = measure(&mut group, &protocol(Order::Fixed), &script);
    assert_eq!(report.figures[0].status, Status::Ok);
    let reason = Invalid::Hits { expected: 49, found: 50 };
    assert_eq!(report.figures[1].status, Status::Invalid(reason));
    assert!(timed_blocks(&calls).is_empty());
}

#[test]
fn code_that_was_optimised_away_is_invalid() {
    let script = Script::default();
    let mut group = [subject("gone", Role::Subject, ScriptedJob::new(&script, 1 << 20, 0)).0];
    let few = Protocol { rounds: 8, ..Protocol::new(Order::Fixed, 1) };
    let report = measure(&mut group, &few, &script);
    assert_eq!(report.figures[0].status, Status::Invalid(Invalid::NoTime));
}

#[test]
fn dirty_rounds_are_dropped_whole_counted_and_run_again() {
    let script = Script::default();
    let mut group = usual(&script, 1000);
    // Odd readings end a round: the 4th and the 7th round run are dirty. Reading 12 lies between
    // two rounds and harms nobody.
    let mut disturbance = DisturbedAt::readings(&[7, 12, 13]);
    let never = AtomicBool::new(false);
    let fixed = protocol(Order::Fixed);
    let mut last = Progress { done_blocks: 0, total_blocks: 0 };
    let mut progress = |p| last = p;
    let report = measure_with(&mut group, &fixed, &script, &mut disturbance, &mut progress, &never);
    assert_eq!((report.rounds, report.dirty_rounds), (20, 2));
    assert!(report.figures.iter().all(|f| f.samples.len() == 20 && f.dirty_rounds == 2));
    let dirty =
        |(place, round): (usize, &RoundTrace)| (round.state == RoundState::Dirty).then_some(place);
    let dirty: Vec<usize> = report.trace.iter().enumerate().filter_map(dirty).collect();
    assert_eq!((report.trace.len(), dirty), (22, vec![3, 6]));
    assert!(report.trace.iter().all(|round| round.reference_ns_per_test == Some(4.0)));
    assert!(report.trace.is_sorted_by(|one, next| one.at_ns < next.at_ns));
    assert_eq!(report.trace.last().map(|round| round.at_ns), Some(script.clock.time().get()));
    assert_eq!(last, Progress { done_blocks: 110, total_blocks: 110 });
}

#[test]
fn beyond_eight_clean_rounds_a_quarter_is_run_again_at_most() {
    let script = Script::default();
    let mut group = usual(&script, 1000);
    // Eight clean rounds, then no other: the spares are five, and eleven windows remain besides
    // the one that takes them all.
    let every: Vec<usize> = (17..200).filter(|r| r % 2 == 1).collect();
    let never = AtomicBool::new(false);
    let fixed = protocol(Order::Fixed);
    let mut disturbance = DisturbedAt::readings(&every);
    let report = measure_with(&mut group, &fixed, &script, &mut disturbance, &mut |_| {}, &never);
    assert_eq!((report.rounds, report.dirty_rounds), (8, 12 + 5));
}

#[test]
fn a_machine_that_is_never_quiet_is_given_up() {
    let script = Script::default();
    let mut group = usual(&script, 1000);
    let every: Vec<usize> = (0..200).filter(|r| r % 2 == 1).collect();
    let never = AtomicBool::new(false);
    let fixed = protocol(Order::Fixed);
    let mut disturbance = DisturbedAt::readings(&every);
    let report = measure_with(&mut group, &fixed, &script, &mut disturbance, &mut |_| {}, &never);
    // Four times the twenty rounds that were planned.
    assert_eq!((report.rounds, report.dirty_rounds), (0, 80));
    assert!(report.figures.iter().all(|f| f.status == Status::Invalid(Invalid::NoRound)));
}

#[test]
fn cancelling_ends_with_the_block_and_keeps_whole_rounds() {
    let script = Script::default();
    let fixed = protocol(Order::Fixed);
    // In the middle of the tenth round, and of the seventh: too early for figures that stand.
    for (block, rounds, stands) in [(47, 9, true), (32, 6, false)] {
        let mut group = usual(&script, 1000);
        let cancel = AtomicBool::new(false);
        let mut done = 0;
        let mut progress = |p: Progress| {
            done = p.done_blocks;
            cancel.store(done >= block, Ordering::Relaxed);
        };
        let report =
            measure_with(&mut group, &fixed, &script, &mut Undisturbed, &mut progress, &cancel);
        assert!(report.cancelled);
        assert_eq!((done, report.rounds, report.planned_rounds), (block, rounds, 20));
        assert_eq!(report.figures[2].samples, vec![8.0; rounds]);
        assert!(is_near(report.figures[2].ratio_to_reference, 2.0));
        assert_eq!(report.figures[2].ratio_first_half, None);
        let interrupted = Status::Invalid(Invalid::Interrupted { rounds });
        let status = if stands { Status::Ok } else { interrupted };
        assert!(report.figures.iter().all(|f| f.status == status), "{block}");
    }
}

#[test]
fn cancelled_before_it_began() {
    let script = Script::default();
    let mut group = usual(&script, 10);
    let cancel = AtomicBool::new(true);
    let fixed = protocol(Order::Fixed);
    let report = measure_with(&mut group, &fixed, &script, &mut Undisturbed, &mut |_| {}, &cancel);
    assert_eq!((report.cancelled, report.rounds), (true, 0));
}

#[test]
fn refused_groups_run_nothing() {
    let script = Script::default();
    let refused = |group: &mut [Contestant]| {
        let clock = &mut script.clock.clone();
        let (progress, cancel) = (&mut |_| {}, &AtomicBool::new(false));
        let disturbance = &mut Undisturbed;
        let (counters, forget, ruler) = (&mut NoCounters, &mut Remember, &mut NoRuler);
        let mut surroundings =
            Surroundings { clock, disturbance, counters, forget, ruler, progress, cancel };
        measure_group(group, &protocol(Order::Fixed), &mut surroundings).err()
    };
    let new = |id: &str, role, items| subject(id, role, ScriptedJob::new(&script, items, 4)).0;
    assert_eq!(refused(&mut []), Some(ProtocolError::Nobody));
    let mut same = [new("a", Role::Subject, 9), new("a", Role::Subject, 9)];
    assert_eq!(refused(&mut same), Some(ProtocolError::SameId("a".into())));
    let mut two = [new("a", Role::Reference, 9), new("b", Role::Reference, 9)];
    assert_eq!(refused(&mut two), Some(ProtocolError::SameRole("reference")));
    let mut none = [new("a", Role::Subject, 0)];
    assert!(matches!(refused(&mut none), Some(ProtocolError::Items { items: 0, .. })));
    assert_eq!(script.clock.readings().get(), 0);
}

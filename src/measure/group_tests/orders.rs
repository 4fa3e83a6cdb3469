//! What the branch predictor is shown, in each order.

use super::*;

#[test]
fn reshuffled_shows_no_order_twice_and_none_before_its_time() {
    let script = Script::default();
    let (contestant, calls) = subject("one", Role::Subject, ScriptedJob::new(&script, 4000, 20));
    let (other, _) = subject("other", Role::Reference, ScriptedJob::new(&script, 4000, 10));
    measure(&mut [contestant, other], &protocol(Order::Reshuffled), &script);
    let calls: Vec<Call> =
        calls.borrow().iter().filter(|call| **call != Call::Relocate).cloned().collect();
    let first = calls.iter().position(|c| matches!(c, Call::Permute(_))).expect("is permuted");
    // Before: every item once by itself in the original order. At the end: that order again.
    assert_eq!(first, 4000);
    let (rounds, end) = (&calls[first..calls.len() - 1], &calls[calls.len() - 1]);
    assert_eq!(*end, Call::Permute((0..4000).collect()));
    let mut orders = std::collections::BTreeSet::new();
    // Three to cut the blocks. Then the last of them again and again, to see that twice the work takes
    // twice the time.
    let (trials, rounds) = rounds.split_at(2 * 3);
    let rounds =
        &rounds[rounds.iter().take_while(|call| matches!(call, Call::Run { .. })).count() - 1..];
    assert_eq!(rounds.len(), 3 * 20);
    // Before each round a quarter of a block in the order of the last one, which is over.
    let before =
        |call: &Call| matches!(call, Call::Run { block, timed: false } if block.items <= 1000);
    assert!(rounds.iter().step_by(3).all(before));
    for pair in trials.chunks(2).chain(rounds.chunks(3).map(|round| &round[1..])) {
        let [Call::Permute(order), Call::Run { block, timed: true }] = pair else {
            panic!("not one timed run per order: {pair:?}");
        };
        assert_eq!((block.first, block.repeats), (0, 1));
        assert_eq!(block.items, 4000);
        assert!(orders.insert(order.clone()));
    }
}

#[test]
fn reshuffled_takes_a_prefix_of_what_is_too_long() {
    let script = Script::default();
    let (contestant, calls) = subject("one", Role::Subject, ScriptedJob::new(&script, 25_000, 12));
    let report = measure(&mut [contestant], &protocol(Order::Reshuffled), &script);
    assert_eq!(report.figures[0].samples, [12.0; 20]);
    let blocks = timed_blocks(&calls);
    assert!(blocks[9..].iter().all(|b| (b.first, b.items, b.repeats) == (0, 5000, 1)));
}

#[test]
fn literal_repeats_in_a_row_and_visits_every_item() {
    let script = Script::default();
    let (contestant, calls) = subject("one", Role::Subject, ScriptedJob::new(&script, 1000, 4));
    let (slow, slow_calls) = subject("slow", Role::Subject, ScriptedJob::new(&script, 1000, 16));
    let report = measure(&mut [contestant, slow], &protocol(Order::Literal), &script);
    let rounds = |calls: &Calls| {
        let blocks = timed_blocks(calls);
        blocks[blocks.len() - 20..].to_vec()
    };
    let windows = report.figures[0].windows;
    assert_eq!(report.figures[1].windows, windows);
    let mut visits = vec![0; 1000];
    for (fast, slow) in rounds(&calls).into_iter().zip(rounds(&slow_calls)) {
        assert!(fast.literal && slow.literal);
        assert!(fast.repeats >= 128 && slow.repeats >= 128);
        assert_eq!((fast.first, fast.items), (slow.first, slow.items));
        visits[fast.first..fast.first + fast.items].iter_mut().for_each(|v| *v += 1);
    }
    assert!(visits.iter().all(|&v| v >= 1));
    // Untimed is only the first item of a block, once: what it teaches the second item contradicts.
    let untimed = |call: &&Call| matches!(call, Call::Run { timed: false, .. });
    let calls = calls.borrow();
    let warming: Vec<&Call> = calls.iter().skip(1000).filter(untimed).collect();
    let one = |call: &&Call| matches!(call, Call::Run { block, .. } if (block.items, block.repeats) == (1, 1));
    // Twice three of them are there to see that twice the work takes twice the time.
    assert!(warming.len() == 6 + 20 && warming.iter().all(one));
}

#[test]
fn fixed_warms_up_on_the_block_and_freezes_the_repeats() {
    let script = Script::default();
    let (contestant, calls) = subject("one", Role::Subject, ScriptedJob::new(&script, 1000, 4));
    let slowness = Rc::clone(&script.slowness);
    let mut progress = |p: Progress| slowness.set(1 + p.done_blocks as u64);
    let never = AtomicBool::new(false);
    let fixed = protocol(Order::Fixed);
    measure_with(&mut [contestant], &fixed, &script, &mut Undisturbed, &mut progress, &never);
    let calls = calls.borrow();
    let whole = Block { first: 0, items: 1000, repeats: 1, literal: false };
    // Half a block of 15 passes, rounded up, before each of 20, where the data are now.
    for turn in calls[calls.len() - 20 * 10..].chunks(10) {
        let (before, timed) = turn.split_at(9);
        let (moved, warming) = before.split_at(1);
        assert_eq!(moved, [Call::Relocate]);
        assert!(warming.iter().all(|call| *call == Call::Run { block: whole, timed: false }));
        assert_eq!(timed, [Call::Run { block: Block { repeats: 15, ..whole }, timed: true }]);
    }
}

#[test]
fn every_block_finds_its_data_elsewhere_but_that_of_a_walk() {
    for order in [Order::Literal, Order::Fixed, Order::Reshuffled] {
        let script = Script::default();
        let (one, calls) = subject("one", Role::Subject, ScriptedJob::new(&script, 1000, 4));
        measure(&mut [one], &protocol(order), &script);
        let calls = calls.borrow();
        let is_timed = |call: &Call| matches!(call, Call::Run { timed: true, .. });
        let blocks: Vec<&[Call]> =
            calls.split_inclusive(is_timed).filter(|b| is_timed(&b[b.len() - 1])).collect();
        let moves = |block: &&[Call]| block.iter().filter(|call| **call == Call::Relocate).count();
        assert!(blocks[blocks.len() - 20..].iter().all(|block| moves(block) == 1), "{order}");
    }
    let calls = walk(&Script::default(), 4000, 1200, &mut Undisturbed);
    assert!(!calls.contains(&Call::Relocate));
}

#[test]
fn long_sets_are_cut_into_windows_that_packets_share() {
    let script = Script::default();
    let rays = ScriptedJob::new(&script, 240, 2560).with_tests_per_item(256);
    let packets = ScriptedJob::new(&script, 30, 5120).with_tests_per_item(2048);
    let (rays, ray_calls) = subject("rays", Role::Reference, rays);
    let (packets, packet_calls) = subject("packets", Role::Subject, packets);
    let report = measure(&mut [rays, packets], &protocol(Order::Fixed), &script);
    // 240 x 2.56 us are 11 blocks of 60 us, but 122 880 tests are 31 times what is remembered, and
    // there are 30 packets.
    assert_eq!((report.figures[0].windows, report.figures[1].windows), (30, 30));
    assert_eq!(report.figures[1].samples, [2.5; 20]);
    assert!(is_near(report.figures[1].ratio_to_reference, 0.25));
    let last = |calls: &Calls| timed_blocks(calls).split_off(timed_blocks(calls).len() - 20);
    for (rays, packets) in last(&ray_calls).iter().zip(last(&packet_calls)) {
        assert_eq!(rays.first / 8, packets.first);
        assert_eq!((rays.first + rays.items) / 8, packets.first + packets.items);
    }
}

/// Blocks of a walk and what was done before each, in 20 rounds.
fn walk(
    script: &Script,
    items: usize,
    cost_ns: u64,
    disturbance: &mut dyn Disturbance,
) -> Vec<Call> {
    let (one, calls) = subject("one", Role::Subject, ScriptedJob::new(script, items, cost_ns));
    let walk = Protocol { pace: Pace::Walk, ..protocol(Order::Fixed) };
    let never = AtomicBool::new(false);
    measure_with(&mut [one], &walk, script, disturbance, &mut |_| {}, &never);
    let calls = calls.borrow();
    let blocks = calls.iter().rposition(|call| matches!(call, Call::Run { timed: false, .. }));
    calls[blocks.map_or(0, |last| last + 1)..].to_vec()
}

#[test]
fn a_walk_goes_on_where_it_was_and_every_item_comes_once() {
    // 4000 items of 1.2 us are 80 blocks; 50 of them a block.
    let calls = walk(&Script::default(), 4000, 1200, &mut Undisturbed);
    // Three to cut the blocks and twice three to see that twice the work takes twice the time.
    let (trials, rounds) = calls.split_at(calls.len() - 2 * 20);
    assert_eq!(trials.len(), 2 * (3 + 6));
    for (round, pair) in rounds.chunks(2).enumerate() {
        let block = Block { first: 50 * round, items: 50, repeats: 1, literal: false };
        assert_eq!(pair, [Call::Approach(block), Call::Run { block, timed: true }]);
    }
    // What was tried out lies elsewhere.
    let tried = trials.iter().filter_map(|call| match call {
        Call::Run { block, .. } => Some(block.first),
        _ => None,
    });
    assert!(tried.clone().count() == 9 && tried.min() >= Some(20 * 50));
}

#[test]
fn a_walk_that_is_disturbed_does_not_come_back() {
    /// Another count before and after the sixth block: a round asks before, around its block, and
    /// the walk does not mind the last time.
    struct Once(u32);
    impl Disturbance for Once {
        fn count(&mut self) -> Option<u64> {
            self.0 += 1;
            Some(u64::from(self.0 > 5 * 3 + 2))
        }
    }
    let calls = walk(&Script::default(), 4000, 1200, &mut Once(0));
    let timed = |call: &Call| match call {
        Call::Run { block, .. } => Some(block.first),
        _ => None,
    };
    let firsts: Vec<usize> = calls.iter().filter_map(timed).skip(9).collect();
    assert_eq!(firsts, (0..21).map(|block| 50 * block).collect::<Vec<usize>>());
}

#[test]
fn a_walk_over_a_small_set_is_repeated() {
    let calls = walk(&Script::default(), 100, 120, &mut Undisturbed);
    let block = Block { first: 0, items: 100, repeats: 5, literal: false };
    assert_eq!(calls[calls.len() - 2..], [Call::Approach(block), Call::Run { block, timed: true }]);
}

#[test]
fn about_equal_contestants_share_the_count_of_the_reference() {
    let script = Script::default();
    let new = |id: &str, role, cost| subject(id, role, ScriptedJob::new(&script, 1000, cost)).0;
    let mut group = [
        new("near", Role::Subject, 5),
        new("far", Role::Subject, 20),
        new("reference", Role::Reference, 4),
        new("chain", Role::Chain, 5),
    ];
    let report = measure(&mut group, &protocol(Order::Fixed), &script);
    let repeats: Vec<usize> = report.figures.iter().map(|f| f.repeats).collect();
    assert_eq!(repeats, [15, 3, 15, 12]);
    assert!(is_near(report.figures[0].ratio_to_reference, 1.25));
}

#[test]
fn many_contestants_replay_fewer_items_each() {
    let script = Script::default();
    let new = |id: &str| subject(id, Role::Subject, ScriptedJob::new(&script, 6000, 1)).0;
    let mut three = ["a", "b", "c"].map(new);
    let report = measure(&mut three, &protocol(Order::Fixed), &script);
    // 18 000 tests are more than a predictor remembers, a fifth of them are not.
    assert!(report.figures.iter().all(|figures| figures.windows == 5));
    // Eight lanes at once are one walk.
    let mut packets = three.map(|contestant| contestant.with_limits(8, 0.0));
    let report = measure(&mut packets, &protocol(Order::Fixed), &script);
    assert!(report.figures.iter().all(|figures| figures.windows == 1));
}

/// Repeats and windows of contestants with these items, of these costs and least cycles, in 64 rounds.
fn literal_plans(items: usize, costs: &[(u64, f64)]) -> Vec<(usize, usize)> {
    let script = Script::default();
    let new = |(cost, least): &(u64, f64)| {
        let job = ScriptedJob::new(&script, items, *cost);
        subject(&format!("least {least}"), Role::Subject, job).0.with_limits(1, *least)
    };
    let mut group: Vec<Contestant> = costs.iter().map(new).collect();
    let protocol = Protocol { rounds: 64, ..protocol(Order::Literal) };
    let report = measure(&mut group, &protocol, &script);
    report.figures.iter().map(|figures| (figures.repeats, figures.windows)).collect()
}

#[test]
fn a_literal_order_is_cut_and_repeated_alike_where_the_clock_says_nearly_the_same() {
    let plans = |short, long| literal_plans(150, &[(short, 2.0), (long, 9.0)]);
    // 4.5 times as long by what they must do at least: four times as many. 5.1 blocks of 60 us.
    let usual = plans(4, 16);
    assert_eq!(usual, [(512, 4), (128, 4)]);
    assert_eq!(plans(3, 17), usual);
    assert_eq!(plans(5, 13), usual);
}

#[test]
fn a_literal_order_has_no_more_windows_than_can_be_levelled() {
    // 14.9 blocks of 60 us would be 16 windows; 64 rounds come to each of 8 eight times.
    assert_eq!(literal_plans(500, &[(14, 0.0)]), [(128, 8)]);
    // Blocks of 800 us would be too long.
    assert_eq!(literal_plans(500, &[(100, 0.0)]), [(128, 32)]);
}

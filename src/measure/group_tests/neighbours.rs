//! Blocks and rounds beside a neighbour.

use super::*;

/// Says "crowded" at the readings in the list, counted from 0; a cycle is half a nanosecond.
struct Crowded {
    at: std::ops::Range<usize>,
    next: usize,
}

impl Ruler for Crowded {
    fn read(&mut self, _clock: &mut dyn Clock) -> Option<Reading> {
        let crowded = self.at.contains(&self.next);
        self.next += 1;
        Some(Reading { ns_per_cycle: 0.5, crowded })
    }
}

/// Four contestants in 20 rounds beside a neighbour who is there during some readings.
fn beside(at: std::ops::Range<usize>) -> (GroupReport, usize) {
    let script = Script::default();
    let mut group = with(&script, &[("subject", Role::Subject, 1000)]);
    let mut ruler = Crowded { at, next: 0 };
    let mut surroundings = Surroundings {
        clock: &mut script.clock.clone(),
        disturbance: &mut Undisturbed,
        counters: &mut NoCounters,
        forget: &mut Remember,
        ruler: &mut ruler,
        progress: &mut |_| {},
        cancel: &AtomicBool::new(false),
    };
    // Order literal: no blocks are run alone before the rounds.
    let report = measure_group(&mut group, &protocol(Order::Literal), &mut surroundings);
    (report.expect("can be measured"), ruler.next)
}

#[test]
fn blocks_beside_a_neighbour_are_run_again() {
    // One look before the first block, and one after each.
    let (alone, readings) = beside(0..0);
    assert_eq!((alone.rounds, alone.dirty_rounds, readings), (20, 0, 1 + 4 * 20));
    assert_eq!((alone.repeated_blocks, alone.figures[3].cycles_per_test), (0, Some(2000.0)));
    // Seen after a block, before it is run again, and after that; then another time.
    let (visited, readings) = beside(40..43);
    assert_eq!((visited.rounds, visited.dirty_rounds, visited.repeated_blocks), (20, 0, 2));
    assert_eq!(readings, 1 + 4 * 20 + 2 * 2);
    // Eight attempts at a block, and the round is dropped.
    let (crowded, _) = beside(40..55);
    assert_eq!((crowded.rounds, crowded.dirty_rounds, crowded.crowded_share), (19, 1, 0.0));
    let of = |state| crowded.trace.iter().filter(|round| round.state == state).count();
    assert_eq!([RoundState::Clean, RoundState::Crowded].map(of), [19, 1]);
}

#[test]
fn a_neighbour_who_stays_is_told_of_and_no_endless_wait() {
    let (crowded, readings) = beside(0..usize::MAX);
    assert_eq!((crowded.rounds, crowded.dirty_rounds, crowded.crowded_share), (20, 0, 1.0));
    assert!(crowded.trace.iter().all(|round| round.state == RoundState::Crowded));
    // The blocks, and five quarters of them again.
    assert_eq!((crowded.repeated_blocks, readings), (100, 2 * (80 + 100)));
}

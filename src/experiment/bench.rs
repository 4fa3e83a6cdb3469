//! What cells are measured with.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use super::keep::Keep;
use super::patience::Patience;
use crate::measure::{
    Clock, Contestant, Counters, Disturbance, Forget, Group, GroupReport, Order, Progress,
    Protocol, ProtocolError, Ruler, Surroundings, measure_groups,
};

/// Time that a neighbour is given to leave before a group is measured again; twice as long after
/// each few attempts, up to the longest: his long visits were of half a second to some seconds.
const WAIT: Duration = Duration::from_millis(300);
const LONGEST_WAIT: Duration = Duration::from_millis(2400);
const FEW_ATTEMPTS: u32 = 6;

/// What a cell is measured with.
pub struct Bench<'a> {
    /// Rounds of every group.
    pub rounds: usize,
    /// As [`Protocol::guards`].
    pub guards: bool,
    /// Whether single rays are measured as calls, too: how long an answer takes, and a call that was
    /// forgotten.
    pub calls: bool,
    /// What may still be measured again because of a neighbour: he may have gone by then.
    pub patience: &'a mut Patience,
    /// Tells the time.
    pub clock: &'a mut dyn Clock,
    /// Tells whether a round was disturbed.
    pub disturbance: &'a mut dyn Disturbance,
    /// Counts cycles, instructions and mispredictions where the system lets it.
    pub counters: &'a mut dyn Counters,
    /// Makes the processor forget a kernel, for cold calls.
    pub forget: &'a mut dyn Forget,
    /// Tells the length of a cycle, and whether the core is shared.
    pub ruler: &'a mut dyn Ruler,
    /// Called with the number of blocks done since it was last called.
    pub progress: &'a mut dyn FnMut(usize),
    /// Once true, nothing more is begun.
    pub cancel: &'a AtomicBool,
    /// Where rows go as soon as they are final.
    pub keep: &'a mut dyn Keep,
}

impl Bench<'_> {
    /// Measures a group, warm, in this many rounds and tells the progress.
    ///
    /// # Errors
    /// A group that cannot be measured.
    pub fn measure(
        &mut self,
        contestants: &mut [Contestant],
        order: Order,
        seed: u64,
    ) -> Result<GroupReport, ProtocolError> {
        self.measure_as(
            contestants,
            &Protocol { rounds: self.rounds, ..Protocol::new(order, seed) },
        )
    }

    /// Measures a group by a protocol of its own and tells the progress; again, while patience
    /// lasts, if it was beside a neighbour to its end.
    ///
    /// # Errors
    /// A group that cannot be measured.
    pub fn measure_as(
        &mut self,
        contestants: &mut [Contestant],
        protocol: &Protocol,
    ) -> Result<GroupReport, ProtocolError> {
        let reports = self.measure_together(&mut [Group { contestants, protocol }])?;
        reports.into_iter().next().ok_or(ProtocolError::Nobody)
    }

    /// Measures groups that take turns; those that were beside a neighbour to their end again, while
    /// patience lasts.
    ///
    /// # Errors
    /// A group that cannot be measured.
    pub fn measure_together(
        &mut self,
        groups: &mut [Group<'_>],
    ) -> Result<Vec<GroupReport>, ProtocolError> {
        let first = self.measure_once(groups.iter_mut().collect())?;
        let (mut reports, times): (Vec<GroupReport>, Vec<Duration>) = first.into_iter().unzip();
        let (mut wait, mut attempts) = (WAIT, 0);
        loop {
            let granted = self.granted(&reports, &times, wait);
            if granted.is_empty() {
                return Ok(reports);
            }
            std::thread::sleep(wait);
            attempts += 1;
            if attempts % FEW_ATTEMPTS == 0 {
                wait = (2 * wait).min(LONGEST_WAIT);
            }
            let chosen = groups.iter_mut().enumerate().filter(|(place, _)| granted.contains(place));
            let again = self.measure_once(chosen.map(|(_, group)| group).collect())?;
            for (place, (again, _)) in granted.into_iter().zip(again) {
                // Never given up for one that was cut short.
                if !again.cancelled {
                    reports[place] = again;
                }
            }
        }
    }

    /// Which of the groups that were beside a neighbour to their end may be measured again after a
    /// wait.
    fn granted(
        &mut self,
        reports: &[GroupReport],
        times: &[Duration],
        wait: Duration,
    ) -> Vec<usize> {
        if self.cancel.load(Ordering::Relaxed) {
            return Vec::new();
        }
        let mut granted = Vec::new();
        for (place, report) in reports.iter().enumerate() {
            let wait = if granted.is_empty() { wait } else { Duration::ZERO };
            let wanted = report.crowded_share > 0.0 && !report.cancelled;
            if wanted && self.patience.take_group(wait + times[place]) {
                granted.push(place);
            }
        }
        granted
    }

    /// The reports, and how long each group took without what was run again because of a neighbour,
    /// which is taken off the patience.
    fn measure_once(
        &mut self,
        groups: Vec<&mut Group<'_>>,
    ) -> Result<Vec<(GroupReport, Duration)>, ProtocolError> {
        let planned = |group: &&mut Group<'_>| group.protocol.planned_ns(group.contestants.len());
        let planned_ns: Vec<u64> = groups.iter().map(planned).collect();
        let all_ns = planned_ns.iter().sum::<u64>().max(1) as f64;
        let shares = planned_ns.iter().map(|ns| *ns as f64 / all_ns);
        let limited = |(group, share): (&&mut Group<'_>, f64)| {
            let protocol = Protocol { guards: self.guards, ..group.protocol.clone() };
            self.patience.limit(&protocol, share)
        };
        let protocols: Vec<Protocol> = groups.iter().zip(shares.clone()).map(limited).collect();
        let with_limits = groups.into_iter().zip(&protocols);
        let limited: Vec<Group<'_>> = with_limits
            .map(|(group, protocol)| Group { contestants: &mut *group.contestants, protocol })
            .collect();
        let start_ns = self.clock.now_ns();
        let reports = self.run(limited)?;
        let time = Duration::from_nanos(self.clock.now_ns().saturating_sub(start_ns));
        let repeated: usize = reports.iter().map(|report| report.repeated_blocks).sum();
        let usual: usize = reports.iter().map(|r| r.trace.len() * r.figures.len()).sum();
        let again = time.mul_f64(repeated as f64 / ((repeated + usual) as f64).max(1.0));
        self.patience.spend(again);
        for (protocol, report) in protocols.iter().zip(&reports) {
            self.keep.take_down(protocol, &report.trace);
        }
        let times = shares.map(|share| (time - again).mul_f64(share));
        Ok(reports.into_iter().zip(times).collect())
    }

    fn run(&mut self, groups: Vec<Group<'_>>) -> Result<Vec<GroupReport>, ProtocolError> {
        let mut done = 0;
        let mut tell = |progress: Progress| {
            (self.progress)(progress.done_blocks.saturating_sub(done));
            done = progress.done_blocks;
        };
        let mut surroundings = Surroundings {
            clock: self.clock,
            disturbance: self.disturbance,
            counters: self.counters,
            forget: self.forget,
            ruler: self.ruler,
            progress: &mut tell,
            cancel: self.cancel,
        };
        measure_groups(groups, &mut surroundings)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::KeepNothing;
    use crate::measure::{
        Chain, NoCounters, Reading, Remember, Role, RoundTrace, ScriptedClock, Undisturbed,
    };
    use crate::table::{Row, TableError};
    use std::cell::Cell;
    use std::rc::Rc;

    /// A neighbour who is there until so many groups were taken down.
    #[derive(Clone)]
    struct Neighbour {
        taken_down: Rc<Cell<usize>>,
        until: usize,
    }

    impl Ruler for Neighbour {
        fn read(&mut self, _clock: &mut dyn Clock) -> Option<Reading> {
            let crowded = self.taken_down.get() < self.until;
            Some(Reading { ns_per_cycle: 1.0, crowded })
        }
    }

    impl Keep for Neighbour {
        fn is_kept(&self, piece: &str) -> bool {
            KeepNothing.is_kept(piece)
        }

        fn hand_out(&mut self, piece: &str) -> Option<Vec<Row>> {
            KeepNothing.hand_out(piece)
        }

        fn hand_out_rest(&mut self) -> Vec<Row> {
            KeepNothing.hand_out_rest()
        }

        fn keep(&mut self, piece: &str, rows: &[Row]) -> Result<(), TableError> {
            KeepNothing.keep(piece, rows)
        }

        fn take_down(&mut self, _protocol: &Protocol, _rounds: &[RoundTrace]) {
            self.taken_down.set(self.taken_down.get() + 1);
        }
    }

    /// Whether each of three groups that take turns was beside a neighbour who leaves after `until` of
    /// them, and how often one was measured.
    fn crowded(until: usize, patience: Patience) -> (Vec<bool>, usize) {
        let mut neighbour = Neighbour { taken_down: Rc::default(), until };
        let job = || Box::new(Chain::new(64));
        let group = |_| [Contestant::new("chain", Role::Subject, job())];
        let mut contestants = [0, 1, 2].map(group);
        let protocol = Protocol { rounds: 8, ..Protocol::new(Order::Literal, 1) };
        let mut groups: Vec<Group<'_>> = contestants
            .iter_mut()
            .map(|contestants| Group { contestants, protocol: &protocol })
            .collect();
        let mut bench = Bench {
            rounds: 8,
            guards: false,
            calls: false,
            patience: &mut patience.clone(),
            clock: &mut ScriptedClock::new(60_000),
            disturbance: &mut Undisturbed,
            counters: &mut NoCounters,
            forget: &mut Remember,
            ruler: &mut neighbour.clone(),
            progress: &mut |_| {},
            cancel: &AtomicBool::new(false),
            keep: &mut neighbour,
        };
        let reports = bench.measure_together(&mut groups).expect("groups that can be measured");
        let crowded = reports.iter().map(|report| report.crowded_share > 0.0).collect();
        (crowded, neighbour.taken_down.get())
    }

    #[test]
    fn groups_beside_a_neighbour_are_measured_again_while_patience_lasts() {
        assert_eq!(crowded(3, Patience::groups(9)), (vec![false; 3], 6));
        // Two of them only; then there is none left.
        assert_eq!(crowded(3, Patience::groups(2)), (vec![false, false, true], 5));
        assert_eq!(crowded(3, Patience::NONE), (vec![true; 3], 3));
        assert_eq!(crowded(0, Patience::groups(9)), (vec![false; 3], 3));
    }
}

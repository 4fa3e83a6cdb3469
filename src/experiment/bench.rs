//! What cells are measured with.

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use super::keep::Keep;
use super::patience::Patience;
use crate::measure::{
    Clock, Contestant, Counters, Disturbance, Forget, GroupReport, Order, Progress, Protocol,
    ProtocolError, Ruler, Surroundings, measure_group,
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
        let protocol = &Protocol { guards: self.guards, ..protocol.clone() };
        let (mut report, group) = self.measure_once(contestants, protocol)?;
        let (mut wait, mut attempts) = (WAIT, 0);
        while report.crowded_share > 0.0
            && !report.cancelled
            && self.patience.take_group(wait + group)
        {
            std::thread::sleep(wait);
            attempts += 1;
            if attempts % FEW_ATTEMPTS == 0 {
                wait = (2 * wait).min(LONGEST_WAIT);
            }
            let (again, _) = self.measure_once(contestants, protocol)?;
            // Never given up for one that was cut short.
            if !again.cancelled {
                report = again;
            }
        }
        Ok(report)
    }

    /// The report, and how long it took without what was run again because of a neighbour, which
    /// is taken off the patience.
    fn measure_once(
        &mut self,
        contestants: &mut [Contestant],
        protocol: &Protocol,
    ) -> Result<(GroupReport, Duration), ProtocolError> {
        let protocol = &self.patience.limit(protocol);
        let start_ns = self.clock.now_ns();
        let report = self.measure_group(contestants, protocol)?;
        let time = Duration::from_nanos(self.clock.now_ns().saturating_sub(start_ns));
        let repeated = report.repeated_blocks as f64;
        let usual = (report.trace.len() * contestants.len()) as f64;
        let again = time.mul_f64(repeated / (repeated + usual).max(1.0));
        self.patience.spend(again);
        self.keep.take_down(protocol, &report.trace);
        Ok((report, time - again))
    }

    fn measure_group(
        &mut self,
        contestants: &mut [Contestant],
        protocol: &Protocol,
    ) -> Result<GroupReport, ProtocolError> {
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
        measure_group(contestants, protocol, &mut surroundings)
    }
}

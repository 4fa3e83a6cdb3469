//! Counters for tests, which count what a script says.

use super::{Counters, Counts, NAMES};
use crate::measure::clock::ScriptedClock;
use std::cell::Cell;
use std::rc::Rc;

/// Counters that follow the time of a [`ScriptedClock`]. So what is counted can be foretold.
#[derive(Clone, Debug)]
pub struct ScriptedCounters {
    time: Rc<Cell<u64>>,
    per_ns: Counts,
    mute: Rc<Cell<bool>>,
    started_ns: Option<u64>,
}

impl ScriptedCounters {
    /// Counters that count `per_ns` in every nanosecond of `clock`.
    pub fn new(clock: &ScriptedClock, per_ns: Counts) -> Self {
        ScriptedCounters { time: clock.time(), per_ns, mute: Rc::default(), started_ns: None }
    }

    /// While true, readings are dropped as if the counters were shared.
    pub fn mute(&self) -> Rc<Cell<bool>> {
        Rc::clone(&self.mute)
    }
}

impl Counters for ScriptedCounters {
    fn start(&mut self) {
        self.started_ns = Some(self.time.get());
    }

    fn stop(&mut self) -> Option<Counts> {
        let passed_ns = self.time.get().saturating_sub(self.started_ns.take()?);
        (!self.mute.get()).then(|| times(self.per_ns, passed_ns))
    }

    fn names(&self) -> Vec<&'static str> {
        NAMES.to_vec()
    }
}

/// `counts`, `times` times; sums that do not fit stay at the highest number.
fn times(counts: Counts, times: u64) -> Counts {
    Counts {
        cycles: counts.cycles.saturating_mul(times),
        instructions: counts.instructions.saturating_mul(times),
        branch_misses: counts.branch_misses.saturating_mul(times),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::Clock;

    const PER_NS: Counts = Counts { cycles: 4, instructions: 9, branch_misses: 1 };

    #[test]
    fn script_follows_the_clock() {
        let mut clock = ScriptedClock::new(0);
        let mut counters = ScriptedCounters::new(&clock, PER_NS);
        let time = clock.time();
        time.set(1000);
        counters.start();
        time.set(1010);
        let counts = Counts { cycles: 40, instructions: 90, branch_misses: 10 };
        assert_eq!((clock.now_ns(), counters.stop()), (1010, Some(counts)));
        assert_eq!(counters.names(), ["cycles", "instructions", "branch-misses"]);
    }

    #[test]
    fn script_tells_nothing_unstarted_or_mute() {
        let mut counters = ScriptedCounters::new(&ScriptedClock::new(0), PER_NS);
        assert_eq!(counters.stop(), None);
        counters.start();
        assert_eq!(counters.stop(), Some(Counts::default()));
        assert_eq!(counters.stop(), None);
        counters.mute().set(true);
        counters.start();
        assert_eq!(counters.stop(), None);
    }
}

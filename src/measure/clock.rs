//! Where time comes from: the system, or in tests a script.

use std::cell::Cell;
use std::rc::Rc;
use std::time::Instant;

/// A clock that does not run backwards.
pub trait Clock {
    /// Nanoseconds since some fixed moment.
    fn now_ns(&mut self) -> u64;

    /// Said before a block of a round is timed: whose it is, and how many tests it does. No matter for a
    /// clock of a machine; one of a script may let pass what it has for them. Of other readings, for a
    /// calibration or a cycle, nothing is said.
    fn announce(&mut self, _id: &str, _tests: u64) {}
}

/// The monotonic clock of the system.
#[derive(Debug)]
pub struct WallClock {
    start: Instant,
}

impl WallClock {
    /// A clock that starts at zero.
    pub fn new() -> Self {
        WallClock { start: Instant::now() }
    }
}

impl Default for WallClock {
    fn default() -> Self {
        Self::new()
    }
}

impl Clock for WallClock {
    fn now_ns(&mut self) -> u64 {
        // 2^64 ns are 584 years.
        self.start.elapsed().as_nanos() as u64
    }
}

/// A clock that stands still unless it is moved: by whoever shares [`ScriptedClock::time`] (a
/// scripted job), and by a fixed step at each reading. So what is measured can be foretold.
#[derive(Clone, Debug, Default)]
pub struct ScriptedClock {
    time: Rc<Cell<u64>>,
    readings: Rc<Cell<u64>>,
    step_ns: u64,
}

impl ScriptedClock {
    /// A clock at zero that each reading moves on by `step_ns`.
    pub fn new(step_ns: u64) -> Self {
        ScriptedClock { step_ns, ..Self::default() }
    }

    /// The time in nanoseconds, to be moved by a script.
    pub fn time(&self) -> Rc<Cell<u64>> {
        Rc::clone(&self.time)
    }

    /// How often the clock was read: odd inside a timed window, even outside.
    pub fn readings(&self) -> Rc<Cell<u64>> {
        Rc::clone(&self.readings)
    }
}

impl Clock for ScriptedClock {
    fn now_ns(&mut self) -> u64 {
        let now = self.time.get();
        self.time.set(now + self.step_ns);
        self.readings.set(self.readings.get() + 1);
        now
    }
}

/// How finely a clock tells time, and what telling costs.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct TimerFigures {
    /// Smallest step seen between two readings, ns; `None` if it never moved.
    pub resolution_ns: Option<u64>,
    /// Time per reading, ns: the smallest mean of 100 in a row.
    pub cost_ns: f64,
}

/// Reads `clock` 20 000 times in 200 rows, of which a neighbour or a switch spoils some: what one
/// reading costs is taken off all others, so that a mean over everything shifted all cycles of a
/// process by a quarter of a per cent.
pub fn timer_figures(clock: &mut dyn Clock) -> TimerFigures {
    const ROWS: u32 = 200;
    const READINGS: u32 = 100;
    let (mut resolution_ns, mut shortest_ns) = (None::<u64>, u64::MAX);
    for _ in 0..ROWS {
        let first = clock.now_ns();
        let mut last = first;
        for _ in 0..READINGS {
            let now = clock.now_ns();
            let step = now.saturating_sub(last);
            if step > 0 {
                resolution_ns = Some(resolution_ns.map_or(step, |r| r.min(step)));
            }
            last = now;
        }
        shortest_ns = shortest_ns.min(last.saturating_sub(first));
    }
    TimerFigures { resolution_ns, cost_ns: shortest_ns as f64 / f64::from(READINGS) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wall_clock_does_not_run_backwards() {
        let mut clock = WallClock::new();
        let first = clock.now_ns();
        assert!(clock.now_ns() >= first);
    }

    #[test]
    fn script_moves_the_clock() {
        let mut clock = ScriptedClock::new(3);
        let time = clock.time();
        assert_eq!(clock.now_ns(), 0);
        time.set(time.get() + 100);
        assert_eq!(clock.now_ns(), 103);
        assert_eq!(clock.readings().get(), 2);
    }

    #[test]
    fn timer_of_a_scripted_clock() {
        let figures = timer_figures(&mut ScriptedClock::new(20));
        assert_eq!(figures, TimerFigures { resolution_ns: Some(20), cost_ns: 20.0 });
        let stuck = timer_figures(&mut ScriptedClock::new(0));
        assert_eq!(stuck, TimerFigures { resolution_ns: None, cost_ns: 0.0 });
    }
}

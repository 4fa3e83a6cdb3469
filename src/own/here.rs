//! A contest on this machine, with its own clock.

use std::sync::atomic::AtomicBool;

use super::contest::{Outcome, OwnError, contest};
use super::entrant::Entrant;
use crate::measure::{
    Counters, HardwareCounters, InvoluntarySwitches, NeighbourRuler, NoCounters, NoRuler, Protocol,
    Remember, Ruler, Surroundings, WallClock, alike_cpus,
};
use crate::registry::busy_kernel;

/// [`contest`] with the system's clock and counters and, as `ray_test run` has it, a look at the core
/// between any two blocks: the calling thread moves between processors, to one that nobody else
/// uses. Takes half a second for that, and about as long for the rounds of a few entrants.
///
/// # Errors
/// As [`contest`].
pub fn contest_here(entrants: &[Entrant], protocol: &Protocol) -> Result<Outcome, OwnError> {
    let mut clock = WallClock::new();
    let mut counters: Box<dyn Counters> = match HardwareCounters::open() {
        Ok(counters) => Box::new(counters),
        Err(_) => Box::new(NoCounters),
    };
    let mut ruler: Box<dyn Ruler> = match busy_kernel() {
        Some(kernel) => Box::new(NeighbourRuler::new(kernel, alike_cpus(), &mut clock)),
        None => Box::new(NoRuler),
    };
    let mut surroundings = Surroundings {
        clock: &mut clock,
        disturbance: &mut InvoluntarySwitches,
        counters: counters.as_mut(),
        forget: &mut Remember,
        ruler: ruler.as_mut(),
        progress: &mut |_| {},
        cancel: &AtomicBool::new(false),
    };
    contest(entrants, protocol, &mut surroundings)
}

//! What measuring needs of this machine, set up once per run.

use super::failure::Failure;
use crate::experiment::{Bench, Distraction, Keep, Patience};
use crate::level::levels;
use crate::measure::{
    Counters, Environment, HardwareCounters, InvoluntarySwitches, NeighbourRuler, NoCounters,
    NoRuler, Pin, Ruler, WallClock, alike_cpus, allowed_cpus, pin,
};
use crate::registry::busy_kernel;
use std::ffi::OsStr;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// Clock, counters and the rest, on the processor that was chosen.
pub struct Instruments {
    clock: WallClock,
    disturbance: InvoluntarySwitches,
    counters: Box<dyn Counters>,
    forget: Distraction,
    ruler: Box<dyn Ruler>,
    /// Groups to be measured again, if the environment tells.
    asked: Option<u32>,
    patience: Patience,
}

impl Instruments {
    /// Sets everything up on the calling thread, and tells where: what of it this machine has is
    /// in the environment.
    ///
    /// # Errors
    /// Usage, for a processor that the thread may not run on, and for a patience that is no number. A
    /// clock that stands still.
    pub fn set_up(wanted: Pin) -> Result<(Self, Environment), Failure> {
        if let (Pin::Cpu(cpu), Ok(allowed)) = (wanted, allowed_cpus())
            && !allowed.contains(&cpu)
        {
            return Err(Failure::Usage(format!(
                "--pin: processor {cpu} is not allowed; allowed: auto, off, or one of {allowed:?}"
            )));
        }
        let asked = patience(std::env::var_os(VARIABLE).as_deref())?;
        let mut clock = WallClock::new();
        // Before the pinning, which would hide the other processors.
        let mut environment = Environment::capture(&mut clock);
        clock_runs(&environment)?;
        let has = |(level, available): (&str, bool)| available.then(|| level.to_owned());
        environment.levels = levels().into_iter().filter_map(has).collect();
        let mut disturbance = InvoluntarySwitches;
        let cpus = match wanted {
            Pin::Auto => alike_cpus(),
            _ => Vec::new(),
        };
        let pinned = pin(wanted, &mut clock, &mut disturbance);
        environment.pinned_cpu = pinned.cpu.filter(|_| cpus.len() < 2);
        environment.pin_note = Some(match cpus.len() {
            0 | 1 => pinned.note,
            _ => format!("before each group to whichever of {cpus:?} has no neighbour"),
        });
        let counters: Box<dyn Counters> = match HardwareCounters::open() {
            Ok(counters) => Box::new(counters),
            Err(_) => Box::new(NoCounters),
        };
        let forget = Distraction::new();
        let ruler: Box<dyn Ruler> = match busy_kernel() {
            Some(kernel) => Box::new(NeighbourRuler::new(kernel, cpus, &mut clock)),
            None => Box::new(NoRuler),
        };
        Ok((
            Instruments {
                clock,
                disturbance,
                counters,
                forget,
                ruler,
                asked,
                patience: asked.map_or(Patience::groups(PATIENCE), of_asked),
            },
            environment,
        ))
    }

    /// The patience of a run of so many rounds; its time is granted experiment by experiment.
    pub fn begin_run(&mut self, rounds: usize) {
        let times = (rounds / 64).max(1) as u32;
        let of_run = Patience { groups: RUN_PATIENCE * times, spare: Some(Duration::ZERO) };
        self.patience = self.asked.map_or(of_run, |groups| of_asked(groups.saturating_mul(times)));
    }

    /// Time for neighbours in an experiment that is this share of a run of so many rounds.
    pub fn grant(&mut self, share: f64, rounds: usize) {
        if self.asked.is_none() {
            self.patience.grant((RUN_SPARE * (rounds / 64).max(1) as u32).mul_f64(share));
        }
    }

    /// A bench for groups of so many rounds, whose rows go to `keep`.
    pub fn bench<'a>(
        &'a mut self,
        rounds: usize,
        progress: &'a mut dyn FnMut(usize),
        cancel: &'a AtomicBool,
        keep: &'a mut dyn Keep,
    ) -> Bench<'a> {
        Bench {
            rounds,
            guards: true,
            calls: true,
            patience: &mut self.patience,
            clock: &mut self.clock,
            disturbance: &mut self.disturbance,
            counters: self.counters.as_mut(),
            forget: &mut self.forget,
            ruler: self.ruler.as_mut(),
            progress,
            cancel,
            keep,
        }
    }
}

/// Refuses a clock that stands still: every calibration would look for blocks that are long enough
/// until it gives up.
fn clock_runs(environment: &Environment) -> Result<(), Failure> {
    if environment.timer.resolution_ns.is_some() {
        return Ok(());
    }
    Err(Failure::Runtime(anyhow::anyhow!(
        "the clock of this system (CLOCK_MONOTONIC) stands still, so that nothing can be timed; \
         what needs no clock can be run: `check`, `stability`, --shard"
    )))
}

/// Environment variable that sets another patience.
const VARIABLE: &str = "RAY_TEST_PATIENCE";
/// Groups that a command other than a run measures again beside a neighbour: some seconds.
const PATIENCE: u32 = 6;
/// The same of all experiments of a run, for every 64 rounds.
const RUN_PATIENCE: u32 = 36;
/// Time for them and for single blocks, for every 64 rounds of a run: a tenth of what a quick one
/// takes, so that it ends within two minutes beside a neighbour as well.
const RUN_SPARE: Duration = Duration::from_secs(10);
/// More would be hours of waiting.
const MOST_PATIENCE: u32 = 1000;

/// With no groups to be measured again, nothing is: nobody looks at the times.
fn of_asked(groups: u32) -> Patience {
    if groups == 0 { Patience::NONE } else { Patience::groups(groups) }
}

/// The patience that the environment asks for; `None` if it does not.
fn patience(asked: Option<&OsStr>) -> Result<Option<u32>, Failure> {
    let Some(text) = asked.filter(|text| !text.is_empty()) else { return Ok(None) };
    let number = text.to_str().and_then(|text| text.trim().parse().ok());
    number.filter(|number| *number <= MOST_PATIENCE).map(Some).ok_or_else(|| {
        let text = text.to_string_lossy();
        Failure::Usage(format!(
            "{VARIABLE}: '{text}'; allowed: a whole number from 0 to {MOST_PATIENCE}"
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patience_is_a_small_whole_number() {
        let asked = |text: &str| patience(Some(OsStr::new(text)));
        assert_eq!(patience(None).expect("usual"), None);
        assert_eq!(asked("").expect("as if it were not set"), None);
        assert_eq!(asked("0").expect("none"), Some(0));
        assert_eq!(asked(" 1000 ").expect("the most"), Some(1000));
        for wrong in ["-1", "1001", "many", "1.5"] {
            let Err(Failure::Usage(message)) = asked(wrong) else { panic!("{wrong} was taken") };
            assert!(message.contains(wrong) && message.contains("allowed"), "{message}");
        }
    }
}

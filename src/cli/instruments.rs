//! What measuring needs of this machine, set up once per run.

use super::failure::Failure;
use crate::experiment::{Bench, Distraction, Keep, Patience};
use crate::level::levels;
use crate::measure::{
    Clock, Counters, Environment, HardwareCounters, InvoluntarySwitches, NeighbourRuler,
    NoCounters, NoRuler, Pin, Ruler, WallClock, alike_cpus, allowed_cpus, cycles_per_ns, pin,
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
    /// clock that stands still, or is far too slow or too fast.
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
        clock_runs(&mut clock, environment.timer.resolution_ns)?;
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

/// Cycles of the chain in a nanosecond, fewest and most. No processor has more than 20: the fastest clocks
/// ever held are below 10 GHz, and where a step took one cycle, not two, it would seem twice as fast. Below
/// 0.01, 10 MHz, is none that has an operating system with such a clock; that leaves room for builds without optimisation,
/// whose steps are many instructions. A clock a thousand times too slow is
/// refused above 20 MHz, one a thousand times too fast below 10 GHz.
const CYCLES_PER_NS: (f64, f64) = (0.01, 20.0);

/// Refuses a clock that stands still, or that runs so slowly or so fast that a chain of known length says
/// that it cannot be right: every calibration would look for blocks that are long enough, for minutes, or
/// until it gives up.
fn clock_runs(clock: &mut dyn Clock, resolution_ns: Option<u64>) -> Result<(), Failure> {
    let refused = |what: String| {
        Err(Failure::Runtime(anyhow::anyhow!(
            "the clock of this system (CLOCK_MONOTONIC) {what}, so that nothing can be timed; what \
             needs no clock can be run: `check`, `stability`, --shard"
        )))
    };
    let Some(resolution_ns) = resolution_ns else { return refused("stands still".to_owned()) };
    let (least, most) = cycles_per_ns(clock, resolution_ns);
    let (fewest, highest) = CYCLES_PER_NS;
    let by_it = |cycles: f64| {
        format!(
            "by it this processor does {cycles:.1e} cycles in a nanosecond, and every one does \
             {fewest} to {highest}"
        )
    };
    if least > highest {
        return refused(format!("is far too slow ({})", by_it(least)));
    }
    if most < fewest {
        return refused(format!("is far too fast ({})", by_it(most)));
    }
    Ok(())
}

/// Environment variable that sets another patience.
const VARIABLE: &str = "RAY_TEST_PATIENCE";
/// Groups that a command other than a run measures again beside a neighbour: some seconds.
const PATIENCE: u32 = 6;
/// The same of all experiments of a run, for every 64 rounds.
const RUN_PATIENCE: u32 = 36;
/// Time for them and for single blocks, for every 64 rounds of a run: a fifteenth of what a quick one
/// takes, so that it ends within two minutes beside a neighbour as well.
const RUN_SPARE: Duration = Duration::from_secs(8);
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
    use crate::measure::ScriptedClock;

    #[test]
    fn a_clock_that_stands_or_is_a_thousand_times_off_is_refused() {
        // A pass of the chain is two million cycles, and as long as the script says.
        let of = |ns: u64, resolution| clock_runs(&mut ScriptedClock::new(ns), resolution);
        // 3 GHz; 100 MHz; and a clock with steps of 10 ms that saw none.
        for (ns, resolution) in [(700_000, 20), (20_000_000, 20), (0, 10_000_000)] {
            assert!(of(ns, Some(resolution)).is_ok(), "{ns}");
        }
        let far = [
            (700_000, None, "stands still"),
            (700, Some(1), "too slow"),
            (700_000_000, Some(20_000), "too fast"),
        ];
        for (ns, resolution, word) in far {
            let Err(Failure::Runtime(error)) = of(ns, resolution) else { panic!("{ns} was taken") };
            assert!(error.to_string().contains(word), "{error}");
        }
    }

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

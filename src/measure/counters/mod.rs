//! What the processor itself counts while a block runs: the interface, and who never tells.

// The crate that reads them knows these processors only; Cargo.toml has the same list.
#[cfg(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "riscv64")
))]
#[path = "linux.rs"]
mod hardware;
#[cfg(not(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "riscv64")
)))]
#[path = "elsewhere.rs"]
mod hardware;
mod scripted;

pub use hardware::HardwareCounters;
pub use scripted::ScriptedCounters;

/// What was counted between a start and a stop, of this thread's own code: neither the system's
/// kernel nor a hypervisor is in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Cycles of the core, at whatever frequency it ran.
    pub cycles: u64,
    /// Instructions that were completed.
    pub instructions: u64,
    /// Branches that were completed and had been predicted wrongly.
    pub branch_misses: u64,
}

/// Something that counts between [`Counters::start`] and [`Counters::stop`]. Both stand outside
/// the two readings of the clock, so what they cost is in no time.
pub trait Counters {
    /// Counts from zero, from now on.
    fn start(&mut self);

    /// What was counted since the last start; `None` if nothing can be told, if the counters were
    /// shared with others meanwhile, or if nothing was started.
    fn stop(&mut self) -> Option<Counts>;

    /// Names of what is counted, in the order of [`Counts`]; empty if nothing ever is.
    fn names(&self) -> Vec<&'static str>;
}

/// Never tells.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoCounters;

impl Counters for NoCounters {
    fn start(&mut self) {}

    fn stop(&mut self) -> Option<Counts> {
        None
    }

    fn names(&self) -> Vec<&'static str> {
        Vec::new()
    }
}

/// The names of [`Counts`], as `perf stat` spells them.
const NAMES: [&str; 3] = ["cycles", "instructions", "branch-misses"];

/// What the system allows of counting without privileges: 2 and less allow a thread to count its
/// own code. `None` where there is no such setting.
pub(super) fn paranoid_level() -> Option<i64> {
    let text = std::fs::read_to_string("/proc/sys/kernel/perf_event_paranoid").ok()?;
    text.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nobody_counts_nothing() {
        let mut counters = NoCounters;
        counters.start();
        assert_eq!((counters.stop(), counters.names()), (None, vec![]));
    }

    #[test]
    fn hardware_counts_or_says_why_not() {
        let mut counters = match HardwareCounters::open() {
            Ok(counters) => counters,
            Err(reason) => {
                assert!(!reason.is_empty());
                println!("skipped: no hardware counters: {reason}");
                return;
            }
        };
        assert_eq!(counters.names().len(), 3);
        counters.start();
        let counts = counters.stop();
        // Another user of the counters may have come between.
        assert!(counts.is_none_or(|counts| counts.instructions > 0));
        assert_eq!(counters.stop(), None);
    }
}

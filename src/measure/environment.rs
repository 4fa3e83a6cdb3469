//! What `environment.json` holds: where, with what and when it was measured.

use super::build_info::BuildInfo;
use super::clock::{Clock, TimerFigures, timer_figures};
use super::counters::{Counters, HardwareCounters, paranoid_level};
use super::date::now_rfc3339;
use super::interference::load_average;
use super::machine::{Machine, list_length};
use serde::{Deserialize, Serialize};
use std::fs::read_to_string;

/// The circumstances of a run. What the system does not tell is `None`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Environment {
    /// Name of the test bed: equal for runs on equal machines ([`Machine::testbed_id`]).
    pub testbed_id: String,
    /// The machine.
    pub machine: Machine,
    /// Instruction-set levels that it has; whoever knows of levels fills this in.
    pub levels: Vec<String>,
    /// Hardware counters that can be read.
    pub counters: Vec<String>,
    /// Why there are none, and what would help; `None` if there are some.
    #[serde(default)]
    pub counters_reason: Option<String>,
    /// What the kernel allows of counting without privileges: the lower, the more; up to 2, a
    /// thread may count its own code.
    #[serde(default)]
    pub perf_event_paranoid: Option<i64>,
    /// The only processor that was measured on; whoever pins fills this in.
    #[serde(default)]
    pub pinned_cpu: Option<usize>,
    /// Why this one, or why none; whoever pins fills this in.
    #[serde(default)]
    pub pin_note: Option<String>,
    /// Who chooses the first processor's frequency, such as `performance`.
    #[serde(default)]
    pub governor: Option<String>,
    /// Whether cores are shared by several logical processors.
    #[serde(default)]
    pub smt: Option<bool>,
    /// Whether the program lies at other addresses in each run.
    #[serde(default)]
    pub aslr: Option<bool>,
    /// Release of the operating system's kernel.
    pub kernel_release: Option<String>,
    /// Name of the operating system as it calls itself.
    pub system_name: Option<String>,
    /// Processors that this process may run on, such as `0-1`.
    pub allowed_cpus: Option<String>,
    /// How many these are.
    pub allowed_cpu_count: Option<usize>,
    /// Resolution and cost of the clock.
    pub timer: TimerFigures,
    /// Mean number of runnable processes over 1, 5 and 15 minutes, at the start.
    pub load_average: Option<[f64; 3]>,
    /// The program.
    pub build: BuildInfo,
    /// Start of the run, RFC 3339 in UTC.
    pub date: String,
}

impl Environment {
    /// Here and now, with `clock` as the timer.
    pub fn capture(clock: &mut dyn Clock) -> Self {
        let machine = Machine::this();
        let trimmed = |path: &str| Some(read_to_string(path).ok()?.trim().to_owned());
        let status = read_to_string("/proc/self/status").unwrap_or_default();
        let allowed_cpus = value_of(&status, "Cpus_allowed_list:");
        let release = read_to_string("/etc/os-release").unwrap_or_default();
        let (counters, counters_reason) = counters();
        Environment {
            testbed_id: machine.testbed_id(),
            machine,
            levels: Vec::new(),
            counters,
            counters_reason,
            perf_event_paranoid: paranoid_level(),
            pinned_cpu: None,
            pin_note: None,
            governor: trimmed("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"),
            smt: trimmed("/sys/devices/system/cpu/smt/active").and_then(|text| flag(&text)),
            aslr: trimmed("/proc/sys/kernel/randomize_va_space")
                .and_then(|level| aslr(&level, trimmed("/proc/self/personality").as_deref())),
            kernel_release: trimmed("/proc/sys/kernel/osrelease"),
            system_name: value_of(&release, "PRETTY_NAME=").map(|n| n.replace('"', "")),
            allowed_cpu_count: allowed_cpus.as_deref().and_then(list_length),
            allowed_cpus,
            timer: timer_figures(clock),
            load_average: trimmed("/proc/loadavg").and_then(|text| load_average(&text)),
            build: BuildInfo::of_this_program(),
            date: now_rfc3339(),
        }
    }
}

/// The rest of the first line that begins with `start`.
fn value_of(text: &str, start: &str) -> Option<String> {
    text.lines().find_map(|line| line.strip_prefix(start)).map(|value| value.trim().to_owned())
}

/// The names of the counters that can be opened; if none can, why.
fn counters() -> (Vec<String>, Option<String>) {
    match HardwareCounters::open() {
        Ok(counters) => (counters.names().into_iter().map(str::to_owned).collect(), None),
        Err(reason) => (Vec::new(), Some(reason)),
    }
}

/// `1` or `0`.
fn flag(text: &str) -> Option<bool> {
    match text {
        "1" => Some(true),
        "0" => Some(false),
        _ => None,
    }
}

/// Whether addresses are random: `level` is the system's setting, 0 for never; `personality` holds
/// this process's exceptions from it as a hexadecimal number, where it can be read.
fn aslr(level: &str, personality: Option<&str>) -> Option<bool> {
    /// `ADDR_NO_RANDOMIZE` of personality(2), which debuggers and `setarch -R` set.
    const NOT_RANDOM: u32 = 0x0004_0000;
    let level: u32 = level.parse().ok()?;
    let exceptions = personality.and_then(|text| u32::from_str_radix(text, 16).ok()).unwrap_or(0);
    Some(level > 0 && exceptions & NOT_RANDOM == 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::ScriptedClock;

    #[test]
    fn parses_what_the_system_prints() {
        let status = "Name:\tx\nCpus_allowed_list:\t0-1\n";
        assert_eq!(value_of(status, "Cpus_allowed_list:").as_deref(), Some("0-1"));
        assert_eq!(value_of(status, "Cpus_allowed:"), None);
    }

    #[test]
    fn flags_are_one_or_zero() {
        assert_eq!((flag("1"), flag("0"), flag("on")), (Some(true), Some(false), None));
    }

    #[test]
    fn addresses_are_random_unless_somebody_says_no() {
        assert_eq!(aslr("2", Some("00000000")), Some(true));
        assert_eq!(aslr("2", Some("00040000")), Some(false));
        assert_eq!(aslr("0", None), Some(false));
        assert_eq!(aslr("1", None), Some(true));
        assert_eq!(aslr("", None), None);
    }

    #[test]
    fn counters_or_a_reason() {
        let environment = Environment::capture(&mut ScriptedClock::new(25));
        assert_eq!(environment.counters.is_empty(), environment.counters_reason.is_some());
    }

    #[test]
    fn capture_names_the_machine_it_describes() {
        let environment = Environment::capture(&mut ScriptedClock::new(25));
        assert_eq!(environment.testbed_id, Machine::this().testbed_id());
        assert_eq!(environment.timer.cost_ns, 25.0);
        assert!(!environment.machine.processor.is_empty());
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn linux_tells() {
        let environment = Environment::capture(&mut ScriptedClock::new(1));
        assert!(environment.kernel_release.is_some());
        assert!(environment.allowed_cpu_count.is_some_and(|n| n >= 1));
        assert!(environment.machine.logical_cpus.is_some_and(|n| n >= 1));
    }

    #[test]
    #[cfg(feature = "cli")]
    fn survives_json() {
        let environment = Environment::capture(&mut ScriptedClock::new(25));
        let text = serde_json::to_string(&environment).expect("writes");
        let back: Environment = serde_json::from_str(&text).expect("reads");
        assert_eq!(back, environment);
    }

    #[test]
    #[cfg(feature = "cli")]
    fn reads_what_older_versions_wrote() {
        let environment = Environment::capture(&mut ScriptedClock::new(25));
        let mut json = serde_json::to_value(&environment).expect("writes");
        let fields = json.as_object_mut().expect("is an object");
        let young = "counters_reason perf_event_paranoid pinned_cpu pin_note governor smt aslr";
        for name in young.split(' ') {
            assert!(fields.remove(name).is_some(), "{name}");
        }
        let back: Environment = serde_json::from_value(json).expect("reads");
        assert_eq!(back.testbed_id, environment.testbed_id);
        assert_eq!((back.counters_reason, back.aslr), (None, None));
    }
}

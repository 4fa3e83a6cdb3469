//! What `environment.json` holds: where, with what and when it was measured.

use super::build_info::BuildInfo;
use super::clock::{Clock, TimerFigures, timer_figures};
use super::date::now_rfc3339;
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
    /// Hardware counters that can be read; whoever knows of counters fills this in.
    pub counters: Vec<String>,
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
        Environment {
            testbed_id: machine.testbed_id(),
            machine,
            levels: Vec::new(),
            counters: Vec::new(),
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

fn load_average(text: &str) -> Option<[f64; 3]> {
    let mut numbers = text.split_whitespace().map(|word| word.parse::<f64>().ok());
    let mut next = || numbers.next().flatten().filter(|n| n.is_finite());
    Some([next()?, next()?, next()?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::ScriptedClock;

    #[test]
    fn parses_what_the_system_prints() {
        assert_eq!(load_average("0.50 1.25 2.00 1/123 456"), Some([0.5, 1.25, 2.0]));
        assert_eq!(load_average("0.50 nan"), None);
        let status = "Name:\tx\nCpus_allowed_list:\t0-1\n";
        assert_eq!(value_of(status, "Cpus_allowed_list:").as_deref(), Some("0-1"));
        assert_eq!(value_of(status, "Cpus_allowed:"), None);
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
}

//! What else the machine did while it was measured.

use super::disturbance::{INVOLUNTARY, VOLUNTARY, switches};
use serde::{Deserialize, Serialize};
use std::fs::read_to_string;

/// What took time away from the calling thread. What the system does not tell is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Interference {
    /// Time for which a hypervisor ran others in place of any processor here, in the system's
    /// ticks: hundredths of a second. Many hypervisors do not report it.
    #[serde(default)]
    pub steal_ticks: Option<u64>,
    /// How often the calling thread had to make room.
    #[serde(default)]
    pub involuntary_switches: Option<u64>,
    /// How often the calling thread waited for something.
    #[serde(default)]
    pub voluntary_switches: Option<u64>,
    /// Mean number of runnable processes over 1, 5 and 15 minutes, at the time of asking.
    #[serde(default)]
    pub load_average: Option<[f64; 3]>,
}

impl Interference {
    /// Counts since the machine and the thread were started, and the load at this moment.
    pub fn now() -> Self {
        let text = |path: &str| read_to_string(path).unwrap_or_default();
        let status = text("/proc/thread-self/status");
        Interference {
            steal_ticks: steal_ticks(&text("/proc/stat")),
            involuntary_switches: switches(&status, INVOLUNTARY),
            voluntary_switches: switches(&status, VOLUNTARY),
            load_average: load_average(&text("/proc/loadavg")),
        }
    }

    /// The counts since `earlier`, asked by the same thread, and the load of `self`.
    pub fn since(&self, earlier: &Self) -> Self {
        // A count that went back (of another thread, or of a faulty hypervisor) tells nothing.
        let grown = |now: Option<u64>, then: Option<u64>| now?.checked_sub(then?);
        Interference {
            steal_ticks: grown(self.steal_ticks, earlier.steal_ticks),
            involuntary_switches: grown(self.involuntary_switches, earlier.involuntary_switches),
            voluntary_switches: grown(self.voluntary_switches, earlier.voluntary_switches),
            load_average: self.load_average,
        }
    }
}

/// The eighth number of the line `cpu` of `/proc/stat`.
fn steal_ticks(stat: &str) -> Option<u64> {
    let line = stat.lines().find_map(|line| line.strip_prefix("cpu "))?;
    line.split_whitespace().nth(7)?.parse().ok()
}

/// The first three numbers of `/proc/loadavg`.
pub(super) fn load_average(text: &str) -> Option<[f64; 3]> {
    let mut numbers = text.split_whitespace().map(|word| word.parse::<f64>().ok());
    let mut next = || numbers.next().flatten().filter(|n| n.is_finite());
    Some([next()?, next()?, next()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steal_is_the_eighth_number_of_all_processors() {
        let stat = "cpu  10 1 20 30 4 0 3 77 5 6\ncpu0 1 1 1 1 1 1 1 9 0 0\nintr 5\n";
        assert_eq!(steal_ticks(stat), Some(77));
        assert_eq!(steal_ticks("cpu0 1 1 1 1 1 1 1 9 0 0\n"), None);
        assert_eq!(steal_ticks("cpu  10 1 20 30\n"), None);
        assert_eq!(steal_ticks(""), None);
    }

    #[test]
    fn load_has_three_numbers() {
        assert_eq!(load_average("0.50 1.25 2.00 1/123 456"), Some([0.5, 1.25, 2.0]));
        assert_eq!(load_average("0.50 nan"), None);
        assert_eq!(load_average(""), None);
    }

    #[test]
    fn difference_keeps_what_both_tell() {
        let earlier = Interference {
            steal_ticks: Some(5),
            involuntary_switches: Some(9),
            voluntary_switches: None,
            load_average: Some([1.0; 3]),
        };
        let later = Interference {
            steal_ticks: Some(7),
            involuntary_switches: Some(8),
            voluntary_switches: Some(3),
            load_average: Some([2.0; 3]),
        };
        let expected = Interference {
            steal_ticks: Some(2),
            load_average: Some([2.0; 3]),
            ..Interference::default()
        };
        assert_eq!(later.since(&earlier), expected);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn linux_tells() {
        let earlier = Interference::now();
        let since = Interference::now().since(&earlier);
        assert!(since.involuntary_switches.is_some() && since.voluntary_switches.is_some());
        assert!(since.load_average.is_some());
    }
}

//! Whether something else ran in our place.

/// A count of disturbances of the calling thread that only grows.
pub trait Disturbance {
    /// The count so far; `None` where the system does not tell.
    fn count(&mut self) -> Option<u64>;
}

/// Involuntary context switches of the calling thread, as Linux counts them.
#[derive(Clone, Copy, Debug, Default)]
pub struct InvoluntarySwitches;

impl Disturbance for InvoluntarySwitches {
    fn count(&mut self) -> Option<u64> {
        // Elsewhere than on Linux there is no such file, and no round is ever called dirty.
        let status = std::fs::read_to_string("/proc/thread-self/status").ok()?;
        involuntary_switches(&status)
    }
}

/// Nothing ever disturbs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Undisturbed;

impl Disturbance for Undisturbed {
    fn count(&mut self) -> Option<u64> {
        None
    }
}

fn involuntary_switches(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|l| l.strip_prefix("nonvoluntary_ctxt_switches:"))?;
    line.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_right_line() {
        let status = "Name:\tx\nvoluntary_ctxt_switches:\t150\nnonvoluntary_ctxt_switches:\t17\n";
        assert_eq!(involuntary_switches(status), Some(17));
        assert_eq!(involuntary_switches("Name:\tx\n"), None);
        assert_eq!(involuntary_switches("nonvoluntary_ctxt_switches:\tmany"), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn linux_tells() {
        assert!(InvoluntarySwitches.count().is_some());
    }
}

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
        switches(&status, INVOLUNTARY)
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

/// Start of the line of a thread's status that counts how often it had to make room.
pub(super) const INVOLUNTARY: &str = "nonvoluntary_ctxt_switches:";

/// Start of the line of a thread's status that counts how often it waited.
pub(super) const VOLUNTARY: &str = "voluntary_ctxt_switches:";

/// The number in the line of `status` that begins with `kind`.
pub(super) fn switches(status: &str, kind: &str) -> Option<u64> {
    status.lines().find_map(|line| line.strip_prefix(kind))?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_right_line() {
        let status = "Name:\tx\nvoluntary_ctxt_switches:\t150\nnonvoluntary_ctxt_switches:\t17\n";
        assert_eq!(switches(status, INVOLUNTARY), Some(17));
        assert_eq!(switches(status, VOLUNTARY), Some(150));
        assert_eq!(switches("Name:\tx\n", INVOLUNTARY), None);
        assert_eq!(switches("nonvoluntary_ctxt_switches:\tmany", INVOLUNTARY), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn linux_tells() {
        assert!(InvoluntarySwitches.count().is_some());
    }
}

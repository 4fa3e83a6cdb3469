//! The processor's own counters, and what to do where there are none.

mod event_group;

use super::{Counters, Counts, NAMES, paranoid_level};
use crate::measure::machine::Machine;
use event_group::EventGroup;
use perf_event::events::Hardware;
use std::hint::black_box;
use std::io;

/// Cycles, instructions and wrongly predicted branches of the thread that opened them.
pub struct HardwareCounters {
    group: EventGroup<3>,
}

impl HardwareCounters {
    /// Opens the counters and tries them once.
    ///
    /// # Errors
    /// Why there are none, and what would help.
    pub fn open() -> Result<Self, String> {
        let events = [Hardware::CPU_CYCLES, Hardware::INSTRUCTIONS, Hardware::BRANCH_MISSES];
        let group = EventGroup::open(events).map_err(|(index, error)| {
            let event = NAMES.get(index).copied().unwrap_or("event");
            let hypervisor = Machine::this().hypervisor;
            format!("{event}: {}", why_not(&error, paranoid_level(), hypervisor))
        })?;
        let mut counters = HardwareCounters { group };
        // Some hypervisors let them be opened, and some processors have too few at once. Three
        // times, as one reading may be dropped by chance.
        if !(0..3).any(|_trial| counters.count()) {
            return Err("the counters open but do not count: a hypervisor holds them back, \
                        or another program (the system's watchdog is one) uses them"
                .to_owned());
        }
        Ok(counters)
    }

    /// Whether a short loop is counted.
    fn count(&mut self) -> bool {
        self.start();
        for step in 0..10_000u32 {
            black_box(step);
        }
        self.stop().is_some_and(|counts| counts.cycles > 0 && counts.instructions > 0)
    }
}

impl Counters for HardwareCounters {
    fn start(&mut self) {
        self.group.start();
    }

    fn stop(&mut self) -> Option<Counts> {
        let [cycles, instructions, branch_misses] = self.group.stop()?;
        Some(Counts { cycles, instructions, branch_misses })
    }

    fn names(&self) -> Vec<&'static str> {
        NAMES.to_vec()
    }
}

/// What the error of an opening means, and what would help.
fn why_not(error: &io::Error, paranoid: Option<i64>, hypervisor: Option<bool>) -> String {
    use io::ErrorKind;
    match (error.kind(), paranoid) {
        (ErrorKind::PermissionDenied, Some(level)) if level > 2 => format!(
            "perf_event_paranoid is {level}, and 2 or less is needed: \
             run `sysctl kernel.perf_event_paranoid=2` as root, or grant CAP_PERFMON"
        ),
        (ErrorKind::PermissionDenied, _) => "the system forbids it, as containers often do: \
             allow perf_event_open there, or run outside"
            .to_owned(),
        // The kernel lacks the call, the processor's driver or this event.
        (ErrorKind::NotFound | ErrorKind::Unsupported, None) => {
            "this kernel was built without events, or a sandbox hides them".to_owned()
        }
        (ErrorKind::NotFound | ErrorKind::Unsupported, Some(_)) if hypervisor == Some(true) => {
            "the hypervisor passes no counters on: switch its virtual PMU on, \
             or run on the bare machine"
                .to_owned()
        }
        (ErrorKind::NotFound | ErrorKind::Unsupported, Some(_)) => {
            "the kernel knows no such counter of this processor".to_owned()
        }
        (ErrorKind::ResourceBusy, _) => "another program uses the counters".to_owned(),
        _ => format!("cannot be opened: {error}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Error, ErrorKind};

    #[test]
    fn reasons_say_what_would_help() {
        let reason = |kind: ErrorKind, paranoid, hypervisor| {
            why_not(&Error::from(kind), paranoid, hypervisor)
        };
        let denied = reason(ErrorKind::PermissionDenied, Some(4), Some(true));
        assert!(denied.contains("perf_event_paranoid is 4, and 2 or less"), "{denied}");
        let contained = reason(ErrorKind::PermissionDenied, Some(2), Some(false));
        assert!(contained.contains("containers"), "{contained}");
        let virtual_machine = reason(ErrorKind::NotFound, Some(2), Some(true));
        assert!(virtual_machine.starts_with("the hypervisor passes no counters on"));
        let bare = reason(ErrorKind::Unsupported, Some(2), Some(false));
        assert!(bare.contains("this processor"), "{bare}");
        assert!(reason(ErrorKind::Unsupported, None, None).contains("without events"));
        assert!(reason(ErrorKind::ResourceBusy, Some(2), None).contains("another program"));
        assert!(reason(ErrorKind::Other, Some(2), None).starts_with("cannot be opened: "));
    }
}

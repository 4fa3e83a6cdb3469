//! Events of Linux that are counted together or not at all.

use perf_event::events::Event;
use perf_event::{Builder, Counter, Group, ReadFormat};
use std::io;
use std::time::Duration;

/// `N` events of the thread that opened them, without what the kernel and a hypervisor do. They
/// count only between a start and a stop, so that the code around the block stays out.
pub(super) struct EventGroup<const N: usize> {
    group: Group,
    /// All but the first event, which is the group itself.
    members: Vec<Counter>,
    counting: bool,
    /// How long the group was enabled without running, up to the last reading.
    lost: Duration,
}

impl<const N: usize> EventGroup<N> {
    /// Opens the events, stopped.
    ///
    /// # Errors
    /// The event that could not be opened, by its place, and why.
    pub(super) fn open<E: Event + Copy>(events: [E; N]) -> Result<Self, (usize, io::Error)> {
        let (&first, others) = events.split_first().ok_or_else(|| {
            (0, io::Error::new(io::ErrorKind::InvalidInput, "a group needs an event"))
        })?;
        let mut leader = builder(first);
        leader.read_format(
            ReadFormat::GROUP
                | ReadFormat::ID
                | ReadFormat::TOTAL_TIME_ENABLED
                | ReadFormat::TOTAL_TIME_RUNNING,
        );
        let mut group = leader.build_group().map_err(|error| (0, error))?;
        let mut members = Vec::with_capacity(others.len());
        for (index, &event) in others.iter().enumerate() {
            let member = builder(event).build_with_group(&mut group);
            members.push(member.map_err(|error| (index + 1, error))?);
        }
        Ok(EventGroup { group, members, counting: false, lost: Duration::ZERO })
    }

    /// Counts from zero, from now on.
    pub(super) fn start(&mut self) {
        // Enabling comes last, so that nothing but the block is counted.
        self.counting = self.group.reset().and_then(|()| self.group.enable()).is_ok();
    }

    /// Stops, and tells the counts in the order of the events; `None` if the group did not run
    /// all the time that it was enabled, after any error, and if nothing was started.
    pub(super) fn stop(&mut self) -> Option<[u64; N]> {
        let stopped = self.group.disable();
        if !std::mem::take(&mut self.counting) {
            return None;
        }
        stopped.ok()?;
        let data = self.group.read().ok()?;
        // A reset zeroes the counts but not the times, which grow as long as the group lives.
        let (enabled, running) = (data.time_enabled()?, data.time_running()?);
        let lost = enabled.saturating_sub(running);
        let lost_before = std::mem::replace(&mut self.lost, lost);
        if !ran_throughout(lost_before, lost, running) {
            return None;
        }
        let counters = std::iter::once(self.group.as_counter()).chain(&self.members);
        let mut counts = [0; N];
        for (count, counter) in counts.iter_mut().zip(counters) {
            *count = data.get(counter)?.value();
        }
        Some(counts)
    }
}

/// Whether a group that by now has run for `running` lost no time since it had lost `lost_before`.
/// One that lost some was taking turns with others, and its counts are a part of the truth.
fn ran_throughout(lost_before: Duration, lost: Duration, running: Duration) -> bool {
    lost == lost_before && !running.is_zero()
}

fn builder<E: Event>(event: E) -> Builder<'static> {
    let mut builder = Builder::new(event);
    builder.observe_self().any_cpu().inherit(false);
    builder.exclude_kernel(true).exclude_hv(true);
    builder
}

#[cfg(test)]
mod tests {
    use super::*;
    use perf_event::events::Software;
    use std::hint::black_box;

    /// Software events stand in for hardware events: the same calls, on every kernel that has
    /// events at all.
    fn clock_and_faults() -> Option<EventGroup<2>> {
        match EventGroup::open([Software::TASK_CLOCK, Software::PAGE_FAULTS]) {
            Ok(group) => Some(group),
            Err((index, error)) => {
                println!("skipped: software event {index} cannot be opened: {error}");
                None
            }
        }
    }

    /// Touches so many fresh pages or more.
    fn touch(pages: usize) {
        black_box(vec![1u8; pages * 4096]);
    }

    #[test]
    fn counts_between_start_and_stop() {
        let Some(mut group) = clock_and_faults() else { return };
        group.start();
        // Above the size from which the allocator asks the system for fresh pages.
        touch(16_384);
        let Some([task_ns, faults]) = group.stop() else { panic!("no counts") };
        assert!(task_ns > 1000, "{task_ns}");
        assert!(faults >= 16, "{faults}");
    }

    #[test]
    fn counts_from_zero_each_time() {
        let Some(mut group) = clock_and_faults() else { return };
        group.start();
        touch(16_384);
        let many = group.stop();
        touch(16_384);
        group.start();
        let few = group.stop();
        let (Some([_, many]), Some([_, few])) = (many, few) else { panic!("no counts") };
        assert!(few < many, "{few} {many}");
    }

    #[test]
    fn nothing_without_a_start() {
        let Some(mut group) = clock_and_faults() else { return };
        assert_eq!(group.stop(), None);
        group.start();
        assert!(group.stop().is_some());
        assert_eq!(group.stop(), None);
    }

    #[test]
    fn shared_counters_are_told_by_the_time_that_is_lost() {
        let [zero, some, more] = [0, 5, 9].map(Duration::from_micros);
        assert!(ran_throughout(zero, zero, more));
        assert!(ran_throughout(some, some, more));
        assert!(!ran_throughout(some, more, more));
        assert!(!ran_throughout(zero, zero, zero));
    }

    #[test]
    fn no_events_are_no_group() {
        let none: [Software; 0] = [];
        assert!(EventGroup::open(none).is_err_and(|(index, _)| index == 0));
    }
}

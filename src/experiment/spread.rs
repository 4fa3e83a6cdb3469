//! Work without a clock, spread over all cores.

use crate::measure::{anywhere, run_anywhere};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The results of `work(0)`, `work(1)` ... `work(count - 1)`, in this order, computed by as many
/// threads as the process may use processors, the one for measuring or not. Never for anything
/// that is timed: this thread waits.
pub fn on_all_cores<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let take = || {
        run_anywhere();
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return done;
            }
            done.push((index, work(index)));
        }
    };
    let mut done: Vec<(usize, T)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..anywhere().min(count)).map(|_| scope.spawn(take)).collect();
        let joined = threads.into_iter().map(|thread| match thread.join() {
            Ok(done) => done,
            // The work's own panic goes on in this thread.
            Err(panic) => std::panic::resume_unwind(panic),
        });
        joined.flatten().collect()
    });
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_piece_is_done_once_and_in_its_place() {
        for count in [0, 1, 2, 1000] {
            let calls = AtomicUsize::new(0);
            let squares = on_all_cores(count, |index| {
                calls.fetch_add(1, Ordering::Relaxed);
                index * index
            });
            assert_eq!(squares, (0..count).map(|index| index * index).collect::<Vec<_>>());
            assert_eq!(calls.into_inner(), count);
        }
    }
}

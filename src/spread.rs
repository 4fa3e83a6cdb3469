//! Work without a clock, spread over all cores.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use crate::measure::{anywhere, run_anywhere};

/// How a piece is watched and stopped.
pub struct Watch<'a> {
    /// Set from outside to stop after the present pieces.
    pub cancel: &'a AtomicBool,
    /// Called, from any thread, with the number of a piece that is done.
    pub done: &'a (dyn Fn(usize) + Sync),
    /// Threads; `None` for one for each processor that the process may use.
    pub threads: Option<usize>,
}

/// Does the pieces 0 to `count` - 1 and gives what came of them in their order, whatever the
/// number of threads; `None` for those that were not done when it was cancelled. The threads run on
/// any processor, the one for measuring or not. Never for anything that is timed: this thread waits.
pub fn pieces<T: Send>(
    count: usize,
    watch: &Watch<'_>,
    piece: impl Fn(usize) -> T + Sync,
) -> Vec<Option<T>> {
    let results: Vec<Mutex<Option<T>>> = (0..count).map(|_| Mutex::new(None)).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        run_anywhere();
        while !watch.cancel.load(Ordering::Relaxed) {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(place) = results.get(index) else { break };
            let result = piece(index);
            if let Ok(mut place) = place.lock() {
                *place = Some(result);
            }
            (watch.done)(index);
        }
    };
    // A panic of a piece goes on in this thread.
    thread::scope(|scope| {
        let threads = watch.threads.unwrap_or_else(anywhere).min(count);
        let start = |_: &usize| thread::Builder::new().spawn_scoped(scope, work).is_ok();
        // Where the system gives no thread, this one does it all.
        if (0..threads).filter(start).count() == 0 {
            work();
        }
    });
    results.into_iter().map(|result| result.into_inner().unwrap_or(None)).collect()
}

/// The results of `work(0)`, `work(1)` ... `work(count - 1)`, in this order.
pub fn on_all_cores<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let never = AtomicBool::new(false);
    let watch = Watch { cancel: &never, done: &|_| {}, threads: None };
    pieces(count, &watch, work).into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_stand_in_order_whatever_the_threads() {
        let cancel = AtomicBool::new(false);
        let done = AtomicUsize::new(0);
        let count = |_: usize| {
            done.fetch_add(1, Ordering::Relaxed);
        };
        for threads in [1, 2, 7] {
            let watch = Watch { cancel: &cancel, done: &count, threads: Some(threads) };
            let squares = pieces(20, &watch, |index| index * index);
            let expected: Vec<Option<usize>> = (0..20).map(|index| Some(index * index)).collect();
            assert_eq!(squares, expected);
        }
        assert_eq!(done.load(Ordering::Relaxed), 60);
    }

    #[test]
    fn what_was_done_before_cancelling_is_kept() {
        let cancel = AtomicBool::new(false);
        let stop = |index: usize| cancel.store(index == 3, Ordering::Relaxed);
        let watch = Watch { cancel: &cancel, done: &stop, threads: Some(1) };
        let kept = pieces(9, &watch, |index| index);
        assert_eq!(kept.iter().flatten().count(), 4);
        assert_eq!(kept[3..5], [Some(3), None]);
    }

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

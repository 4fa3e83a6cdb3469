//! Ctrl-C, or being told to end: the first finishes the present block and saves what was measured,
//! the second ends at once, and so does the first where nothing is there to be saved.

use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};

static CANCEL: AtomicBool = AtomicBool::new(false);
static AT_ONCE: AtomicBool = AtomicBool::new(false);

/// Installs the handler and returns the flag that it sets. Without one (no signals on this
/// system) the flag stays false.
pub fn flag() -> &'static AtomicBool {
    static ONCE: std::sync::Once = std::sync::Once::new();
    ONCE.call_once(listen);
    &CANCEL
}

/// While there is nothing to be saved, the first ends at once, too.
pub fn end_at_once(nothing_to_save: bool) {
    AT_ONCE.store(nothing_to_save, Ordering::Relaxed);
}

fn told() {
    let is_first = !CANCEL.swap(true, Ordering::Relaxed);
    if is_first && AT_ONCE.load(Ordering::Relaxed) {
        let _ = writeln!(std::io::stderr(), "interrupted");
        std::process::exit(130);
    }
    if !is_first {
        std::process::exit(130);
    }
    // Where the terminal has gone, there is nobody to tell; that must not stop the saving.
    let _ = writeln!(std::io::stderr(), "finishing the present block; again to end at once");
}

#[cfg(unix)]
fn listen() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    // Whoever starts it by `nohup` wants it to outlast the terminal.
    let hears = |signal: &i32| *signal != SIGHUP || !is_ignored(*signal);
    let signals: Vec<i32> = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(hears).collect();
    let (registered, when) = std::sync::mpsc::channel();
    let work = move || {
        // In the thread: without one, signals end the program as they always do.
        let Ok(mut signals) = Signals::new(signals) else { return };
        let _ = registered.send(());
        signals.forever().for_each(|_| told());
    };
    // Without a thread, the same.
    let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(work);
    // Until then a signal would still end the program; where there is no thread, this ends as well.
    let _ = when.recv();
}

#[cfg(not(unix))]
fn listen() {
    let _ = ctrlc::set_handler(told);
}

/// Whether the program was started with a signal ignored, where the system tells (Linux).
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    is_in_mask(&status, signal)
}

#[cfg(unix)]
fn is_in_mask(status: &str, signal: i32) -> bool {
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    mask >> (signal - 1) & 1 == 1
}

/// Where files may not become larger (`ulimit -f`), the system ends a program that writes on, in the
/// middle of a file. From now on it tells, as it does where a disk is full.
pub fn let_writes_fail() {
    #[cfg(unix)]
    {
        // A signal that is handled does not end the program; the flag itself tells nothing more.
        let flag = std::sync::Arc::default();
        let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, flag);
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn what_nohup_does_is_seen() {
        let status = |mask: &str| format!("Name:\tray_test\nSigBlk:\tff\nSigIgn:\t{mask}\n");
        assert!(is_in_mask(&status("0000000000001001"), 1));
        assert!(!is_in_mask(&status("0000000000001000"), 1));
        assert!(!is_in_mask("", 1) && !is_in_mask(&status("?"), 1));
    }
}

//! Ctrl-C: the first finishes what is being measured and saves it, the second ends at once.

use std::sync::atomic::{AtomicBool, Ordering};

static CANCEL: AtomicBool = AtomicBool::new(false);

/// Installs the handler and returns the flag that it sets. Without one (no signals on this
/// system) the flag stays false.
pub fn flag() -> &'static AtomicBool {
    // A second call of this function, in one process, leaves the first handler in place.
    let _ = ctrlc::set_handler(|| {
        if CANCEL.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
        eprintln!("finishing the present round; again to end at once");
    });
    &CANCEL
}

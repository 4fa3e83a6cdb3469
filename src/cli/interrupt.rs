//! Ctrl-C, or being told to end: the first finishes the present block and saves what was measured,
//! the second ends at once.

use std::io::Write;
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
        // Where the terminal has gone, there is nobody to tell; that must not stop the saving.
        let _ = writeln!(std::io::stderr(), "finishing the present block; again to end at once");
    });
    &CANCEL
}

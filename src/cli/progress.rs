//! A progress bar with an estimate, on stderr, where that is a terminal.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of `steps`; silent where nobody looks.
pub fn bar(steps: usize) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(steps as u64);
    if let Ok(style) =
        ProgressStyle::with_template("{bar:32} {percent:>3} %  {elapsed}, {eta} left  {msg}")
    {
        bar.set_style(style);
    }
    bar
}

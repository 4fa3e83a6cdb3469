//! What is said on stderr.

/// Says a line on stderr. Where nobody can hear it (a pipe that is closed, a disk that is full) the
/// work goes on: files and the exit code tell what came of it.
macro_rules! say {
    ($($words:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($words)*);
    }};
}

//! What went wrong, and the exit code for it.

use crate::experiment::{KeepError, Trouble};

/// A failure with its exit code.
#[derive(Debug)]
pub enum Failure {
    /// 1: something failed at run time.
    Runtime(anyhow::Error),
    /// 2: wrong usage, config or input; nothing ran.
    Usage(String),
    /// 3: so many figures got worse, and that is confirmed.
    Regressed(usize),
    /// 4: these variants gave a wrong answer where they claim a right one.
    Wrong(Vec<String>),
    /// 4: these kernels gave a wrong answer in a picture, where they claim a right one.
    WrongPicture(Vec<String>),
    /// 130: interrupted; what was measured is saved.
    Interrupted,
    /// 0: whoever read our output has gone.
    Unheard,
}

impl Failure {
    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Failure::Unheard => 0,
            Failure::Runtime(_) => 1,
            Failure::Usage(_) => 2,
            Failure::Regressed(_) => 3,
            Failure::Wrong(_) | Failure::WrongPicture(_) => 4,
            Failure::Interrupted => 130,
        }
    }

    /// Says it on stderr.
    pub fn print(&self) {
        match self {
            Failure::Unheard => {}
            Failure::Runtime(error) => eprintln!("error: {error:#}"),
            Failure::Usage(message) => eprintln!("error: {message}"),
            Failure::Regressed(count) => eprintln!("error: {count} confirmed regressions"),
            Failure::Wrong(ids) => eprintln!(
                "error: a wrong answer, not timed (reasons are in the rows):\n  {}",
                ids.join("\n  ")
            ),
            Failure::WrongPicture(reasons) => eprintln!(
                "error: a wrong answer that rounding does not explain:\n  {}",
                reasons.join("\n  ")
            ),
            Failure::Interrupted => eprintln!("interrupted"),
        }
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        if error.kind() == std::io::ErrorKind::BrokenPipe {
            Failure::Unheard
        } else {
            Failure::Runtime(error.into())
        }
    }
}

impl From<crate::table::TableError> for Failure {
    fn from(error: crate::table::TableError) -> Self {
        Failure::Runtime(error.into())
    }
}

impl From<crate::experiment::RunError> for Failure {
    fn from(error: crate::experiment::RunError) -> Self {
        match *error.trouble {
            Trouble::Keep(KeepError::Changed { .. }) => {
                Failure::Usage(format!("--resume: {error}"))
            }
            _ => Failure::Runtime(error.into()),
        }
    }
}

impl From<crate::experiment::ConfigError> for Failure {
    fn from(error: crate::experiment::ConfigError) -> Self {
        Failure::Usage(error.to_string())
    }
}

impl From<crate::claims::LedgerError> for Failure {
    fn from(error: crate::claims::LedgerError) -> Self {
        Failure::Usage(error.to_string())
    }
}

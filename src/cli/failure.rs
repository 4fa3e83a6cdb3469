//! What went wrong, and the exit code for it.

use crate::experiment::{KeepError, Trouble};
use crate::report::count;

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
            Failure::Runtime(error) => say!("error: {}", with_causes(error)),
            Failure::Usage(message) => say!("error: {message}"),
            Failure::Regressed(number) => {
                say!("error: {}", count(*number, "confirmed regression", "confirmed regressions"));
            }
            Failure::Wrong(ids) => say!(
                "error: a wrong answer, not timed (reasons are in the rows):\n  {}",
                ids.join("\n  ")
            ),
            Failure::WrongPicture(reasons) => say!(
                "error: a wrong answer that rounding does not explain:\n  {}",
                reasons.join("\n  ")
            ),
            Failure::Interrupted => say!("interrupted"),
        }
    }
}

/// An error with its causes, but for those that the words before them have told already.
fn with_causes(error: &anyhow::Error) -> String {
    error.chain().map(|cause| cause.to_string()).fold(String::new(), |text, cause| {
        match (text.is_empty(), text.contains(&cause)) {
            (true, _) => cause,
            (_, true) => text,
            _ => format!("{text}: {cause}"),
        }
    })
}

/// Of printing: what is done with files comes as a [`TableError`](crate::table::TableError), which
/// names the file.
impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        if error.kind() == std::io::ErrorKind::BrokenPipe {
            Failure::Unheard
        } else {
            Failure::Runtime(anyhow::anyhow!(
                "stdout: {error}; what was printed is not whole, print it elsewhere"
            ))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::TableError;

    #[test]
    fn a_cause_is_told_once_and_what_cannot_be_printed_names_its_place() {
        let full = || std::io::Error::from(std::io::ErrorKind::StorageFull);
        let file = "some/rows.csv".into();
        let error = anyhow::Error::from(TableError::Io { file, source: full() });
        let text = with_causes(&error);
        assert!(text.starts_with("some/rows.csv: "), "{text}");
        assert_eq!(text.matches(&full().to_string()).count(), 1, "{text}");
        assert_eq!(with_causes(&anyhow::anyhow!("inner").context("outer")), "outer: inner");
        let printed = Failure::from(full());
        assert!(
            matches!(&printed, Failure::Runtime(error) if error.to_string().starts_with("stdout: "))
        );
        let gone = Failure::from(std::io::Error::from(std::io::ErrorKind::BrokenPipe));
        assert_eq!((printed.code(), gone.code()), (1, 0));
    }
}

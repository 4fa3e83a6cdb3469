//! What can be wrong with an input.

use std::io;

/// What is wrong, where, and what is allowed.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The file cannot be read.
    #[error("{file}: {source}")]
    Io {
        /// The file, or `stdin`.
        file: String,
        /// What the system says.
        source: io::Error,
    },
    /// A line is not what it should be.
    #[error("{file}, line {line}{place}: {message}")]
    Line {
        /// The file, or `stdin`.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// `, column 3 (oz)`, `, field 'oz'`, or nothing.
        place: String,
        /// What is wrong, and what is allowed.
        message: String,
    },
    /// The file as a whole is not what it should be.
    #[error("{file}: {message}")]
    Whole {
        /// The file, or `stdin`.
        file: String,
        /// What is wrong, and what is allowed.
        message: String,
    },
}

//! Why there is no figure.

/// What rows lack for a figure to be computed. It makes a claim undecided, it is no failure.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Lack(String);

impl Lack {
    /// In words that can follow a colon.
    pub fn new(words: impl Into<String>) -> Self {
        Lack(words.into())
    }
}

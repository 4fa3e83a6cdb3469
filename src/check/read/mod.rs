//! Cases and answers from CSV or JSON lines, one at a time.

mod answers;
mod cases;
mod error;
mod json;
mod lines;
mod records;
#[cfg(test)]
mod tests;

pub use answers::{Answered, Answers};
pub use cases::Cases;
pub use error::ReadError;
pub(crate) use records::{Records, Schema};

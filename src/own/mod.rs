//! A kernel of one's own, beside ours: held to the exact answer, and measured by the same protocol.
//!
//! ```text
//! OwnKernel ─> Entrant::own ─┬─ examine ─> Examination   random pairs, stiff families, closed meshes
//! ours ──────> Entrant::ours ┴─ contest ─> Outcome       times, ratios to the reference, verdicts
//! ```
//! Write the test over plain `f32` or `f64` ([`OwnKernel`]); nothing else of this crate needs to be
//! known. [`examine`] reads no clock and gives the same answer everywhere. [`contest`] times what is
//! right about its pairs, in rounds with copies of the reference; what is wrong has no time. Both are
//! text that fits a terminal when they are printed. None of it needs the feature `cli`.

mod contest;
mod entrant;
mod examine;
mod here;
mod kernel;
mod table;
#[cfg(test)]
mod tests;

pub use contest::{Entry, Outcome, OwnError, contest};
pub use entrant::Entrant;
pub use examine::{Examination, FamilyFound, MeshFound, examine};
pub use here::contest_here;
pub use kernel::{Hit, Number, OwnKernel, Ray, Triangle};
pub use table::{examinations, outcome};

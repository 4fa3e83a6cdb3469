//! What a mesh and its rays need of a test, and what can be left out: looked at, measured, proved.
//!
//! ```text
//!  mesh, rays ─> Looks ─┐
//!  default variant on all rays ─> Pilot ─┼─> Situation ─> pieces: needed, or spare ─┐
//!  structures, preparing, timed ─────────┘                                          ├─> Plan ─> proof
//!  forms side by side on a sample ─> Finals ────────────────────────────────────────┘    └─ back ─┘
//! ```
//! A piece is a file in `pieces` and a line in its list. What decides knows nothing of a clock or of
//! the registry: `settle` takes times and a way to ask for answers. [`Task`] brings those.

mod contest;
mod evidence;
mod form;
mod heats;
mod nearby;
mod outcome;
mod paths;
mod piece;
mod pieces;
mod pilot;
mod prepare;
mod proof;
mod rays;
mod run;
mod sample;
mod settle;
mod situation;
mod stages;
#[cfg(test)]
mod tests;
mod usage;

pub use evidence::{Saving, Verdict};
pub use form::{Form, Output};
pub use outcome::{Kept, LeftOut, Plan, Report};
pub use piece::{Look, Piece};
pub use pieces::PIECES;
pub use proof::Answers;
pub use rays::Asking;
pub use run::{Found, Outcome, Task};
pub use settle::Settled;
pub use usage::{Source, Use, Wanted};

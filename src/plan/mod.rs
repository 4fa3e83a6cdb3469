//! What a mesh and its rays need of a test, and what can be left out: looked at, measured, proved.
//!
//! ```text
//!  mesh, rays ─> Looks ─┐
//!  default variant on all rays ─> Pilot ─┼─> Situation ─> pieces: needed, or spare ─┐
//!  structures, preparing, timed ─────────┘                                          ├─> Plan ─> proof
//!  forms on a sample: pairs, heats ─> Finals ───────────────────────────────────────┘    └─ back ─┘
//!                                                             default beside the plan, once more ─┘
//! ```
//! A piece is a file in `pieces` and a line in its list. What decides knows nothing of a clock or of
//! the registry: `settle` takes times and a way to ask for answers. [`Task`] brings those.
//!
//! The rule. A piece that is needed stays. One that is not is left out, unless the pair of forms that
//! differ by it alone says that it is slower without: what cannot be told from noise goes, since less work
//! is less work. Of all forms that do what is needed and are not slower than the default, the plan is the
//! one that does least besides; of several the fastest. A form that does more and is faster all the same
//! is told beside it. The plan is timed beside the default once more after it was chosen, for who comes
//! first of many owes a part of that to chance; where it is slower then, the next one takes its place.
//! Last, its answers on all rays must be as good as the default's, else pieces come back.

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

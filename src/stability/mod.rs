//! Stiff and extreme cases: where each kernel starts to fail.
//!
//! A [`Family`] is a kind of difficulty with a knob. At each setting of it seeded cases are drawn,
//! answered exactly once, and put to every form of every kernel:
//!
//! ```text
//! Family x knob x precision -> cases -> exact answers ─┬─> Measures -> rows -> knees
//!                               registry::asked() ─────┘
//! ```
//!
//! No clock is read. Pieces run on all processors, and the rows are the same bytes whatever the
//! number of threads. A kernel is not blamed for what rounding the inputs does: beside every error
//! stands that of the exact answer to inputs that are off by a rounding.

mod cells;
mod draw;
mod families;
mod family;
mod forms;
mod knee;
mod leaks;
mod mesh;
mod mesh_rays;
mod metamorphic;
mod places;
mod precision;
mod rows;
mod spawned;
mod sweep;
#[cfg(test)]
mod tests;

pub use cells::errors_at;
pub use families::{families, find};
pub use family::Family;
pub use forms::{Form, UnknownForm, forms, known_words};
pub use precision::Precision;
pub use rows::EXPERIMENT;
pub use sweep::{Depth, Outcome, Sweep};

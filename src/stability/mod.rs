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

mod asking;
#[cfg(feature = "cli")]
mod cells;
mod draw;
mod families;
mod family;
#[cfg(feature = "cli")]
mod forms;
#[cfg(feature = "cli")]
mod knee;
mod leaks;
mod limit;
mod mesh;
#[cfg(feature = "cli")]
mod mesh_rays;
#[cfg(feature = "cli")]
mod metamorphic;
#[cfg(feature = "cli")]
mod places;
mod precision;
#[cfg(feature = "cli")]
mod rows;
mod shots;
#[cfg(feature = "cli")]
mod spawned;
#[cfg(feature = "cli")]
mod sweep;
#[cfg(all(test, feature = "cli"))]
mod tests;

#[cfg(feature = "cli")]
pub use cells::errors_at;
pub use families::{families, find};
pub use family::Family;
#[cfg(feature = "cli")]
pub use forms::{Form, UnknownForm, forms, known_words};
pub use precision::Precision;
#[cfg(feature = "cli")]
pub use rows::EXPERIMENT;
#[cfg(feature = "cli")]
pub use sweep::{Depth, Outcome, Sweep};

// What a kernel of one's own is asked, too.
pub(crate) use {
    asking::found,
    draw::Draw,
    family::{MeshKind, Work},
    leaks::Tally as Leaks,
    limit::fails,
    mesh::Mesh,
    shots::{Range, RayClass},
};

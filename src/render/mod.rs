//! Pictures of a mesh by ray tracing, as thesis B's demonstration makes them: with any kernel, for the
//! time that they take and for the rays that the kernel loses.
//!
//! ```text
//! Mesh ─> Stage ─┐
//!                ├─> frame: Rays ─> Tracer ─> colours ─> Picture ─> PNG
//! Manner ────────┘                    │
//!          Searcher (a kernel), Recorder and Replay (no kernel), Compared (with the exact answer)
//! ```
//!
//! A picture depends on which triangles its rays hit and on nothing else: where a ray goes on from a
//! hit follows from the ray and the triangle ([`crate::scene::rays::Spot`]), not from a kernel's t.

mod asking;
mod compare;
mod difference;
mod exact;
mod frame;
mod frame_job;
mod material;
mod paint;
mod picture;
mod replay;
mod shade;
mod stage;
mod subsample;
#[cfg(test)]
mod tests;
mod tracer;

pub use asking::{Ask, AskingLeaf};
pub use compare::{Compared, Count, colour};
pub use difference::{Difference, Way};
pub use exact::Exactly;
pub use frame::{Frame, Manner, frame};
pub use frame_job::{FrameJob, ReplayJob, whole};
pub use material::Material;
pub use picture::Picture;
pub use replay::{Recorder, Recording, Replay};
pub use shade::{Following, Rays};
pub use stage::{Light, Stage};
pub use subsample::{Interpolation, Subsampling};
pub use tracer::{Searcher, Tracer};
